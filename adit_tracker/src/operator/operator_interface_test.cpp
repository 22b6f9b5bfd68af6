#include "operator/operator_interface.h"

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// A tracker with three tracks, and what it does when it is asked to catch up.
class OperatorInterfaceTest : public testing::Test {
 protected:
  OperatorInterfaceTest() {
    bus_.subscribe<tws_msgs::OperatorRequest>("/adit/operator_requests",
                                              [this](const auto& message) { said_.push_back(message); });
    TestRadar radar(6.0);
    RadarSectors sectors = {radar.sectors(0.0, 40.0)};
    for (const double range : {30e3, 50e3, 70e3}) radar.see({range, range, 150.0, 0.0}, sectors[0]);
    feedInOrder(adit_, sectors);
    for (const auto slot : adit_.tracks().living()) numbers_.push_back(adit_.tracks().at(slot).number);
  }

  tws_msgs::DropTrack::Response drop(const std::vector<std::uint32_t>& numbers) {
    tws_msgs::DropTrack::Request request;
    tws_msgs::DropTrack::Response response;
    request.numbers = numbers;
    graph_.call<tws_msgs::DropTrack>("/adit/drop_track", request, response);
    return response;
  }

  std::ostringstream log_;
  tws_runtime::LocalGraph graph_{log_};
  tws_runtime::Bus& bus_ = graph_.addNode("adit");
  Adit adit_{paramsFor("default", {6.0}), {}};
  std::vector<std::uint32_t> numbers_;
  std::vector<tws_msgs::OperatorRequest> said_;
  int caught_up_ = 0;
  std::function<void()> meanwhile_;
  OperatorInterface operators_{bus_,
                               "map",
                               "",
                               {[this](std::string&) {
                                  ++caught_up_;
                                  if (const auto once = std::exchange(meanwhile_, nullptr)) once();
                                  return &adit_;
                                },
                                []() -> const Site& {
                                  static const Site kOrigin;
                                  return kOrigin;
                                }}};
};

// If this fails, a request that comes while the tracker catches up for another one overtakes it, and the recording says
// so: what an operator asked first was done last.
TEST_F(OperatorInterfaceTest, RequestsAreExecutedInTheOrderInWhichTheyCameAlsoWhenOneComesDuringAnother) {
  tws_msgs::OperatorRequest inner = operators_.blank(tws_msgs::OperatorRequest::DROP);
  inner.track = numbers_[1];
  meanwhile_ = [&] { inner = operators_.ask(inner).message; };
  const auto outer = drop({numbers_[0]});
  graph_.drain();
  EXPECT_TRUE(outer.success) << outer.message;
  EXPECT_EQ(inner.result, tws_msgs::OperatorRequest::OK) << inner.message;
  ASSERT_EQ(said_.size(), 2U);
  EXPECT_EQ(said_[0].track, numbers_[0]);
  EXPECT_EQ(said_[1].track, numbers_[1]);
}

// If this fails, one track of a list is dropped now and another one some sectors later, or not at all.
TEST_F(OperatorInterfaceTest, SeveralTracksAreDroppedBetweenTheSameTwoSectors) {
  EXPECT_TRUE(drop(numbers_).success);
  graph_.drain();
  EXPECT_EQ(caught_up_, 1);
  EXPECT_EQ(said_.size(), 3U);
  EXPECT_TRUE(adit_.tracks().living().empty());
}

TEST_F(OperatorInterfaceTest, WhatWaitsIsBusyWhenTheTrackerCannotCatchUp) {
  tws_runtime::RequestLog log(graph_.addNode("other"), "map");
  OperatorHandler handler(log);
  const auto ticket = handler.add(operators_.blank(tws_msgs::OperatorRequest::DROP_ALL));
  EXPECT_FALSE(handler.take(ticket));
  EXPECT_EQ(handler.refuse("busy: 9 sectors behind the radars; ask again", ros::Time(5.0)).size(), 1U);
  const auto outcome = handler.take(ticket);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->message.result, tws_msgs::OperatorRequest::BUSY);
  EXPECT_FALSE(handler.take(ticket));
}

}  // namespace
}  // namespace adit_tracker
