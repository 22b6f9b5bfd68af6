#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Tracks.h>

#include <cmath>

namespace {

/// A radar on the topics of the node: one point target, each profile in the gate that the answer before it wanted.
class RangeGateNode : public testing::Test {
 protected:
  RangeGateNode()
      : profiles_(handle_.advertise<tws_msgs::RangeProfile>("/mrs/range_profile", 0)),
        gates_(handle_.subscribe<tws_msgs::RangeGate>("/mrs/range_gate", 0, [this](const auto& m) { gate_ = *m; })) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(20.0);
    while ((profiles_.getNumSubscribers() == 0 || gates_.getNumPublishers() == 0) && ros::WallTime::now() < end)
      ros::WallDuration(0.05).sleep();
    gate_.range_min = 8000.0;
    gate_.range_max = 9200.0;
  }

  tws_msgs::RangeProfile profile(double time, double range) const {
    tws_msgs::RangeProfile message;
    message.header.stamp = ros::Time(time);
    message.header.frame_id = message.radar = "mrs";
    message.range_min = gate_.range_min;
    message.bin_size = 1.0;
    message.bins = static_cast<std::uint32_t>(gate_.range_max - gate_.range_min);
    message.amplitude.assign(message.bins, 0.01F);
    const double bin = range - gate_.range_min;
    if (bin >= 0.0 && bin < message.bins) message.amplitude[static_cast<std::size_t>(bin)] = 2.0F;
    return message;
  }

  /// Whether the answer with that stamp has come.
  bool ask(const tws_msgs::RangeProfile& message) {
    profiles_.publish(message);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(10.0);
    while (gate_.header.stamp != message.header.stamp && ros::WallTime::now() < end) {
      ros::spinOnce();
      ros::WallDuration(0.0005).sleep();
    }
    return gate_.header.stamp == message.header.stamp;
  }

  ros::NodeHandle handle_;
  ros::Publisher profiles_;
  ros::Subscriber gates_;
  tws_msgs::RangeGate gate_;
};

// 150 m/s for 20 s: 3 km, more than twice the gate.
TEST_F(RangeGateNode, MovesTheGateOfTheRadarWithTheTarget) {
  double range = 8600.0;
  for (int i = 0; i < 1000; ++i, range += 150.0 * 0.02) {
    ASSERT_TRUE(ask(profile(100.0 + 0.02 * i, range))) << "no answer to profile " << i;
    EXPECT_GT(range, gate_.range_min);
    EXPECT_LT(range, gate_.range_max);
  }
  EXPECT_EQ(gate_.lock, tws_msgs::RangeGate::LOCKED);
  EXPECT_NEAR(gate_.range_rate, 150.0, 15.0);

  // Bad ones are answered, too, and do not move it.
  const tws_msgs::RangeGate before = gate_;
  tws_msgs::RangeProfile bad = profile(120.1, range);
  bad.amplitude[7] = std::nanf("");
  ASSERT_TRUE(ask(bad));
  EXPECT_EQ(gate_.range_min, before.range_min);
  EXPECT_EQ(gate_.range_max, before.range_max);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "range_gate_rostest");
  ros::start();
  return RUN_ALL_TESTS();
}
