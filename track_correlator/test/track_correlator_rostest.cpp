// Both nodes over roscpp: SSR plots and primary tracks in, one correlated track out.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/live_test_helpers.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using tws_runtime::kUnbounded, tws_runtime::waitFor;

constexpr double kStart = 1000.0, kSectorTime = 0.1;
constexpr double kRange = 40e3, kAzimuth = 1.02;  // in sector 10

/// Stands in for the radar "ssr" and for the primary tracker; one aircraft stands still.
class Station {
 public:
  Station() {
    plots_ = node_.advertise<tws_msgs::SsrPlots>("/ssr/plots", kUnbounded);
    marks_ = node_.advertise<tws_msgs::SectorMark>("/ssr/sector_marks", kUnbounded);
    tracks_ = node_.advertise<tws_msgs::Tracks>("/adit/tracks", kUnbounded);
    sites_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    const boost::function<void(const tws_msgs::CorrelatedTracks::ConstPtr&)> on_message = [this](const auto& m) {
      published.push_back(*m);
    };
    picture_ = node_.subscribe<tws_msgs::CorrelatedTracks>("/correlated/tracks", kUnbounded, on_message);
    tf2_msgs::TFMessage sites;
    sites.transforms.resize(1);
    sites.transforms[0].header.frame_id = "map";
    sites.transforms[0].child_frame_id = "ssr";
    sites.transforms[0].transform.rotation.w = 1.0;
    sites_.publish(sites);
  }

  bool connected() const {
    return plots_.getNumSubscribers() > 0 && marks_.getNumSubscribers() > 0 && tracks_.getNumSubscribers() > 0 &&
           picture_.getNumPublishers() > 0;
  }

  /// All that is said of sector n.
  void publish(std::uint32_t n) {
    const ros::Time enter(kStart + n * kSectorTime), leave(kStart + (n + 1) * kSectorTime);
    tws_msgs::SsrPlots plots;
    plots.header.frame_id = plots.radar = "ssr";
    plots.header.stamp = leave;
    plots.running_sector = n;
    plots.sector = static_cast<std::uint8_t>(n % 64);
    tws_msgs::Tracks tracks;
    tracks.header.stamp = enter;
    tracks.header.frame_id = "map";
    tracks.running_sector = tracks.sequence = n;
    tracks.sector = plots.sector;
    if (n % 64 == 10) {
      plots.plots.push_back(plot(enter));
      tracks.tracks.push_back(primary(enter));
    }
    tws_msgs::SectorMark mark;
    mark.header.stamp = leave;
    mark.radar = "ssr";
    mark.running_sector = n + 1;
    mark.sector = static_cast<std::uint8_t>((n + 1) % 64);
    plots_.publish(plots);
    tracks_.publish(tracks);
    marks_.publish(mark);
  }

  std::vector<tws_msgs::CorrelatedTracks> published;

 private:
  static tws_msgs::SsrPlot plot(ros::Time time) {
    tws_msgs::SsrPlot plot;
    plot.stamp = time + ros::Duration(0.04);
    plot.range = kRange;
    plot.azimuth = kAzimuth;
    plot.height = 7000.0;
    plot.mode_1 = plot.mode_2 = tws_msgs::SsrPlot::CODE_UNKNOWN;
    plot.mode_3a = 04321;
    return plot;
  }

  static tws_msgs::Track primary(ros::Time time) {
    tws_msgs::Track track;
    track.number = 17;
    track.uid = 1;
    track.state = tws_msgs::Track::FIRM;
    track.stamp = time;
    track.range = kRange + 50.0;
    track.azimuth = kAzimuth;
    track.position.x = track.range * std::sin(kAzimuth);
    track.position.y = track.range * std::cos(kAzimuth);
    track.mode_1 = track.mode_2 = track.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
    track.height = std::numeric_limits<double>::quiet_NaN();
    return track;
  }

  ros::NodeHandle node_;
  ros::Publisher plots_, marks_, tracks_, sites_;
  ros::Subscriber picture_;
};

// If this fails, the nodes do not work together on their topics.
TEST(TrackCorrelatorRostest, MakesOneOfAPrimaryTrackAndAnAircraftsPlots) {
  Station station;
  ASSERT_TRUE(waitFor([&] { return station.connected(); })) << "the nodes are not there";
  // The two nodes may still be looking for each other: nothing can be counted on before the first answer.
  std::uint32_t n = 0;
  while (station.published.empty() && n < 2 * 64) {
    station.publish(n++);
    waitFor([&] { return !station.published.empty(); }, 0.1);
  }
  ASSERT_FALSE(station.published.empty()) << "no answer after " << n << " sectors";
  for (; n < 10 * 64; ++n) {
    station.publish(n);
    // Data time must not run ahead of the network by more than the skew limit of three seconds.
    const ros::Time answered(kStart + (static_cast<double>(n) - 20.0) * kSectorTime);
    ASSERT_TRUE(waitFor([&] { return station.published.back().header.stamp >= answered; }))
        << "silent after " << n << " sectors";
  }
  const ros::Time end(kStart + 630 * kSectorTime);
  ASSERT_TRUE(waitFor([&] { return station.published.back().header.stamp >= end; }));
  tws_msgs::CorrelatedTrack last;
  for (const auto& message : station.published)
    for (const auto& track : message.tracks) last = track;
  EXPECT_EQ(last.kind, tws_msgs::CorrelatedTrack::CORRELATED);
  EXPECT_EQ(last.primary, 17U);
  EXPECT_EQ(last.track.mode_3a, 04321);
  EXPECT_EQ(last.track.height, 7000.0);
  EXPECT_NEAR(last.track.range, kRange + 50.0, 1e-6);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "track_correlator_rostest");
  return RUN_ALL_TESTS();
}
