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

namespace tws_runtime {
namespace {

/// A graph with two radars, of turns of 6 and 8 s, and what comes of them.
class TwoRadars : public ::testing::Test {
 protected:
  explicit TwoRadars(double skew_limit = std::numeric_limits<double>::infinity()) : skew_limit_(skew_limit) {}

  static constexpr double kSectorTimes[2] = {6.0 / 64.0, 8.0 / 64.0};

  template <class M>
  static M messageOf(std::size_t radar, std::uint32_t running, double time) {
    M message;
    message.header.stamp = ros::Time(time);
    message.radar = radar == 0 ? "a" : "b";
    message.running_sector = running;
    message.sector = static_cast<std::uint8_t>(running % 64);
    return message;
  }

  /// A sector's mark, then its detections; their stamps may be off.
  void sendSector(std::size_t radar, std::uint32_t sector, double off = 0.0) {
    const double enter = 1e5 + kSectorTimes[radar] * sector;
    marks[radar].publish(messageOf<tws_msgs::SectorMark>(radar, sector, enter + off));
    detections[radar].publish(messageOf<tws_msgs::Detections>(radar, sector, enter + kSectorTimes[radar] + off));
    graph.drain();
  }
  void send(std::size_t radar, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t sector = from; sector <= to; ++sector) sendSector(radar, sector);
  }
  /// Both radars from one time [s after the epoch] to another, in turns.
  void sendBoth(double from, double to) {
    std::uint32_t next[2] = {};
    for (const std::size_t i : {0u, 1u}) next[i] = static_cast<std::uint32_t>(std::ceil(from / kSectorTimes[i]));
    for (;;) {
      const double times[2] = {kSectorTimes[0] * next[0], kSectorTimes[1] * next[1]};
      const std::size_t first = times[1] < times[0] ? 1 : 0;
      if (times[first] >= to) return;
      sendSector(first, next[first]++);
    }
  }
  std::uint64_t count(const std::string& name) { return listener.counter(name).value(); }

  double skew_limit_;  // [s]
  std::ostringstream log;
  LocalGraph graph{log};
  Bus& radar = graph.addNode("radars");
  Bus& listener = graph.addNode("tracker");
  Publisher<tws_msgs::SectorMark> marks[2] = {radar.advertise<tws_msgs::SectorMark>("/a/sector_marks"),
                                              radar.advertise<tws_msgs::SectorMark>("/b/sector_marks")};
  Publisher<tws_msgs::Detections> detections[2] = {radar.advertise<tws_msgs::Detections>("/a/detections"),
                                                   radar.advertise<tws_msgs::Detections>("/b/detections")};
  std::vector<std::int64_t> given[2];
  int new_runs = 0;
  RadarInputs inputs{listener,
                     {usualTopics("a"), usualTopics("b")},
                     RadarInputs::Options{0.5, 5.0, skew_limit_},
                     [this](std::size_t i, const tws::RadarSector& sector) { given[i].push_back(sector.running); },
                     [this](double) {
                       ++new_runs;
                       given[0].clear();
                       given[1].clear();
                     }};
};

// If this fails, a new run begins once for each radar, or sectors of the old run enter the new one and stop it by their
// times.
TEST_F(TwoRadars, ANewRunBeginsOnceForAllAndOldMessagesOfTheOthersAreLeftOut) {
  sendBoth(0.0, 40.0);
  send(0, 0, 14);
  EXPECT_EQ(new_runs, 0) << "one radar alone may only be late";
  send(1, 0, 8);
  EXPECT_EQ(new_runs, 1);
  send(1, 321, 323);  // Still on their way from the old run.
  send(1, 8, 20);
  send(0, 14, 15);
  EXPECT_EQ(new_runs, 1);
  EXPECT_EQ(given[0].size(), 15u);
  EXPECT_EQ(given[1].size(), 20u);
  EXPECT_EQ(given[1].front(), 0);
}

TEST_F(TwoRadars, ANewRunThatBeginsOnBothInTurnsLosesNothing) {
  sendBoth(0.0, 40.0);
  sendBoth(0.0, 5.0);
  EXPECT_EQ(new_runs, 1);
  EXPECT_EQ(given[0].size(), 53u);
  EXPECT_EQ(given[1].size(), 39u);
}

// If this fails, a recording that is played in a loop is left out by half from its second time on.
TEST_F(TwoRadars, ARecordingInALoopBeginsAnewEachTime) {
  for (int times = 0; times < 4; ++times) {
    sendBoth(0.0, 20.0);
    EXPECT_EQ(given[0].size(), 213u) << times;
    EXPECT_EQ(given[1].size(), 159u) << times;
  }
  EXPECT_EQ(new_runs, 3);
}

// If this fails, a sector whose stamps were damaged on their way, or a radar with a clock of its own, ends all tracks.
TEST_F(TwoRadars, ASectorWithBadStampsEndsNoRun) {
  double time = 0.0;
  for (const double off : {86400.0, -86400.0, 30.0, -30.0}) {
    sendBoth(time, time + 10.0);
    time += 10.0;
    sendSector(0, static_cast<std::uint32_t>(time / kSectorTimes[0]), off);
  }
  sendBoth(time, time + 10.0);
  EXPECT_EQ(new_runs, 0);
  EXPECT_EQ(count("stray messages"), 8u);
  EXPECT_EQ(count("gaps"), 0u);
  EXPECT_EQ(given[0].size(), 533u);
  EXPECT_EQ(given[1].size(), 399u);
}

TEST_F(TwoRadars, OneRadarDoesNotDecideForTheOther) {
  sendBoth(0.0, 40.0);
  for (std::uint32_t i = 0; i < 200; ++i) {
    sendSector(0, 430 + i, -86400.0);
    sendSector(1, 320 + i);
  }
  EXPECT_EQ(new_runs, 0);
  EXPECT_GT(given[1].size(), 510u);
  EXPECT_NE(log.str().find("a/sector_marks"), std::string::npos) << "it is named";
}

/// The same, where a radar must not step a second from the other.
class TwoRadarsInStep : public TwoRadars {
 protected:
  TwoRadarsInStep() : TwoRadars(1.0) {}
};

// If this fails, a radar whose clock steps by seconds makes the other one's sectors late, or nobody says which it was.
TEST_F(TwoRadarsInStep, ARadarWhoseClockStepsIsSetAsideUntilItAgreesAgain) {
  sendBoth(0.0, 20.0);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const double off = i < 100 ? 3.0 : 0.0;
    sendSector(0, 214 + i, off);
    if (i % 4 != 0) sendSector(1, 160 + i - i / 4 - 1);
  }
  EXPECT_EQ(given[1].size(), 309u);
  EXPECT_EQ(count("set aside"), 2u) << "its detections and its marks";
  EXPECT_EQ(count("joined again"), 2u);
  EXPECT_EQ(given[0].back(), 412);
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
  send(0);
  tws_msgs::Detections message;
  message.header.stamp = ros::Time(0.25);
  message.radar = "b";
  detections_.publish(message);
  graph.drain();
  EXPECT_EQ(log.str(), "tracker: bad messages (1): radar 'b', expected 'a' in a/detections at 0.250000 s\n");
  message.radar = "a";
  message.sector = 3;
  message.running_sector = 68;
  detections_.publish(message);
  send(1);
  EXPECT_EQ(count("bad messages"), 2u);
  EXPECT_EQ(sectors.size(), 2u);
}

}  // namespace
}  // namespace tws_runtime
