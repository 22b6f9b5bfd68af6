#include <tws_runtime/request_log.h>

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>
#include <vector>

namespace tws_runtime {
namespace {

using Request = tws_msgs::OperatorRequest;

class RequestLogTest : public ::testing::Test {
 protected:
  static RequestLog::HasPassed upTo(std::uint32_t running) {
    return [running](const std::string& radar, std::uint32_t sector) {
      return radar == "a" && hasReached(running, sector);
    };
  }
  Request recorded(std::uint32_t running, std::uint8_t request = Request::DROP_ALL) {
    Request message = log.blank(request);
    log.stamp(message, {"a", running, 12.5});
    return message;
  }
  void handOver(const Request& request) {
    in.publish(request);
    graph.drain();
  }

  std::ostringstream text;
  LocalGraph graph{text};
  Bus& node = graph.addNode("tracker");
  RequestLog log{node, "map"};
  Publisher<Request> in = node.advertise<Request>("/tracker/recorded_requests");
};

TEST_F(RequestLogTest, SaysAfterWhichSectorOfWhichRunARequestTookEffect) {
  std::vector<Request> requests;
  node.subscribe<Request>("/tracker/operator_requests", [&](const Request& request) { requests.push_back(request); });
  log.beginNewRun();
  Request request = log.blank(Request::DROP);
  log.stamp(request, {"a", 77, 12.5});
  log.publish(request);
  graph.drain();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].header.stamp, ros::Time(12.5));
  EXPECT_EQ(requests[0].header.frame_id, "map");
  EXPECT_EQ(requests[0].tracker, "tracker");
  EXPECT_EQ(requests[0].radar, "a");
  EXPECT_EQ(requests[0].running_sector, 77u);
  EXPECT_EQ(requests[0].run, 1u);
}

// If this fails, a replay repeats the operator's requests at another time than he made them, or in another run.
TEST_F(RequestLogTest, GivesARecordedRequestAfterItsSectorOfItsRun) {
  handOver(recorded(30));
  handOver(recorded(20, Request::DROP));
  Request of_next_run = recorded(5);
  of_next_run.run = 1;
  handOver(of_next_run);
  EXPECT_FALSE(log.takeDue(upTo(19)).has_value());
  EXPECT_EQ(log.takeDue(upTo(20))->request, Request::DROP);
  EXPECT_FALSE(log.takeDue(upTo(20)).has_value());
  EXPECT_EQ(log.takeDue(upTo(31))->running_sector, 30u);
  log.beginNewRun();
  EXPECT_EQ(log.takeDue(upTo(5))->running_sector, 5u);
}

TEST_F(RequestLogTest, KnowsWhatTookEffectBeforeTheFirstSectorAndLeavesOutWhatHadNoEffect) {
  Request busy = recorded(1);
  busy.result = Request::BUSY;
  handOver(busy);
  handOver(log.blank(Request::LOAD_CLUTTER));
  EXPECT_EQ(log.takeAtStart()->request, Request::LOAD_CLUTTER);
  EXPECT_FALSE(log.takeDue(upTo(1000)).has_value());
}

TEST_F(RequestLogTest, CountsWhatCameTooLateOrHadAnotherEffect) {
  const Request was = recorded(20);
  log.compare(was, was);
  EXPECT_EQ(graph.counters().size(), 0u);
  log.compare(was, recorded(21));
  EXPECT_EQ(node.counter("late recorded requests").value(), 1u);
  Request other = was;
  other.count = 3;
  log.compare(was, other);
  EXPECT_EQ(node.counter("requests repeated with another effect").value(), 1u);
}

}  // namespace
}  // namespace tws_runtime
