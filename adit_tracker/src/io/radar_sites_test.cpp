#include "io/radar_sites.h"

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>
#include <utility>
#include <vector>

namespace adit_tracker {
namespace {

using Given = std::vector<std::pair<std::size_t, std::int64_t>>;  // radar and running number

class RadarSitesTest : public testing::Test {
 protected:
  void tell(const std::string& frame, double x) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.child_frame_id = frame;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1.0;
    bus.publishStaticTransform(transform);
    graph.drain();
  }
  void hear(std::size_t radar, const std::string& frame, std::int64_t running) {
    frames[radar] = frame;
    add(sites, radar, running);
  }
  void add(RadarSites& to, std::size_t radar, std::int64_t running) {
    tws::RadarSector sector;
    sector.running = running;
    to.add(radar, sector, [this, radar](const tws::RadarSector& each) { given.emplace_back(radar, each.running); });
  }
  RadarSites make(bool joins) {
    return {bus, "map", {"a", "b"}, joins, {}, [this](std::size_t r) -> const std::string& { return frames[r]; }};
  }

  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  tws_runtime::Bus& bus = graph.addNode("adit");
  std::vector<std::string> frames{2};
  RadarSites sites = make(true);
  Given given;
};

// If this fails, positions count from the radar that happens to be heard first.
TEST_F(RadarSitesTest, ASectorWaitsForTheFirstRadarsSiteAlsoBeforeThatIsHeard) {
  tell("b", 7e3);
  hear(1, "b", 1);
  hear(1, "b", 2);
  EXPECT_EQ(sites.waiting(), 2U);
  tell("a", 5e3);
  hear(1, "b", 3);
  EXPECT_EQ(given, (Given{{1, 1}, {1, 2}, {1, 3}}));
  EXPECT_EQ(sites.origin().x, 5e3);
  EXPECT_EQ(sites.frame(1).x, 2e3);
  EXPECT_EQ(log.str(), "");
}

// If this fails, a radar whose frame is not its name is given up, though its site is known.
TEST_F(RadarSitesTest, TheFirstRadarsFrameMayBeAnotherThanItsName) {
  tell("north/a", 5e3);
  tell("b", 7e3);
  hear(1, "b", 1);
  EXPECT_TRUE(given.empty());
  hear(0, "north/a", 1);
  EXPECT_EQ(given, (Given{{1, 1}, {0, 1}}));
  EXPECT_EQ(sites.origin().x, 5e3);
  EXPECT_EQ(bus.counter("unknown sites").value(), 0U);
}

// If this fails, a first radar that is switched on late stops the others, or stands where they do.
TEST_F(RadarSitesTest, AFirstRadarThatStaysAwayIsWaitedForTwoTurnsAndPlacedWhenItComes) {
  tell("north/a", 5e3);
  tell("b", 7e3);
  const auto most = static_cast<std::int64_t>(RadarSites::kMostWaiting);
  for (std::int64_t i = 0; i < most; ++i) hear(1, "b", i);
  EXPECT_TRUE(given.empty());
  hear(1, "b", most);
  ASSERT_EQ(given.size(), RadarSites::kMostWaiting + 1);
  EXPECT_EQ(given.back(), (std::pair<std::size_t, std::int64_t>{1, most}));
  EXPECT_EQ(bus.counter("unknown sites").value(), 1U);
  EXPECT_EQ(sites.origin().x, 7e3);
  hear(0, "north/a", 1);
  EXPECT_EQ(given.back().first, 0U);
  EXPECT_EQ(sites.frame(0).x, -2e3);
}

TEST_F(RadarSitesTest, WithoutAnyTransformAllStandTogetherAndNoneIsLeftOutOrOvertaken) {
  for (std::int64_t i = 0; i < 200; ++i) hear(i % 2, i % 2 == 0 ? "a" : "b", i);
  ASSERT_EQ(given.size(), 200U);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(given[i].second, static_cast<std::int64_t>(i));
  EXPECT_EQ(bus.counter("unknown sites").value(), 2U);
  EXPECT_EQ(sites.frame(1).x, 0.0);
}

// If this fails, one radar's detections are laid around another's site.
TEST_F(RadarSitesTest, WhoMayNotJoinAndStandsElsewhereIsLeftOutAndNamed) {
  RadarSites one_site = make(false);
  tell("a", 5e3);
  tell("b", 7e3);
  add(one_site, 1, 1);
  add(one_site, 0, 1);
  add(one_site, 1, 2);
  EXPECT_EQ(given, (Given{{0, 1}}));
  EXPECT_EQ(bus.counter("radars at another site").value(), 1U);
  EXPECT_NE(log.str().find("b stands 2000 m from the first radar"), std::string::npos) << log.str();
}

// If this fails, a bag that is played again begins with sectors of the time before.
TEST_F(RadarSitesTest, ANewRunForgetsWhatWaits) {
  hear(0, "a", 1);
  sites.beginNewRun();
  tell("a", 5e3);
  hear(0, "a", 2);
  EXPECT_EQ(given, (Given{{0, 2}}));
}

}  // namespace
}  // namespace adit_tracker
