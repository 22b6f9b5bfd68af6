#include <tws_runtime/moving_frames.h>

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>

namespace tws_runtime {
namespace {

class MovingFramesTest : public ::testing::Test {
 protected:
  MovingFramesTest() {
    geometry_msgs::TransformStamped mount = of("ship", "radar", 0.0, 5.0);
    bus.publishStaticTransform(mount);
    graph.drain();
  }

  static geometry_msgs::TransformStamped of(const std::string& parent, const std::string& child, double time,
                                            double x) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = ros::Time(time);
    transform.header.frame_id = parent;
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1.0;
    return transform;
  }

  void tell(double time, double x) {
    tf2_msgs::TFMessage message;
    message.transforms = {of("map", "ship", time, x)};
    poses.publish(message);
    graph.drain();
  }

  double radarAt(double time) const {
    const ros::Time when = frames.timeFor("map", "radar", ros::Time(time));
    return frames.transforms().lookupTransform("map", "radar", when).transform.translation.x;
  }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& bus = graph.addNode("ppi");
  Publisher<tf2_msgs::TFMessage> poses = bus.advertise<tf2_msgs::TFMessage>("/tf");
  MovingFrames frames{bus};
};

// If this fails, a display draws a ship's plots where the ship is no more.
TEST_F(MovingFramesTest, AFrameIsWhereItWasAtTheTimeOrElseWhereItWasLast) {
  tell(100.0, 0.0);
  tell(101.0, 10.0);
  EXPECT_NEAR(radarAt(100.5), 10.0, 1e-9);
  EXPECT_NEAR(radarAt(103.0), 15.0, 1e-9);
}

// If this fails, the ship stands still in the picture from the second run on.
TEST_F(MovingFramesTest, ANewRunForgetsWhereItWasInTheOld) {
  tell(1000.0, 0.0);
  tell(1001.0, 10.0);
  tell(10.0, 500.0);
  EXPECT_NEAR(radarAt(12.0), 505.0, 1e-9);
  EXPECT_EQ(log.str(), "");
}

}  // namespace
}  // namespace tws_runtime
