#include "elevation/elevation_interface.h"

#include <gtest/gtest.h>

#include "adit_node_test_helpers.h"

namespace adit_tracker {
namespace {

/// The node, and the lists that it sends to the reference radar, r1.
class ElevationInterfaceTest : public testing::Test {
 protected:
  ElevationInterfaceTest() {
    graph.graph.addNode("listener")
        .subscribe<tws_msgs::ElevationRequests>("/r1/elevation_requests",
                                                [this](const auto& list) { lists.push_back(list); });
  }

  NodeGraph graph;
  std::vector<tws_msgs::ElevationRequests> lists;
  const RadarSectors radars = flights(90.0, eightAircraft());
};

// A simulated radar waits for the list that answers its mark: without the mark's very stamp it would wait in vain.
TEST_F(ElevationInterfaceTest, EachListBearsTheStampOfTheMarkOfSector61) {
  graph.play(radars, 0.0, 90.0);
  ASSERT_EQ(lists.size(), 11U);
  for (std::size_t scan = 0; scan < lists.size(); ++scan) {
    const double mark = kEpoch + radars[1][64 * scan + 61].enter_time;
    EXPECT_EQ(lists[scan].header.stamp, tws_runtime::toTime(mark));
    EXPECT_EQ(lists[scan].radar, "r1");
    EXPECT_TRUE(lists[scan].requests.empty());
  }
}

TEST_F(ElevationInterfaceTest, ADesignatedTrackIsInTheNextListUntilTheDesignationIsCancelled) {
  graph.play(radars, 0.0, 50.0);
  const std::uint32_t track = graph.ask(tws_msgs::OperatorRequest::LIST_ALL).tracks.at(2).number;
  graph.ask(tws_msgs::OperatorRequest::DESIGNATE, track);
  const std::size_t before = lists.size();
  graph.play(radars, 50.0, 60.0);
  ASSERT_GT(lists.size(), before);
  ASSERT_EQ(lists[before].requests.size(), 1U);
  EXPECT_EQ(lists[before].requests[0].track, track);
  tws_msgs::OperatorCommand::Request cancel;
  tws_msgs::OperatorCommand::Response answer;
  cancel.request = tws_msgs::OperatorRequest::DESIGNATE;
  cancel.track = track;
  cancel.cancel = true;
  graph.graph.call<tws_msgs::OperatorCommand>("/adit/operator_command", cancel, answer);
  const std::size_t cancelled = lists.size();
  graph.play(radars, 60.0, 90.0);
  for (std::size_t i = cancelled; i < lists.size(); ++i) EXPECT_TRUE(lists[i].requests.empty());
  EXPECT_EQ(graph.statuses.back().elevation_searches, 0U);  // ISTA(6)
}

}  // namespace
}  // namespace adit_tracker
