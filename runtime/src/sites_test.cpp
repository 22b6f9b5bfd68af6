#include <tws_runtime/sites.h>

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <cmath>
#include <sstream>
#include <string>

namespace tws_runtime {
namespace {

class SitesTest : public ::testing::Test {
 protected:
  /// A radar at (1000, 2000, 30) whose x axis points north: turned by a right angle, anticlockwise.
  void tell() {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.child_frame_id = "sps12";
    transform.transform.translation.x = 1000.0;
    transform.transform.translation.y = 2000.0;
    transform.transform.translation.z = 30.0;
    transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
    bus.publishStaticTransform(transform);
    graph.drain();
  }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& bus = graph.addNode("tracker");
};

// If this fails, a tracker starts before it knows where its radar stands, or says at each message that it waits.
TEST_F(SitesTest, ASiteThatIsNotToldYetIsWaitedForWithoutAWord) {
  EXPECT_FALSE(awaitSite(bus, "map", "sps12", true).has_value());
  EXPECT_EQ(bus.counter("unknown sites").value(), 0u);
  tell();
  const auto site = awaitSite(bus, "map", "sps12", true);
  ASSERT_TRUE(site.has_value());
  EXPECT_EQ(site->x, 1000.0);
  EXPECT_EQ(site->z, 30.0);
  EXPECT_NEAR(site->turn, std::acos(0.0), 1e-12);
}

// If this fails, a radar without a site stops its tracker for good, or its tracks stand at the origin in silence.
TEST_F(SitesTest, WhenItIsEnoughOfWaitingTheSubstituteIsTakenAndCounted) {
  const auto site = awaitSite(bus, "map", "sps12", false, {7.0, 8.0, 9.0, 0.0});
  ASSERT_TRUE(site.has_value());
  EXPECT_EQ(site->y, 8.0);
  EXPECT_EQ(bus.counter("unknown sites").value(), 1u);
}

// If this fails, an array's tracks or its picture lie turned about the site.
TEST_F(SitesTest, APoseTurnsAndMovesPlaces) {
  std::string why;
  EXPECT_FALSE(findPose(bus.transforms(), "map", "sps12", why).has_value());
  EXPECT_NE(why.find("sps12"), std::string::npos) << why;
  tell();
  const auto pose = findPose(bus.transforms(), "map", "sps12", why);
  ASSERT_TRUE(pose.has_value());
  // 5 km along the radar's x axis is 5 km north.
  EXPECT_LT((*pose * Eigen::Vector3d(5000.0, 0.0, 0.0) - Eigen::Vector3d(1000.0, 7000.0, 30.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace tws_runtime
