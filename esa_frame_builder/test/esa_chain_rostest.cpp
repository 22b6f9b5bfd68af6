// Both nodes over roscpp: dwell reports in, frames, tracks and a track database for each report out.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/Frame.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/live_test_helpers.h>

#include <vector>

namespace {

using tws_runtime::kUnbounded, tws_runtime::waitFor;

/// Stands in for a radar named esa that looks east; one aircraft stands still on its boresight.
class Radar {
 public:
  Radar() {
    reports_ = node_.advertise<tws_msgs::DwellReports>("/esa/dwell_reports", kUnbounded);
    sites_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    listen("/esa/frames", frames);
    listen("/esa/tracks", tracks);
    listen("/esa/track_database", databases);
    tf2_msgs::TFMessage sites;
    sites.transforms.resize(1);
    sites.transforms[0].header.frame_id = "map";
    sites.transforms[0].child_frame_id = "esa";
    sites.transforms[0].transform.rotation.w = 1.0;
    sites_.publish(sites);
  }

  bool connected() const {
    for (const ros::Subscriber& ear : subscribers_)
      if (ear.getNumPublishers() == 0) return false;
    return reports_.getNumSubscribers() > 0 && sites_.getNumSubscribers() > 0;
  }

  /// The report of the period that ends at `end`: one dwell.
  void report(std::uint32_t period, ros::Time end) {
    tws_msgs::DwellReports message;
    message.header.stamp = end;
    message.header.frame_id = message.radar = "esa";
    message.resource_period = period;
    message.duration = 0.1;
    message.dwells.resize(1);
    tws_msgs::DwellReport& dwell = message.dwells[0];
    dwell.stamp = end - ros::Duration(0.05);
    dwell.beamwidth_u = dwell.beamwidth_v = 0.03;
    dwell.range_max = 100e3;
    dwell.measurements.resize(1);
    dwell.measurements[0].range = 40e3;
    dwell.measurements[0].snr = 100.0;
    dwell.measurements[0].covariance = {100.0, 0.0, 0.0, 0.0, 1e-6, 0.0, 0.0, 0.0, 1e-6};
    reports_.publish(message);
  }

  std::vector<tws_msgs::Frame> frames;
  std::vector<tws_msgs::Tracks> tracks;
  std::vector<tws_msgs::TrackDatabase> databases;

 private:
  template <class M>
  void listen(const std::string& topic, std::vector<M>& received) {
    const boost::function<void(const boost::shared_ptr<const M>&)> on_message = [&received](const auto& m) {
      received.push_back(*m);
    };
    subscribers_.push_back(node_.subscribe<M>(topic, kUnbounded, on_message));
  }

  ros::NodeHandle node_;
  ros::Publisher reports_, sites_;
  std::vector<ros::Subscriber> subscribers_;
};

// If this fails, the nodes do not close the loop on their topics.
TEST(EsaChainRostest, AnswersEveryReportWithATrackDatabaseOfItsStamp) {
  Radar radar;
  ASSERT_TRUE(waitFor([&] { return radar.connected(); })) << "the nodes are not there";
  // The two nodes may still be looking for each other: nothing can be counted on before the first answer.
  std::uint32_t n = 0;
  const auto endOf = [](std::uint32_t period) { return ros::Time(1000.0) + ros::Duration(0.1 * period); };
  while (radar.databases.empty() && n < 100) {
    radar.report(n, endOf(n));
    ++n;
    waitFor([&] { return !radar.databases.empty(); }, 0.1);
  }
  ASSERT_FALSE(radar.databases.empty()) << "no answer after " << n << " periods";
  for (const std::uint32_t last = n + 30; n < last; ++n) {
    radar.report(n, endOf(n));
    ASSERT_TRUE(waitFor([&] { return radar.databases.back().header.stamp == endOf(n); })) << "period " << n;
  }
  ASSERT_TRUE(waitFor([&] { return !radar.tracks.empty() && radar.tracks.back().header.stamp == endOf(n - 1); }));
  ASSERT_EQ(radar.databases.back().tracks.size(), 1U);
  EXPECT_NEAR(radar.databases.back().tracks[0].position.x, 40e3, 10.0);
  ASSERT_EQ(radar.tracks.back().tracks.size(), 1U);
  EXPECT_EQ(radar.tracks.back().tracks[0].state, tws_msgs::Track::FIRM);
  EXPECT_NEAR(radar.tracks.back().tracks[0].azimuth, 1.570796, 1e-2);
  EXPECT_EQ(radar.frames.back().status, tws_msgs::Frame::HEARTBEAT);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "esa_chain_rostest");
  return RUN_ALL_TESTS();
}
