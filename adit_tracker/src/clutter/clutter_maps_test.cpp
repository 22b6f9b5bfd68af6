#include "clutter/clutter_maps.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

class ClutterMapsTest : public testing::Test {
 protected:
  AditParams params_ = paramsFor("default", {6.0, 8.0});
  AditCounts counts_;
  Radars radars_{params_};
};

TEST_F(ClutterMapsTest, EachRadarHasItsOwnMapOrAllHaveOne) {
  EXPECT_EQ(ClutterMaps(params_, radars_, counts_).maps().size(), 2U);
  params_.clutter.per_radar = false;
  EXPECT_EQ(ClutterMaps(params_, radars_, counts_).maps().size(), 1U);
}

// If this fails, clutter that a file names is loaded into maps whose radars it cannot be judged for, or never.
TEST_F(ClutterMapsTest, PlacesWaitForTheFirstSectorOfTheirRadar) {
  ClutterMaps clutter(params_, radars_, counts_);
  EXPECT_EQ(clutter.load({{"r1", 20e3, 1.0}, {"", 30e3, 2.0}}, 0.0), 0U);
  EXPECT_EQ(clutter.maps()[1].size(), 0U);
  EXPECT_TRUE(clutter.loadAwaited(1, 5.0));
  EXPECT_FALSE(clutter.loadAwaited(1, 5.0));
  EXPECT_EQ(clutter.maps()[0].size(), 0U);
  EXPECT_EQ(clutter.maps()[1].size(), 2U);
  EXPECT_TRUE(clutter.loadAwaited(0, 5.0));
  EXPECT_EQ(clutter.maps()[0].size(), 1U);
  const auto places = clutter.places();
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0].radar, "r0");
  EXPECT_EQ(places[1].range, 20e3);  // by azimuth
}

TEST_F(ClutterMapsTest, RefusesAPlaceThatCannotBe) {
  ClutterMaps clutter(params_, radars_, counts_);
  EXPECT_THROW(clutter.load({{"r0", -5.0, 1.0}}, 0.0), std::invalid_argument);
  EXPECT_FALSE(clutter.loadAwaited(0, 5.0));
}

TEST_F(ClutterMapsTest, CountsPointsForWhichThereIsNoNumber) {
  params_.clutter.capacity = 2;  // of which one can be used
  ClutterMaps clutter(params_, radars_, counts_);
  tws::Plot plot;
  plot.time = 1.0;
  plot.range = 20e3;
  plot.azimuth = 1.0;
  clutter.initiate(plot, 0);
  EXPECT_EQ(counts_.refused_clutter, 0U);
  clutter.initiate(plot, 0);
  EXPECT_FALSE(clutter.adopt(20e3, 1.0, 1.0, 0));
  EXPECT_EQ(counts_.refused_clutter, 2U);
}

}  // namespace
}  // namespace adit_tracker
