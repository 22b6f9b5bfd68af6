#include <tws_runtime/site_gate.h>

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>
#include <vector>

namespace tws_runtime {
namespace {

class SiteGateTest : public ::testing::Test {
 protected:
  void place(const std::string& radar, double x) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.child_frame_id = radar;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1.0;
    bus.publishStaticTransform(transform);
    graph.drain();
  }
  void add(int item, std::size_t radar, const std::string& frame) {
    gate.add(
        frame, item, [this](int each) { used.push_back(each); }, radar);
  }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& bus = graph.addNode("tracker");
  SiteGate gate{bus, "map", 3, 2};
  std::vector<int> used;
};

// If these fail, what a tracker makes of its first sectors depends on when a transform arrives.

TEST_F(SiteGateTest, AllWaitsInItsOrderUntilTheSitesOfThoseThatWaitAreKnown) {
  add(1, 0, "a");
  add(2, 1, "b");
  place("b", 7.0);
  add(3, 1, "b");
  EXPECT_TRUE(used.empty()) << "the first one still waits";
  place("a", 5.0);
  add(4, 1, "b");
  EXPECT_EQ(used, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(gate.site(0)->x, 5.0);
  EXPECT_EQ(gate.pose(1)->translation().x(), 7.0);
  add(5, 0, "another frame");
  EXPECT_EQ(used.back(), 5);
  EXPECT_EQ(log.str(), "");
}

TEST_F(SiteGateTest, ASiteThatStaysAwayIsGivenUpAndNamed) {
  for (int item = 1; item <= 3; ++item) add(item, 0, "a");
  EXPECT_TRUE(used.empty());
  add(4, 0, "a");
  EXPECT_EQ(used, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_TRUE(gate.isDecided(0));
  EXPECT_FALSE(gate.site(0).has_value());
  EXPECT_EQ(bus.counter("unknown sites").value(), 1u);
  EXPECT_NE(log.str().find("no transform from a to map"), std::string::npos);
  place("a", 5.0);
  add(5, 0, "a");
  EXPECT_FALSE(gate.site(0).has_value()) << "given up for good: half of a run at another place is worse";
}

TEST_F(SiteGateTest, ANewRunForgetsWhatWaits) {
  add(1, 0, "a");
  gate.clear();
  place("a", 5.0);
  add(2, 0, "a");
  EXPECT_EQ(used, (std::vector<int>{2}));
}

}  // namespace
}  // namespace tws_runtime
