// The node on its topics: two radars and their sites in, tracks, heartbeat and clutter map out.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/TrackerStatus.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/live_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rostest_helpers.h"

namespace {

using tws_runtime::kUnbounded, tws_runtime::waitFor;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kStart = 1000.0;

geometry_msgs::TransformStamped siteOf(const std::string& radar) {
  geometry_msgs::TransformStamped site;
  site.header.frame_id = "map";
  site.child_frame_id = radar;
  site.transform.translation.x = 5000.0;  // Both stand five kilometres east of the origin.
  site.transform.rotation.w = 1.0;
  return site;
}

/// Stands in for the radars sps12 and sps39 that see one aircraft; hears the tracker.
class AditRostest : public testing::Test {
 protected:
  struct Radar {
    std::string name;
    double period;
    ros::Publisher detections, marks;
    std::uint32_t running = 0, count = 0;

    double time(std::uint32_t sector) const { return kStart + period / 64.0 * sector; }
  };

  static void SetUpTestSuite() {
    ros::NodeHandle node;
    radars_ = {{"sps12", 6.0, {}, {}}, {"sps39", 8.0, {}, {}}};
    for (Radar& radar : radars_) {
      radar.detections = node.advertise<tws_msgs::Detections>("/" + radar.name + "/detections", kUnbounded);
      radar.marks = node.advertise<tws_msgs::SectorMark>("/" + radar.name + "/sector_marks", kUnbounded);
    }
    const boost::function<void(const tws_msgs::Tracks::ConstPtr&)> hear = [](const auto& m) { heard_.push_back(*m); };
    const boost::function<void(const tws_msgs::ClutterMap::ConstPtr&)> see = [](const auto& m) { clutter_ = *m; };
    const ros::Subscriber tracks = node.subscribe<tws_msgs::Tracks>("/adit/tracks", kUnbounded, hear);
    const ros::Subscriber clutter = node.subscribe<tws_msgs::ClutterMap>("/adit/clutter_map", kUnbounded, see);
    const boost::function<void(const tws_msgs::TrackerStatus::ConstPtr&)> count = [](const auto& m) {
      skipped_ += m->skipped_sectors;
    };
    const ros::Subscriber status = node.subscribe<tws_msgs::TrackerStatus>("/adit/status", kUnbounded, count);
    subscribers_ = {tracks, clutter, status};
    const ros::Publisher sites = node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    tf2_msgs::TFMessage both;
    both.transforms = {siteOf("sps12"), siteOf("sps39")};
    sites.publish(both);
    const bool is_there = waitFor([&] {
      for (const Radar& radar : radars_) {
        if (radar.detections.getNumSubscribers() == 0 || radar.marks.getNumSubscribers() == 0) return false;
      }
      return sites.getNumSubscribers() > 0 && sendsToUs("/adit", "/adit/tracks") &&
             sendsToUs("/adit", "/adit/clutter_map") && sendsToUs("/adit", "/adit/status");
    });
    if (!is_there) {
      problem_ = "the node is not there";
      return;
    }
    for (Radar& radar : radars_) publishMark(radar, 0);
    fly();
  }

  // What fails before the first test would only skip all tests.
  void SetUp() override { ASSERT_EQ(problem_, ""); }

  static void TearDownTestSuite() {
    subscribers_.clear();
    radars_.clear();
  }

  /// 120 s of data time, as fast as the node takes it. The aircraft is gone after 80 s.
  static void fly() {
    for (;;) {
      Radar& next = nextRadar();
      if (next.time(next.running) > kStart + 120.0) break;
      publishSector(next);
      // Data time must not run ahead of the network: the node answers five sectors of each radar later.
      if (!waitFor([&] { return heard_.size() + 15 >= radars_[0].running + radars_[1].running; })) {
        problem_ = "no answer after " + std::to_string(heard_.size()) + " of " +
                   std::to_string(radars_[0].running + radars_[1].running) + " sectors";
        return;
      }
    }
    if (!waitFor([] { return heard_.size() + 10 >= radars_[0].running + radars_[1].running; }))
      problem_ = "the last sectors are not answered";
  }

  /// The one that is behind.
  static Radar& nextRadar() {
    return radars_[0].time(radars_[0].running) <= radars_[1].time(radars_[1].running) ? radars_[0] : radars_[1];
  }

  /// Of the second run, which begins where the first one did.
  static bool isAnew(const tws_msgs::Tracks& message) { return message.header.stamp.toSec() < kStart + 60.0; }

  static void publishSector(Radar& radar) {
    tws_msgs::Detections sector;
    sector.header.frame_id = radar.name;
    sector.header.stamp = ros::Time(radar.time(radar.running + 1));
    sector.radar = radar.name;
    sector.running_sector = radar.running;
    sector.sector = static_cast<std::uint8_t>(radar.running % 64);
    const double t = radar.time(radar.running) + 0.01;
    if (radar.running % 64 == 10 && t < kStart + 80.0) sector.detections.push_back(aircraftAt(t));
    if (radar.running == 75) spoil(sector);
    radar.detections.publish(sector);
    ++radar.running;
    publishMark(radar, sector.detections.size());
  }

  /// The beam enters the sector `running`.
  static void publishMark(Radar& radar, std::size_t closed_count) {
    tws_msgs::SectorMark mark;
    mark.header.frame_id = radar.name;
    mark.header.stamp = ros::Time(radar.time(radar.running));
    mark.radar = radar.name;
    mark.running_sector = radar.running;
    mark.sector = static_cast<std::uint8_t>(radar.running % 64);
    mark.closed_sector = static_cast<std::uint8_t>((radar.running + 63) % 64);
    mark.closed_count = static_cast<std::uint32_t>(closed_count);
    mark.running_count = radar.count += mark.closed_count;
    mark.rotation_period = radar.period;
    radar.marks.publish(mark);
  }

  /// Due outwards at 200 m/s, seen at the beginning of sector 10.
  static tws_msgs::Detection aircraftAt(double t) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    tws_msgs::Detection d;
    d.stamp = ros::Time(t);
    d.range = 50e3 + 200.0 * (t - kStart);
    d.azimuth = 10.1 * kTwoPi / 64.0;
    d.elevation = d.range_rate = d.range_sigma = d.azimuth_sigma = kNaN;
    d.snr = std::numeric_limits<float>::quiet_NaN();
    return d;
  }

  /// Three detections that make no sense.
  static void spoil(tws_msgs::Detections& sector) {
    tws_msgs::Detection bad = aircraftAt(sector.header.stamp.toSec() - 0.01);
    bad.range = std::numeric_limits<double>::quiet_NaN();
    sector.detections.push_back(bad);
    bad.range = -1.0;
    sector.detections.push_back(bad);
    bad.range = 1000.0;
    bad.azimuth = 7.0;
    sector.detections.push_back(bad);
  }

  static std::vector<tws_msgs::Track> trackWords() {
    std::vector<tws_msgs::Track> updates;
    for (const auto& message : heard_) updates.insert(updates.end(), message.tracks.begin(), message.tracks.end());
    return updates;
  }

  static std::string problem_;
  static std::vector<ros::Subscriber> subscribers_;
  static std::vector<Radar> radars_;
  static std::vector<tws_msgs::Tracks> heard_;
  static tws_msgs::ClutterMap clutter_;
  static std::uint32_t skipped_;
};
std::vector<AditRostest::Radar> AditRostest::radars_;
std::string AditRostest::problem_;
std::vector<ros::Subscriber> AditRostest::subscribers_;
std::vector<tws_msgs::Tracks> AditRostest::heard_;
tws_msgs::ClutterMap AditRostest::clutter_;
std::uint32_t AditRostest::skipped_ = 0;

// If this fails, a consumer that gates on the tracker's heartbeat stalls, or a gap looks like a loss.
TEST_F(AditRostest, SendsOneMessageForEverySectorOfEachRadarInOrder) {
  std::map<std::string, std::uint32_t> next;
  std::uint32_t sequence = 0;
  double last = 0.0;
  for (const auto& message : heard_) {
    EXPECT_EQ(message.tracker, "adit");
    EXPECT_EQ(message.header.frame_id, "map");
    EXPECT_EQ(message.running_sector, next[message.radar]++);
    EXPECT_EQ(message.sector, message.running_sector % 64);
    EXPECT_EQ(message.sequence, sequence++);
    const double period = message.radar == "sps12" ? 6.0 : 8.0;
    EXPECT_NEAR(message.header.stamp.toSec(), kStart + period / 64.0 * message.running_sector, 1e-6);
    EXPECT_GE(message.header.stamp.toSec(), last);
    last = message.header.stamp.toSec();
  }
  EXPECT_EQ(next.size(), 2U);
  EXPECT_GT(next["sps12"], 1270U);
  EXPECT_GT(next["sps39"], 950U);
}

// If this fails, the picture has no aircraft, several for one, or one in the wrong place.
TEST_F(AditRostest, OneAircraftIsOneTrackThatGoesThroughAllStates) {
  std::set<std::uint32_t> uids;
  std::string states;
  for (const auto& track : trackWords()) {
    uids.insert(track.uid);
    const char state = "?tfcd"[track.state];
    if (states.empty() || states.back() != state) states += state;
    if (track.state != tws_msgs::Track::FIRM) continue;
    const double t = track.stamp.toSec() - kStart, range = 50e3 + 200.0 * t, azimuth = 10.1 * kTwoPi / 64.0;
    EXPECT_NEAR(track.range, range, 300.0);
    EXPECT_NEAR(track.azimuth, azimuth, 0.01);
    EXPECT_NEAR(track.position.x, 5000.0 + track.range * std::sin(track.azimuth), 1.0);
    EXPECT_NEAR(track.position.y, track.range * std::cos(track.azimuth), 1.0);
    EXPECT_NEAR(track.speed, 200.0, 40.0);
    EXPECT_NEAR(track.course, azimuth, 0.2);
    EXPECT_TRUE(std::isnan(track.position.z) && std::isnan(track.elevation) && std::isnan(track.height));
    EXPECT_EQ(track.mode_3a, tws_msgs::Track::CODE_UNKNOWN);
    EXPECT_EQ(track.covariance.size(), 16U);
  }
  EXPECT_EQ(uids.size(), 1U);
  EXPECT_EQ(states.substr(0, 3), "tfc");  // In doubt it may show as tentative again.
  EXPECT_EQ(states.back(), 'd');
}

TEST_F(AditRostest, ATrackSaysWhichRadarsSawItAndWhen) {
  bool by_both = false;
  for (const auto& track : trackWords()) {
    ASSERT_EQ(track.radars.size(), track.radar_updates.size());
    by_both = by_both || (track.radars == std::vector<std::string>{"sps12", "sps39"} && track.detection_bits == 3);
    for (const ros::Time& time : track.radar_updates) EXPECT_LE(time, track.last_update);
  }
  EXPECT_TRUE(by_both);
}

// The heartbeat test shows that nothing else was lost; here: nothing was made of them.
TEST_F(AditRostest, BadDetectionsBecomeNeitherTracksNorClutter) {
  for (const auto& track : trackWords()) EXPECT_GT(track.range, 40e3);
  ASSERT_TRUE(waitFor([] { return !clutter_.tracker.empty(); }));
  EXPECT_EQ(clutter_.tracker, "adit");
  for (const auto& point : clutter_.points) EXPECT_GT(point.range, 40e3);
}

// If this fails, a simulation that is started again, or a bag that is played in a loop, meets the old run's tracks.
// After the test of the heartbeat, which counts what was heard so far.
TEST_F(AditRostest, TimeThatGoesBackBeginsANewRun) {
  ASSERT_TRUE(waitFor([] { return !heard_.empty(); }));
  const std::size_t before = heard_.size();
  for (Radar& radar : radars_) {
    radar.running = radar.count = 0;
    radar.period /= 4.0;  // Of such radars more is held back than a tracker may be behind.
    publishMark(radar, 0);
  }
  for (std::size_t sector = 0; sector < 400; ++sector) {
    publishSector(nextRadar());
    // The run is new when several messages of both radars over a second agree; what was held back comes then. Until
    // then nothing tells how far the node is: the messages must come in about the order in which they were sent.
    const bool begun = isAnew(heard_.back());
    if (!begun) ros::WallDuration(0.01).sleep();
    ASSERT_TRUE(waitFor([&] { return heard_.size() - before + (begun ? 15U : 150U) >= sector; }));
  }
  ASSERT_TRUE(waitFor([&] { return heard_.size() - before + 15 >= 400; })) << "nothing of the new run is lost";
  EXPECT_EQ(skipped_, 0U) << "what was held back is no overload";
  // Some words of the old run may have come only now.
  const auto anew = std::find_if(heard_.begin() + static_cast<std::ptrdiff_t>(before), heard_.end(), isAnew);
  ASSERT_NE(anew, heard_.end());
  EXPECT_EQ(anew->running_sector, 0U);
  EXPECT_NEAR(anew->header.stamp.toSec(), kStart, 0.2);
  const auto first_word = std::find_if(anew, heard_.end(), [](const auto& message) { return !message.tracks.empty(); });
  ASSERT_NE(first_word, heard_.end());
  EXPECT_EQ(first_word->tracks[0].uid, 1U) << "the numbers begin anew at 1";
  EXPECT_EQ(first_word->tracks[0].state, tws_msgs::Track::TENTATIVE);
}

/// What the node says with these private parameters, and its exit status.
std::pair<std::string, int> startedWith(const std::string& arguments) {
  const std::string command = "rosrun adit_tracker adit_node __name:=refused " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string said;
  char text[256];
  while (fgets(text, sizeof text, pipe) != nullptr) said += text;
  return {said, WEXITSTATUS(pclose(pipe))};
}

// If this fails, a node with wrong parameters runs all the same, or dies without saying what is wrong.
TEST_F(AditRostest, WrongParametersStopTheNodeWithOneLine) {
  const auto [none, none_status] = startedWith("");
  EXPECT_EQ(none_status, 2);
  EXPECT_EQ(none, "refused: radars: is required and missing\n");
  ros::NodeHandle node;
  XmlRpc::XmlRpcValue radars;
  radars[0]["name"] = "sps12";
  node.setParam("/refused/radars", radars);
  const auto [unknown, status] = startedWith("_capactiy:=5");
  EXPECT_EQ(status, 2);
  EXPECT_EQ(std::count(unknown.begin(), unknown.end(), '\n'), 1) << unknown;
  EXPECT_NE(unknown.find("capactiy"), std::string::npos) << unknown;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "adit_rostest");
  return RUN_ALL_TESTS();
}
