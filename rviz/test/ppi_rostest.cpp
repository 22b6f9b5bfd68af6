// The node on its topics: what it publishes for given input, with its drawn beam at the place of its data time.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kTwoPi = 6.283185307179586;

// Stands in for simulator, tracker and RViz.
class PpiRostest : public testing::Test {
 protected:
  void SetUp() override {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    marks_ = node_.advertise<tws_msgs::SectorMark>("/sps12/sector_marks", 10);
    detections_ = node_.advertise<tws_msgs::Detections>("/sps12/detections", 10);
    tracks_ = node_.advertise<tws_msgs::Tracks>("/adit/tracks", 10);
    for (const char* layer : {"background", "sweep", "detections", "tracks"})
      subscribers_.push_back(
          node_.subscribe<MarkerArray>(std::string("/ppi/") + layer, 100,
                                       [this, layer](const MarkerArray::ConstPtr& array) { keep(layer, *array); }));
    ASSERT_TRUE(waitFor([this] {
      return tracks_.getNumSubscribers() > 0 && marks_.getNumSubscribers() > 0 && detections_.getNumSubscribers() > 0 &&
             clock_.getNumSubscribers() > 0;
    })) << "the node does not subscribe";
  }

  void keep(const std::string& layer, const MarkerArray& array) {
    for (const Marker& marker : array.markers) {
      const auto key = std::make_pair(layer + "/" + marker.ns, marker.id);
      if (marker.action == Marker::DELETE)
        shown_.erase(key);
      else if (marker.action == Marker::ADD)
        shown_[key] = marker;
    }
  }

  // Publishes /clock until the condition holds; false after ten seconds.
  bool waitFor(const std::function<bool()>& condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(10.0);
    while (!condition() && ros::WallTime::now() < end) {
      rosgraph_msgs::Clock clock;
      clock.clock = now_;
      clock_.publish(clock);
      ros::WallDuration(0.02).sleep();
      ros::spinOnce();
    }
    return condition();
  }

  const Marker* find(const std::string& layer, int id = 0) const {
    const auto found = shown_.find({layer, id});
    return found == shown_.end() ? nullptr : &found->second;
  }

  void publishMark() {
    tws_msgs::SectorMark mark;
    mark.header.stamp = now_;
    mark.header.frame_id = "map";
    mark.radar = "sps12";
    mark.sector = 8;
    mark.running_sector = 8;
    mark.rotation_period = 6.0;
    marks_.publish(mark);
  }

  void publishTrack(std::uint8_t state) {
    tws_msgs::Tracks tracks;
    tracks.header.stamp = now_;
    tracks.header.frame_id = "map";
    tracks.tracks.resize(1);
    tws_msgs::Track& track = tracks.tracks[0];
    track.number = 17;
    track.uid = 3;
    track.state = state;
    track.position.x = 50e3;
    track.velocity.x = 100.0;
    track.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
    track.height = std::numeric_limits<double>::quiet_NaN();
    tracks_.publish(tracks);
  }

  ros::NodeHandle node_;
  ros::Publisher clock_, marks_, detections_, tracks_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Time now_{1000.0};
  std::map<std::pair<std::string, int>, Marker> shown_;
};

// The beam is the last line of the sweep: the corner farthest from the middle lies in its direction.
double beamAzimuth(const Marker& sweep) {
  double east = 0.0;
  double north = 0.0;
  for (std::size_t i = sweep.points.size() - 6; i < sweep.points.size(); ++i) {
    east += sweep.points[i].x;
    north += sweep.points[i].y;
  }
  return std::atan2(east, north);
}

TEST_F(PpiRostest, BackgroundIsThere) {
  EXPECT_TRUE(waitFor([this] { return find("background/background") != nullptr; }));
}

// RViz forgets everything when time goes back, at the start of a new run; the rings must come again.
TEST_F(PpiRostest, BackgroundComesAgainForAnRvizThatForgotIt) {
  ASSERT_TRUE(waitFor([this] { return find("background/background") != nullptr; }));
  shown_.clear();
  EXPECT_TRUE(waitFor([this] { return find("background/background") != nullptr; }));
}

// Sector 8 begins at 45 degrees; half a second later a radar of 6 s a turn has gone on by 30.
TEST_F(PpiRostest, TheDrawnBeamIsWhereTheRadarPointsAtThatDataTime) {
  ASSERT_TRUE(waitFor([this] { return find("tracks/tracks") == nullptr; }));
  publishMark();
  now_ += ros::Duration(0.5);
  ASSERT_TRUE(waitFor([this] {
    const Marker* sweep = find("sweep/sweep");
    return sweep != nullptr && sweep->header.stamp == now_;
  }));
  EXPECT_NEAR(beamAzimuth(*find("sweep/sweep")), (45.0 + 30.0) * kTwoPi / 360.0, 1e-3);
}

TEST_F(PpiRostest, DetectionsAppearAndFadeAway) {
  publishMark();
  tws_msgs::Detections sector;
  sector.header.stamp = now_;
  sector.header.frame_id = "map";
  sector.detections.resize(1);
  sector.detections[0].stamp = now_;
  sector.detections[0].range = 100e3;
  sector.detections[0].azimuth = kTwoPi / 4.0;
  detections_.publish(sector);
  ASSERT_TRUE(waitFor([this] { return find("detections/detections") != nullptr; }));
  EXPECT_NEAR(find("detections/detections")->points.at(0).x, 100e3, 2e3);
  EXPECT_NEAR(find("detections/detections")->points.at(0).y, 0.0, 2e3);
  now_ += ros::Duration(12.5);  // More than two scans of 6 s.
  EXPECT_TRUE(waitFor([this] { return find("detections/detections") == nullptr; }));
}

TEST_F(PpiRostest, ATrackShowsItsLabelUntilItIsDropped) {
  const auto labelled = [this] {
    return std::any_of(shown_.begin(), shown_.end(), [](const auto& entry) {
      return entry.first.first == "tracks/tracks labels" && entry.second.text == "17\n194kn";
    });
  };
  // Again and again, as a tracker does: the node may clear the picture of the test before only now.
  EXPECT_TRUE(waitFor([&] {
    publishTrack(tws_msgs::Track::FIRM);
    return labelled();
  }));
  publishTrack(tws_msgs::Track::DROPPED);
  EXPECT_TRUE(waitFor([&] { return !labelled() && find("tracks/tracks") == nullptr; }));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ppi_rostest");
  return RUN_ALL_TESTS();
}
