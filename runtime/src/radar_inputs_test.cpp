#include <tws_runtime/radar_inputs.h>

#include <gtest/gtest.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/local_graph.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "radar_joins.h"

namespace tws_runtime {
namespace {

SectorDetections detectionsOf(std::uint32_t sector, double sector_time) {
  SectorDetections detections;
  detections.running = sector;
  detections.leave_time = sector_time * (sector + 1);
  return detections;
}

SectorCrossing markOf(std::uint32_t entered, double sector_time) {
  SectorCrossing mark;
  mark.running = entered;
  mark.time = sector_time * entered;
  return mark;
}

/// Two radars with turns of 6 and 8 s and what comes of them.
class RadarJoinsTest : public ::testing::Test {
 protected:
  static constexpr double kSectorTimes[2] = {6.0 / 64.0, 8.0 / 64.0};

  void send(std::size_t radar, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t sector = from; sector <= to; ++sector) {
      joins.add(radar, markOf(sector, kSectorTimes[radar]));
      joins.add(radar, detectionsOf(sector, kSectorTimes[radar]));
    }
  }

  std::vector<std::int64_t> given[2];
  int new_runs = 0;
  std::map<std::string, int> faults;
  RadarJoins joins{
      2, SectorJoin::Options(),
      RadarJoins::Events{[this](std::size_t radar, tws::RadarSector sector) { given[radar].push_back(sector.running); },
                         [this](double) {
                           ++new_runs;
                           given[0].clear();
                           given[1].clear();
                         },
                         [this](std::size_t, const std::string& counter, const std::string&) { ++faults[counter]; }}};
};

// If this fails, a new run begins once for each radar, or sectors of the old run enter the new one and stop it by their
// times.
TEST_F(RadarJoinsTest, ANewRunBeginsOnceForAllAndOldMessagesOfTheOthersAreDropped) {
  send(0, 0, 400);
  send(1, 0, 300);
  send(0, 0, 10);
  EXPECT_EQ(new_runs, 1);
  send(1, 301, 303);  // Still on their way from the old run.
  EXPECT_EQ(given[1].size(), 0u);
  EXPECT_EQ(faults["messages of the old run"], 6);
  send(1, 0, 20);
  EXPECT_EQ(new_runs, 1);
  EXPECT_EQ(given[0].size(), 10u);
  EXPECT_EQ(given[1].size(), 20u);
  EXPECT_EQ(given[1].front(), 0);
  EXPECT_EQ(faults["stray messages"], 1);
}

TEST_F(RadarJoinsTest, TheNewRunMayBeginOnBothRadarsInTurns) {
  send(0, 0, 400);
  send(1, 0, 300);
  for (std::uint32_t sector = 0; sector < 50; ++sector) {
    send(0, sector, sector);
    send(1, sector, sector);
  }
  EXPECT_EQ(new_runs, 1);
  EXPECT_EQ(given[0].size(), 49u);
  EXPECT_EQ(given[1].size(), 49u);
}

// If this fails, a radar that had ended early in the old run, or comes late in the new one, is shut out of the new one.
TEST_F(RadarJoinsTest, ARadarThatIsBehindInTheNewRunIsHeardAgain) {
  send(0, 0, 1000);
  send(1, 0, 100);
  send(0, 0, 990);
  send(1, 700, 720);
  EXPECT_EQ(new_runs, 1);
  EXPECT_EQ(given[1].size(), 20u);
}

/// A graph with a radar "a" that this test plays, and a listener.
class RadarInputsTest : public ::testing::Test {
 protected:
  void send(std::uint32_t sector, const std::vector<tws_msgs::Detection>& detections = {}) {
    tws_msgs::Detections message;
    message.header.stamp = ros::Time(0.125 * (sector + 1));
    message.header.frame_id = "a_site";
    message.radar = "a";
    message.sector = static_cast<std::uint8_t>(sector % 64);
    message.running_sector = sector;
    message.detections = detections;
    detections_.publish(message);
    tws_msgs::SectorMark mark;
    mark.header = message.header;
    mark.radar = "a";
    mark.sector = static_cast<std::uint8_t>((sector + 1) % 64);
    mark.running_sector = sector + 1;
    mark.closed_count = static_cast<std::uint32_t>(detections.size());
    marks_.publish(mark);
    graph.drain();
  }

  static tws_msgs::Detection plotAt(double range, double azimuth) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    tws_msgs::Detection detection;
    detection.stamp = ros::Time(0.1);
    detection.range = range;
    detection.azimuth = azimuth;
    detection.elevation = detection.range_rate = detection.range_sigma = detection.azimuth_sigma = unknown;
    return detection;
  }

  std::uint64_t count(const std::string& name) { return listener.counter(name).value(); }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& radar = graph.addNode("a");
  Bus& listener = graph.addNode("tracker");
  Publisher<tws_msgs::Detections> detections_ = radar.advertise<tws_msgs::Detections>("~detections");
  Publisher<tws_msgs::SectorMark> marks_ = radar.advertise<tws_msgs::SectorMark>("~sector_marks");
  std::vector<tws::RadarSector> sectors;
  RadarInputs inputs{listener,
                     {usualTopics("a")},
                     RadarInputs::Options(),
                     [this](std::size_t, tws::RadarSector sector) { sectors.push_back(std::move(sector)); },
                     [](double) {}};
};

TEST_F(RadarInputsTest, SectorsComeFromTheTwoTopicsWithTheSitesFrame) {
  EXPECT_EQ(inputs.frame(0), "");
  send(0, {plotAt(1000.0, 0.05), plotAt(2000.0, 0.06)});
  send(1);
  ASSERT_EQ(sectors.size(), 2u);
  EXPECT_EQ(sectors[0].plots.size(), 2u);
  EXPECT_EQ(sectors[0].plots[1].range, 2000.0);
  EXPECT_EQ(inputs.frame(0), "a_site");
  EXPECT_EQ(count("sectors"), 2u);
  EXPECT_EQ(count("detections"), 2u);
  EXPECT_EQ(log.str(), "");
}

// If this fails, a bad plot takes its whole sector with it, spoils the tracker, or is dropped in silence.
TEST_F(RadarInputsTest, ABadPlotIsNamedAndTheOthersOfItsSectorStay) {
  send(0, {plotAt(1000.0, std::nan("")), plotAt(-5.0, 0.06), plotAt(3000.0, 0.07)});
  ASSERT_EQ(sectors.size(), 1u);
  ASSERT_EQ(sectors[0].plots.size(), 1u);
  EXPECT_EQ(sectors[0].plots[0].range, 3000.0);
  EXPECT_EQ(count("bad detections"), 2u);
  EXPECT_EQ(count("count mismatches"), 0u);
  EXPECT_EQ(log.str(), "tracker: bad detections (1): azimuth is nan in a/detections at 0.100000 s\n");
}

TEST_F(RadarInputsTest, MessagesOfAnotherRadarOrWithAWrongSectorAreRefusedAndNamed) {
  tws_msgs::Detections message;
  message.radar = "b";
  detections_.publish(message);
  graph.drain();
  EXPECT_EQ(log.str(), "tracker: bad messages (1): radar 'b', expected 'a' in a/detections at 0.000000 s\n");
  message.radar = "a";
  message.sector = 3;
  message.running_sector = 68;
  detections_.publish(message);
  send(0);
  EXPECT_EQ(count("bad messages"), 2u);
  EXPECT_EQ(sectors.size(), 1u);
}

}  // namespace
}  // namespace tws_runtime
