#include <range_gate_tracker/window_tracker_node.h>

#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/TrackWindows.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <sstream>

#include "window_test_helpers.h"

namespace range_gate_tracker {
namespace {

const Flight kAircraft = straight(20000.0, 30000.0, -150.0, 100.0);

template <class M>
std::string bytesOf(const M& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// The node in one process, its radar 5 km east of the map's origin and turned by a right angle, an operator, a
/// listener.
class Scene {
 public:
  explicit Scene(const std::string& parameters = "{radar: sps12}") {
    tws_runtime::Bus& bus = graph.addNode("outside");
    detections_ = bus.advertise<tws_msgs::Detections>("/sps12/detections");
    marks_ = bus.advertise<tws_msgs::SectorMark>("/sps12/sector_marks");
    bus.subscribe<tws_msgs::OperatorRequest>("window_tracker/operator_requests",
                                             [this](const auto& m) { asked.push_back(m); });
    recorded_ = bus.advertise<tws_msgs::OperatorRequest>("window_tracker/recorded_requests");
    clicks_ = bus.advertise<geometry_msgs::PointStamped>("/clicked_point");
    bus.subscribe<tws_msgs::Tracks>("/tws/tracks", [this](const auto& m) {
      tracks.push_back(m);
      for (const auto& track : m.tracks) last[track.uid] = track;
    });
    bus.subscribe<tws_msgs::TrackWindows>("/tws/windows", [this](const auto& m) { windows.push_back(m); });
    node_ = std::make_unique<WindowTrackerNode>(graph.addNode("window_tracker", YAML::Load(parameters)));
    placeRadar();
  }

  /// `off`: so far are the stamps of the sector's two messages off [s].
  void say(const tws::RadarSector& sector, std::uint32_t plots_before, double off = 0.0) {
    const ros::Time leave = tws_runtime::strayed(tws_runtime::toTime(sector.leave_time), off);
    detections_.publish(tws_runtime::withStrayStamp(tws_runtime::toDetections(sector, "sps12", "sps12"), off));
    tws_msgs::SectorMark mark;
    mark.header.frame_id = mark.radar = "sps12";
    mark.header.stamp = leave;
    mark.running_sector = static_cast<std::uint32_t>(sector.running + 1);
    mark.sector = static_cast<std::uint8_t>(mark.running_sector % 64);
    mark.closed_sector = static_cast<std::uint8_t>(sector.sector);
    mark.closed_count = static_cast<std::uint32_t>(sector.plots.size());
    mark.running_count = plots_before + mark.closed_count;
    mark.rotation_period = TestRadar::kPeriod;
    marks_.publish(mark);
    graph.drain();
  }

  void say(const std::vector<tws::RadarSector>& sectors, std::size_t from = 0, std::size_t to = 1u << 30) {
    std::uint32_t plots = 0;
    for (std::size_t n = 0; n < std::min(to, sectors.size()); ++n) {
      if (n >= from) say(sectors[n], plots);
      plots += static_cast<std::uint32_t>(sectors[n].plots.size());
    }
  }

  /// RViz's Publish Point.
  void click(double x, double y, const std::string& frame = "map") {
    geometry_msgs::PointStamped point;
    point.header.frame_id = frame;
    point.point.x = x;
    point.point.y = y;
    clicks_.publish(point);
    graph.drain();
  }

  void repeat(const tws_msgs::OperatorRequest& request) {
    recorded_.publish(request);
    graph.drain();
  }

  tws_msgs::DropTrack::Response drop(const std::vector<std::uint32_t>& numbers) {
    tws_msgs::DropTrack::Request request;
    tws_msgs::DropTrack::Response response;
    request.numbers = numbers;
    graph.call<tws_msgs::DropTrack>("/tws/drop_track", request, response);
    return response;
  }

  std::uint64_t count(const std::string& name) const {
    for (const auto& reading : graph.counters())
      if (reading.node == "window_tracker" && reading.name == name) return reading.value;
    return 0;
  }

  /// All that was said, as bytes; a replay must give the same.
  std::vector<std::string> bytes() const {
    std::vector<std::string> all;
    for (const auto& message : tracks) all.push_back(bytesOf(message));
    for (const auto& message : windows) all.push_back(bytesOf(message));
    return all;
  }

  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  std::vector<tws_msgs::Tracks> tracks;
  std::vector<tws_msgs::TrackWindows> windows;
  std::vector<tws_msgs::OperatorRequest> asked;
  std::map<std::uint32_t, tws_msgs::Track> last;  // update of each track

 private:
  void placeRadar() {
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "sps12";
    site.transform.translation.x = 5000.0;
    site.transform.rotation.z = site.transform.rotation.w = std::sqrt(0.5);  // its east is the map's north
    graph.addNode("sites").publishStaticTransform(site);
    graph.drain();
  }

  tws_runtime::Publisher<tws_msgs::Detections> detections_;
  tws_runtime::Publisher<tws_msgs::SectorMark> marks_;
  tws_runtime::Publisher<geometry_msgs::PointStamped> clicks_;
  tws_runtime::Publisher<tws_msgs::OperatorRequest> recorded_;
  std::unique_ptr<WindowTrackerNode> node_;
};

/// Of the radar's plane in the map: turned by a right angle, 5 km east.
Eigen::Vector2d inMap(const Eigen::Vector2d& place) { return {5000.0 - place.y(), place.x()}; }

TEST(WindowTrackerNode, SaysEverySectorAndTheAircraftAtItsPlaceInTheMap) {
  Scene scene;
  scene.say(TestRadar::sectors({kAircraft}, 10));
  ASSERT_GE(scene.tracks.size(), 639U);
  ASSERT_EQ(scene.windows.size(), scene.tracks.size());
  for (std::size_t n = 0; n < scene.tracks.size(); ++n) {
    EXPECT_EQ(scene.tracks[n].running_sector, n);
    EXPECT_EQ(scene.tracks[n].sequence, n);
    EXPECT_EQ(scene.windows[n].windows.size(), scene.tracks[n].tracks.size());
  }
  ASSERT_EQ(scene.last.size(), 1U);
  const tws_msgs::Track& track = scene.last.begin()->second;
  EXPECT_EQ(track.state, tws_msgs::Track::FIRM);
  const double t = tws_runtime::toSeconds(track.stamp);
  EXPECT_NEAR(track.range, kAircraft(t).norm(), 1.0);
  EXPECT_NEAR(track.position.x, inMap(kAircraft(t)).x(), 1.0);
  EXPECT_NEAR(track.position.y, inMap(kAircraft(t)).y(), 1.0);
  EXPECT_NEAR(track.velocity.x, -100.0, 0.1);
  EXPECT_NEAR(track.velocity.y, -150.0, 0.1);
  ASSERT_EQ(track.radars.size(), 1U);
  EXPECT_EQ(track.radars[0], "sps12");
}

TEST(WindowTrackerNode, SaysTheWindowTheTypeAndThePriority) {
  Scene scene;
  scene.say(TestRadar::sectors({kAircraft}, 10));
  tws_msgs::TrackWindow window;
  for (const auto& message : scene.windows)
    for (const auto& w : message.windows) window = w;
  EXPECT_EQ(window.kind, tws_msgs::TrackWindow::TRACKING);
  EXPECT_EQ(window.type, tws_msgs::TrackWindow::TYPE_AIRCRAFT);
  EXPECT_EQ(window.hits, 10);
  EXPECT_GE(window.priority, 1);
  EXPECT_LE(window.priority, 2);
  EXPECT_NEAR(window.range, kAircraft(window.expected.toSec()).norm(), 10.0);
  EXPECT_GT(window.half_range, 300.0);
}

const char* const kManual = "{radar: sps12, automatic: false}";

TEST(WindowTrackerNode, TracksWhatTheOperatorClicksOn) {
  Scene scene(kManual);
  const auto sectors = TestRadar::sectors({kAircraft}, 15);
  scene.say(sectors, 0, 130);
  EXPECT_TRUE(scene.last.empty());
  const Eigen::Vector2d place = inMap(kAircraft(12.0));
  scene.click(place.x() + 300.0, place.y() - 300.0);
  scene.say(sectors, 130);
  ASSERT_EQ(scene.last.size(), 1U);
  EXPECT_EQ(scene.last.begin()->second.state, tws_msgs::Track::FIRM);
  ASSERT_EQ(scene.asked.size(), 1U);
  EXPECT_EQ(scene.asked[0].request, tws_msgs::OperatorRequest::INITIATE);
  EXPECT_EQ(scene.asked[0].position.x, place.x() + 300.0);
  EXPECT_EQ(scene.asked[0].radar, "sps12");
}

// The marker may stand in the radar's own frame.
TEST(WindowTrackerNode, TakesAPointInAnyKnownFrame) {
  Scene scene(kManual);
  const auto sectors = TestRadar::sectors({kAircraft}, 15);
  scene.say(sectors, 0, 130);
  scene.click(kAircraft(12.0).x(), kAircraft(12.0).y(), "sps12");
  scene.say(sectors, 130);
  EXPECT_EQ(scene.last.size(), 1U);
  EXPECT_EQ(scene.last.begin()->second.state, tws_msgs::Track::FIRM);
}

TEST(WindowTrackerNode, DropsWhatTheOperatorCancels) {
  Scene scene;
  const auto sectors = TestRadar::sectors({kAircraft}, 15);
  scene.say(sectors, 0, 640);
  const std::uint32_t number = scene.last.begin()->second.number;
  const auto answer = scene.drop({number, 99});
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.message, "there is no track 99");
  scene.say(sectors, 640, 642);
  EXPECT_EQ(scene.last.begin()->second.state, tws_msgs::Track::DROPPED) << "it takes effect at once";
  ASSERT_EQ(scene.asked.size(), 2U);
  EXPECT_EQ(scene.asked[0].request, tws_msgs::OperatorRequest::DROP);
  EXPECT_EQ(scene.asked[0].result, tws_msgs::OperatorRequest::OK);
  EXPECT_EQ(scene.asked[1].result, tws_msgs::OperatorRequest::REFUSED);
  scene.say(sectors, 642, 900);
  EXPECT_TRUE(scene.drop({}).success);
  scene.say(sectors, 900);
  EXPECT_EQ(scene.asked.back().request, tws_msgs::OperatorRequest::DROP_ALL);
}

/// A run with requests, and what was asked.
struct Session {
  std::vector<std::string> bytes;
  std::vector<tws_msgs::OperatorRequest> asked;
};

const std::vector<Flight> kTraffic{kAircraft, straight(-40000.0, 0.0, 200.0, 0.0), straight(0.0, -30000.0, 0.0, 90.0)};

Session liveSession() {
  Scene scene(kManual);
  const auto sectors = TestRadar::sectors(kTraffic, 15);
  scene.say(sectors, 0, 100);
  for (const Flight& flight : kTraffic) scene.click(inMap(flight(9.0)).x(), inMap(flight(9.0)).y());
  scene.say(sectors, 100, 500);
  scene.drop({1});
  scene.say(sectors, 500);
  return {scene.bytes(), scene.asked};
}

// If this fails, a recorded incident cannot be looked at again.
TEST(WindowTrackerNode, RepeatsARunFromTheRecordedRequestsByteByByte) {
  const Session live = liveSession();
  ASSERT_EQ(live.asked.size(), 4U);
  Scene replay(kManual);
  for (const auto& request : live.asked) replay.repeat(request);
  replay.say(TestRadar::sectors(kTraffic, 15));
  EXPECT_EQ(replay.bytes(), live.bytes);
  ASSERT_EQ(replay.asked.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(bytesOf(replay.asked[i]), bytesOf(live.asked[i])) << i;
  EXPECT_EQ(replay.count("late recorded requests"), 0U);
  EXPECT_EQ(replay.count("requests repeated with another effect"), 0U);
}

TEST(WindowTrackerNode, CountsRequestsThatComeTooLateOrMakeNoSense) {
  Scene replay;
  const auto sectors = TestRadar::sectors(kTraffic, 4);
  replay.say(sectors, 0, 200);
  tws_msgs::OperatorRequest request;
  request.tracker = "window_tracker";
  request.radar = "sps12";
  request.request = tws_msgs::OperatorRequest::DROP;
  request.track = 77;
  request.running_sector = 100;
  replay.repeat(request);
  request.radar = "other";
  replay.repeat(request);
  replay.say(sectors, 200);
  EXPECT_EQ(replay.count("late recorded requests"), 1U);
  EXPECT_EQ(replay.count("refused requests"), 1U);  // there is no track 77

  Scene scene;
  scene.click(1000.0, 1000.0);  // before the first sector
  scene.say(sectors, 0, 100);
  scene.click(std::numeric_limits<double>::quiet_NaN(), 0.0);
  scene.click(1000.0, 1000.0, "nowhere");
  EXPECT_EQ(scene.count("refused requests"), 3U);
  EXPECT_TRUE(scene.asked.empty());
}

// If this fails, a sector whose stamps were damaged on their way, in detections and mark alike, costs all tracks.
TEST(WindowTrackerNode, StrayStampsLoseNoTrack) {
  for (const double off : tws_runtime::kStrays) {
    Scene scene;
    const auto sectors = TestRadar::sectors({kAircraft}, 10);
    scene.say(sectors, 0, 400);
    scene.say(sectors[400], 0, off);
    scene.say(sectors, 401);
    EXPECT_GE(scene.tracks.size(), 639U) << off;
    EXPECT_EQ(scene.count("new runs"), 0U);
    EXPECT_EQ(scene.count("stray messages"), 2U);
    EXPECT_EQ(scene.last.size(), 1U);
    EXPECT_EQ(scene.last.begin()->second.state, tws_msgs::Track::FIRM);
  }
}

// If this fails, a bag played twice shows the aircraft of the first time.
TEST(WindowTrackerNode, BeginsAnewWhenTimeGoesBack) {
  Scene scene;
  scene.say(TestRadar::sectors({kAircraft}, 10));
  const std::size_t first = scene.tracks.size();
  scene.say(TestRadar::sectors({kAircraft}, 10));
  EXPECT_EQ(scene.count("new runs"), 1U);
  EXPECT_GE(scene.tracks.size(), 2 * first - 2);
  std::size_t dropped = 0;
  for (const auto& message : scene.tracks)
    for (const auto& track : message.tracks) dropped += track.state == tws_msgs::Track::DROPPED;
  EXPECT_EQ(dropped, 0U);
}

TEST(WindowTrackerNode, RefusesParametersThatMakeNoSense) {
  const auto complaint = [](const std::string& parameters) {
    try {
      Scene scene(parameters);
    } catch (const tws_runtime::ParameterError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint("{}").find("radar"), std::string::npos);
  EXPECT_NE(complaint("{radar: a, gate: 3}").find("gate"), std::string::npos);
  EXPECT_NE(complaint("{radar: a, air_speed_mps: 1}").find("air_speed"), std::string::npos);
  EXPECT_NE(complaint("{radar: a, filter: {kind: alpha_beta, beta: 3.5}}").find("alpha"), std::string::npos);
}

}  // namespace
}  // namespace range_gate_tracker
