// The node with its radar on a ship that moves, told by /tf.
#include <adit_tracker/adit_node.h>
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "core/ship_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kEpoch = 1000.0;             // data time of the voyage's beginning [s]
constexpr double kEnd = 100.0, kPoses = 0.2;  // [s]
constexpr double kBow = -tws::kPi / 2.0;      // the radar's y axis points along the ship's x axis
constexpr double kForward = 12.0;             // of the ship's origin is the radar [m]
const std::vector<TestBoat> kBoats = {
    {500.0, 1500.0, -4.0, 3.0}, {-900.0, 300.0, 6.0, 2.0}, {1500.0, -200.0, 0.0, 7.0}};

/// The node in one process, and the radar of a ship that this test plays.
class ShipGraph {
 public:
  explicit ShipGraph(const std::string& parameters = "{}") {
    YAML::Node tree = YAML::Load(parameters);
    if (!tree["set"]) tree["set"] = "marine";
    tree["radars"] = YAML::Load("[{name: r, period_s: 2.5, range_sigma_m: 5, azimuth_sigma_deg: 0.5}]");
    if (!tree["own_ship_frame"]) tree["own_ship_frame"] = "ship";
    bus = &graph.addNode("adit", tree);
    node_ = std::make_unique<AditNode>(*bus);
    tws_runtime::Bus& ear = graph.addNode("ear");
    ear.subscribe<tws_msgs::Tracks>("/adit/tracks", [this](const auto& m) { tracks.push_back(m); });
    ear.subscribe<tws_msgs::ClutterMap>("/adit/clutter_map", [this](const auto& m) { clutter = m; });
    geometry_msgs::TransformStamped mount;
    mount.header.frame_id = "ship";
    mount.child_frame_id = "r";
    mount.transform.translation.x = kForward;
    mount.transform.rotation.z = std::sin(kBow / 2.0);
    mount.transform.rotation.w = std::cos(kBow / 2.0);
    radar_.publishStaticTransform(mount);
    graph.drain();
  }

  /// Own ship's pose at a time of the voyage [s].
  void tellPose(double time, const std::string& parent = "map") {
    const Pose radar = ship.at(std::max(time, 0.0));
    const double yaw = tws::kPi / 2.0 - radar.heading;  // of the ship's x axis, anticlockwise from east
    tf2_msgs::TFMessage message;
    geometry_msgs::TransformStamped& pose = message.transforms.emplace_back();
    pose.header.stamp = tws_runtime::toTime(kEpoch + time);
    pose.header.frame_id = parent;
    pose.child_frame_id = "ship";
    pose.transform.translation.x = radar.x - kForward * std::cos(yaw);
    pose.transform.translation.y = radar.y - kForward * std::sin(yaw);
    pose.transform.rotation.z = std::sin(yaw / 2.0);
    pose.transform.rotation.w = std::cos(yaw / 2.0);
    poses_.publish(message);
    graph.drain();
  }

  void send(const tws::RadarSector& sector) {
    tws::RadarSector stamped = sector;
    stamped.enter_time += kEpoch;
    stamped.leave_time += kEpoch;
    for (tws::Plot& plot : stamped.plots) plot.time += kEpoch;
    detections_.publish(tws_runtime::toDetections(stamped, "r", "r"));
    tws_msgs::SectorMark mark;
    mark.header.stamp = tws_runtime::toTime(stamped.leave_time);
    mark.header.frame_id = mark.radar = "r";
    mark.running_sector = static_cast<std::uint32_t>(sector.running + 1);
    mark.sector = static_cast<std::uint8_t>(mark.running_sector % 64);
    mark.closed_sector = static_cast<std::uint8_t>(sector.sector);
    mark.closed_count = static_cast<std::uint32_t>(sector.plots.size());
    mark.rotation_period = 2.5;
    marks_.publish(mark);
    graph.drain();
  }

  /// Sectors and poses; a pose comes so long [s] after its time, and none from `silent` to `again` [s].
  void sail(double late, double silent = 1e9, double again = 1e9, const std::vector<TestBoat>& boats = kBoats) {
    std::mt19937_64 generator(7);
    double next = -kPoses;
    for (const tws::RadarSector& sector : TestShipRadar().see(ship, boats, kEnd, generator)) {
      for (; next + late <= sector.leave_time; next += kPoses)
        if (next < silent || next >= again) tellPose(next);
      send(sector);
    }
  }

  std::uint64_t count(const std::string& counter) { return bus->counter(counter).value(); }

  std::string bytes(std::size_t messages) const {
    std::ostringstream text;
    for (std::size_t i = 0; i < std::min(messages, tracks.size()); ++i) text << tracks[i];
    return text.str();
  }

  TestShip ship;
  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  tws_runtime::Bus* bus = nullptr;
  std::vector<tws_msgs::Tracks> tracks;
  tws_msgs::ClutterMap clutter;

 private:
  tws_runtime::Bus& radar_ = graph.addNode("r");
  tws_runtime::Publisher<tf2_msgs::TFMessage> poses_ = radar_.advertise<tf2_msgs::TFMessage>("/tf");
  tws_runtime::Publisher<tws_msgs::Detections> detections_ = radar_.advertise<tws_msgs::Detections>("~detections");
  tws_runtime::Publisher<tws_msgs::SectorMark> marks_ = radar_.advertise<tws_msgs::SectorMark>("~sector_marks");
  std::unique_ptr<AditNode> node_;
};

/// How many of the boats have a firm track where they are and go, over ground, in the latest messages.
std::size_t boatsShown(const ShipGraph& run) {
  std::map<std::uint32_t, tws_msgs::Track> latest;
  for (const auto& message : run.tracks)
    for (const auto& track : message.tracks) latest[track.uid] = track;
  std::size_t shown = 0;
  for (const TestBoat& boat : kBoats) {
    for (const auto& [uid, track] : latest) {
      if (track.state != tws_msgs::Track::FIRM && track.state != tws_msgs::Track::COASTING) continue;
      const double time = track.stamp.toSec() - kEpoch;
      const bool there = std::hypot(track.position.x - boat.xAt(time), track.position.y - boat.yAt(time)) < 40.0;
      shown += there && std::hypot(track.velocity.x - boat.vx, track.velocity.y - boat.vy) < 2.5;
    }
  }
  return shown;
}

// If this fails, the tracks of a ship's radar lie beside the boats, or go with the ship.
TEST(AditOwnShipNode, TracksAreInTheFixedFrame) {
  ShipGraph run;
  run.sail(0.0);
  EXPECT_EQ(boatsShown(run), kBoats.size());
  EXPECT_EQ(run.tracks.front().header.frame_id, "map");
  EXPECT_EQ(run.log.str(), "");
}

// If this fails, a replay of a ship's recording gives other tracks than the live run did.
TEST(AditOwnShipNode, WhatComesOutDoesNotDependOnWhenAPoseComes) {
  ShipGraph at_once, ahead, late;
  at_once.sail(0.0);
  ahead.sail(-5.0);
  late.sail(0.7);
  const std::size_t common = late.tracks.size();
  EXPECT_GT(common, at_once.tracks.size() - 40U);
  EXPECT_EQ(at_once.bytes(common), ahead.bytes(common));
  EXPECT_EQ(at_once.bytes(common), late.bytes(common));
  EXPECT_EQ(late.count("late poses of own ship"), 0U);
}

// If this fails, the picture stands still with the receiver, or plots are placed by a guess, and nobody is told.
TEST(AditOwnShipNode, AReceiverThatFallsSilentIsCountedAndComesBack) {
  ShipGraph run;
  run.sail(0.0, 50.0, 70.0);
  EXPECT_GT(run.count("late poses of own ship"), 40U);
  EXPECT_NEAR(static_cast<double>(run.count("sectors without own ship's place")), 16.0 / 2.5 * 64.0, 64.0);
  EXPECT_GT(run.count("plots without own ship's place"), 10U);
  EXPECT_NE(run.log.str().find("the pose of ship at"), std::string::npos) << run.log.str();
  EXPECT_EQ(boatsShown(run), kBoats.size());
}

TEST(AditOwnShipNode, PosesThatCannotBeUsedAreNamed) {
  ShipGraph run;
  run.tellPose(0.0);
  run.tellPose(-3.0);
  run.tellPose(1.0, "harbour");
  EXPECT_EQ(run.count("refused poses of own ship"), 2U);
  EXPECT_NE(run.log.str().find("the pose of ship at 997.000000 s does not come after the one before"),
            std::string::npos)
      << run.log.str();
}

// If this fails, a recording of a ship that is played in a loop is tracked only once.
TEST(AditOwnShipNode, ANewRunBeginsWithPosesOfItsOwn) {
  ShipGraph run;
  run.sail(0.0);
  const std::size_t before = run.tracks.size();
  run.sail(0.0);
  EXPECT_GT(run.tracks.size(), before + before / 2);
  EXPECT_EQ(boatsShown(run), kBoats.size());
}

// If this fails, a display draws rocks where they are not, or they go with the ship.
TEST(AditOwnShipNode, ClutterIsToldAsTheRadarSeesItAndStandsOverGround) {
  std::vector<TestBoat> rocks;
  for (int i = 0; i < 12; ++i) rocks.push_back({500.0 + 1500.0 * std::sin(i), 500.0 + 1500.0 * std::cos(i)});
  ShipGraph run("{set: default}");
  run.sail(0.0, 1e9, 1e9, rocks);
  const Pose radar = run.ship.at(run.clutter.header.stamp.toSec() - kEpoch);
  std::size_t known = 0;
  for (const tws_msgs::ClutterPoint& point : run.clutter.points) {
    if (!point.absorbing) continue;
    ++known;
    const double azimuth = point.azimuth + radar.heading;
    const double x = radar.x + point.range * std::sin(azimuth), y = radar.y + point.range * std::cos(azimuth);
    const bool there = std::any_of(rocks.begin(), rocks.end(),
                                   [&](const TestBoat& rock) { return std::hypot(rock.x - x, rock.y - y) < 30.0; });
    EXPECT_TRUE(there) << x << ' ' << y;
  }
  EXPECT_GE(known, 10U);
}

// If this fails, a set that cannot follow own ship starts and loses everything.
TEST(AditOwnShipNode, WhatCannotFollowOwnShipIsRefusedAtTheStart) {
  EXPECT_ANY_THROW(ShipGraph("{clutter: {per_radar: false}}"));
  EXPECT_ANY_THROW(ShipGraph("{iff: [{name: ssr}]}"));
  EXPECT_ANY_THROW(ShipGraph("{clutter_map: map.csv}"));
}

}  // namespace
}  // namespace adit_tracker
