// The tracker with clutter that it was told of.
#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

class AditClutter : public BothSets {
 protected:
  /// Twenty rocks and an aircraft.
  static std::vector<TestTarget> scene() {
    std::vector<TestTarget> targets = {{60e3, 20e3, -200.0, 0.0}};
    for (int i = 0; i < 20; ++i) {
      const double azimuth = tws::radians(18.0 * i + 5.0), range = 10e3 + 2e3 * i;
      targets.push_back({range * std::sin(azimuth), range * std::cos(azimuth), 0.0, 0.0});
    }
    return targets;
  }

  static bool isRock(const RecordedUpdate& update) {
    return update.kinematics.y < 19e3 || update.kinematics.y > 21e3 || update.kinematics.x < 0.0;
  }

  static std::size_t startedByRocks(const Listener& listener) {
    const auto started = listener.of(TrackEvent::kStarted);
    return static_cast<std::size_t>(std::count_if(started.begin(), started.end(), isRock));
  }

  std::vector<ClutterPlace> learned(double time) const {
    Listener listener(params());
    feedInOrder(listener.adit, twoRadars(time, scene()));
    return listener.adit.clutter().places();
  }
};

// If this fails, a tracker that knows the place from yesterday begins with a picture full of rocks.
TEST_P(AditClutter, AMapLearnedBeforeKeepsRocksFromStartingTracks) {
  const auto map = learned(120.0);
  const std::size_t maps = params().clutter.per_radar ? 2U : 1U;
  EXPECT_GE(map.size(), 20U * maps);
  Listener bare(params()), knowing(params());
  knowing.adit.manual().load({map, {}});
  for (Listener* listener : {&bare, &knowing}) feedInOrder(listener->adit, twoRadars(60.0, scene()));
  EXPECT_GE(startedByRocks(bare), 20U);
  // The clutter map runs three sectors ahead: with a common map, the second radar's first three are not mapped.
  EXPECT_LE(startedByRocks(knowing), params().clutter.per_radar ? 0U : 1U);
  EXPECT_EQ(knowing.confirmed().size(), 1U) << "the aircraft";
}

// The map that was loaded, and not one that was learned: nothing is seen there for 30 s.
TEST_P(AditClutter, ASavedMapLoadedAndSavedAgainIsTheSame) {
  const auto map = learned(120.0);
  Listener listener(params());
  listener.adit.manual().load({map, {}});
  feedInOrder(listener.adit, twoRadars(30.0, {}));
  EXPECT_EQ(listener.adit.clutter().places(), map);
}

/// The sectors that close after `from` and not after `to` [s].
RadarSectors between(RadarSectors radars, double from, double to) {
  const auto outside = [&](const tws::RadarSector& sector) {
    return sector.leave_time <= from || sector.leave_time > to;
  };
  for (auto& sectors : radars) sectors.erase(std::remove_if(sectors.begin(), sectors.end(), outside), sectors.end());
  return radars;
}

// 40 s from then; the map looks after a point once a turn of the radar, three sectors before its tracks.
TEST_P(AditClutter, WhatIsLoadedInMidRunIsKeptFromThenOn) {
  Listener listener(params());
  const RadarSectors radars = twoRadars(120.0, {});
  feedInOrder(listener.adit, between(radars, 0.0, 50.0));
  EXPECT_EQ(listener.adit.manual().load({{{"", 30e3, 1.0}, {"r1", 40e3, 1.0}}, {}}), 0U);
  const std::size_t maps = params().clutter.per_radar ? 2U : 1U;
  feedInOrder(listener.adit, between(radars, 50.0, 88.0));
  EXPECT_EQ(listener.adit.clutter().places().size(), maps + 1U);
  feedInOrder(listener.adit, between(radars, 88.0, 99.5));
  EXPECT_TRUE(listener.adit.clutter().places().empty());
}

INSTANTIATE_TEST_SUITE_P(Sets, AditClutter, testing::Values("default", "nrl7952"));

std::size_t pointsOf(const AditParams& params, const std::vector<ClutterPlace>& places) {
  Listener listener(params);
  listener.adit.manual().load({places, {}});
  const TestRadar radar(6.0);
  addAndProcess(listener.adit, 0, radar.sectors(0.0, 0.2)[0]);
  addAndProcess(listener.adit, 1, radar.sectors(0.0, 0.2)[0]);
  listener.adit.finish();
  std::size_t points = 0;
  for (const ClutterMap& map : listener.adit.clutter().maps()) points += map.size();
  return points;
}

// What each radar knows of one reflector is one point of a common map; a point of all radars is one in each radar's
// own.
TEST(AditClutterKinds, AMapOfOneKindIsLoadedIntoTheOther) {
  const AditParams own = paramsFor("default", {6.0, 6.0}), common = paramsFor("nrl7952", {6.0, 6.0});
  const std::vector<ClutterPlace> one_reflector = {{"r0", 30e3, 1.0}, {"r1", 30.1e3, 1.001}};
  EXPECT_EQ(pointsOf(own, one_reflector), 2U);
  EXPECT_EQ(pointsOf(common, one_reflector), 1U);
  EXPECT_EQ(pointsOf(common, {{"r0", 30e3, 1.0}, {"r1", 35e3, 1.0}}), 2U);
  EXPECT_EQ(pointsOf(own, {{"", 30e3, 1.0}}), 2U);
  EXPECT_EQ(pointsOf(own, {{"", 30e3, 1.0}, {"r1", 30e3, 1.0}}), 2U);
}

/// Scans of two radars with 200 false plots in a patch.
RadarSectors patch(double to) {
  auto generator = tws::seededGenerator();
  RadarSectors radars;
  for (const double period : {6.0, 8.0}) {
    radars.push_back(TestRadar(period).sectors(0.0, to));
    for (tws::RadarSector& sector : radars.back()) {
      const auto number = sector.running % tws::kSectors;
      for (int i = 0; i < 25 && number >= 8 && number < 16; ++i) {
        tws::Plot& plot = sector.plots.emplace_back();
        plot.time = sector.enter_time;
        plot.range = tws::uniform(generator, 20e3, 50e3);
        plot.azimuth = (static_cast<double>(number) + tws::uniform(generator, 0.0, 1.0)) * tws::kSectorWidth;
      }
    }
  }
  return radars;
}

// If this fails, a tracker that knows the place from yesterday begins with the tracks that its rain starts.
TEST(AditClutterKinds, WhatWasLearnedOfFalsePlotsIsKnownBeforeTheFirst) {
  Listener before(paramsFor("default", {6.0, 8.0})), knowing(paramsFor("default", {6.0, 8.0}));
  EXPECT_TRUE(before.adit.radars().counts().empty());
  feedInOrder(before.adit, patch(100.0));
  knowing.adit.manual().load({{}, before.adit.radars().counts()});
  for (std::size_t radar = 0; radar < 2; ++radar) {
    const auto there = [&](const Listener& listener) {
      return listener.adit.radars().quality(radar).falsePlotMap().density(35e3, 12.0 * tws::kSectorWidth);
    };
    EXPECT_NEAR(there(knowing), there(before), 0.5 * there(before));
    EXPECT_LT(there(Listener(paramsFor("default", {6.0, 8.0}))), 0.5 * there(before));
  }
}

TEST(AditClutterKinds, WhatMakesNoSenseOfARadarKeepsThePointsOut) {
  Listener listener(paramsFor("default", {6.0, 6.0}));
  RadarCounts of_another;
  of_another.radar = "r7";
  EXPECT_THROW(listener.adit.manual().load({{{"", 30e3, 1.0}}, {of_another}}), std::invalid_argument);
  feedInOrder(listener.adit, {TestRadar(6.0).sectors(0.0, 20.0), TestRadar(6.0).sectors(0.0, 20.0)});
  EXPECT_TRUE(listener.adit.clutter().places().empty());
}

TEST(AditClutterKinds, PlacesThatMakeNoSenseAreRefusedAsAWhole) {
  Listener listener(paramsFor("default", {6.0, 6.0}));
  const double nan = std::nan("");
  for (const ClutterPlace& bad :
       {ClutterPlace{"r7", 1e3, 1.0}, {"", nan, 1.0}, {"", -1.0, 1.0}, {"", 1e3, nan}, {"", 1e3, 6.3}, {"", 1e8, 1.0}})
    EXPECT_THROW(listener.adit.manual().load({{{"", 30e3, 1.0}, bad}, {}}), std::invalid_argument);
  EXPECT_TRUE(listener.adit.clutter().places().empty());
}

}  // namespace
}  // namespace adit_tracker
