#include <tws_runtime/local_graph.h>

#include <gtest/gtest.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/InitiateTrack.h>
#include <tws_runtime/run.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tws_runtime {
namespace {

std_msgs::Int32 number(int value) {
  std_msgs::Int32 message;
  message.data = value;
  return message;
}

/// A graph with two nodes and a memory of what was received.
class LocalGraphTest : public ::testing::Test {
 protected:
  void listen(Bus& bus, const std::string& topic) {
    bus.subscribe<std_msgs::Int32>(topic, [this](const std_msgs::Int32& message) { received.push_back(message.data); });
  }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& a = graph.addNode("a");
  Bus& b = graph.addNode("b");
  std::vector<int> received;
};

// If this fails, nodes see half-done states of each other and runs differ with the depth of the calls.
TEST_F(LocalGraphTest, WhatAHandlerPublishesIsDeliveredAfterItReturnsFirstInFirstOut) {
  auto first = a.advertise<std_msgs::Int32>("/numbers");
  auto answers = b.advertise<std_msgs::Int32>("/answers");
  b.subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32& message) {
    answers.publish(number(10 * message.data));
    received.push_back(message.data);
  });
  listen(a, "/answers");
  first.publish(number(1));
  first.publish(number(2));
  EXPECT_TRUE(received.empty());
  graph.drain();
  EXPECT_EQ(received, (std::vector<int>{1, 2, 10, 20}));
}

// If this fails, a graph copies every message and offline runs slow down.
TEST_F(LocalGraphTest, ASharedMessageReachesItsHandlersWithoutACopy) {
  auto publisher = a.advertise<std_msgs::Int32>("/numbers");
  const auto message = boost::make_shared<const std_msgs::Int32>(number(1));
  const std_msgs::Int32* seen = nullptr;
  b.subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32& message) { seen = &message; });
  publisher.publish(message);
  graph.drain();
  EXPECT_EQ(seen, message.get());
}

// If this fails, a node that starts late never learns what is said once, such as a site's position.
TEST_F(LocalGraphTest, ALatchedTopicRepeatsItsLastMessageToALateSubscriberAndOthersDoNot) {
  auto latched = a.advertise<std_msgs::Int32>("/latched", true);
  auto fleeting = a.advertise<std_msgs::Int32>("/fleeting");
  for (int i = 1; i <= 2; ++i) {
    latched.publish(number(i));
    fleeting.publish(number(-i));
  }
  graph.drain();
  listen(b, "/latched");
  listen(b, "/fleeting");
  graph.drain();
  EXPECT_EQ(received, std::vector<int>{2});
}

// If this fails, a node that subscribes in answer to a message acts twice on it, or never.
TEST_F(LocalGraphTest, ASubscriberThatComesWhileALatchedMessageIsOnItsWayGetsItOnce) {
  auto latched = a.advertise<std_msgs::Int32>("/latched", true);
  b.subscribe<std_msgs::Int32>("/latched", [&](const std_msgs::Int32&) { listen(b, "/latched"); });
  latched.publish(number(7));
  graph.drain();
  EXPECT_EQ(received, std::vector<int>{7});
}

// If this fails, a node reads another type's bytes as its own.
TEST_F(LocalGraphTest, TwoTypesOnOneTopicAreRefusedByAnErrorThatNamesTopicAndTypes) {
  a.advertise<std_msgs::Int32>("/numbers");
  try {
    b.subscribe<std_msgs::String>("/numbers", [](const std_msgs::String&) {});
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    for (const char* part : {"/numbers", "std_msgs/Int32", "std_msgs/String"})
      EXPECT_NE(what.find(part), std::string::npos) << what;
  }
}

// If this fails, the offline graph is wired otherwise than the live one.
TEST_F(LocalGraphTest, APrivateNameIsTheNodesOwnAndRemapsAreFollowed) {
  Bus& c = graph.addNode("c", YAML::Node(), {{"/c/out", "/a/in"}});
  auto publisher = c.advertise<std_msgs::Int32>("~out");
  listen(a, "~in");
  publisher.publish(number(3));
  graph.drain();
  EXPECT_EQ(received, std::vector<int>{3});
  EXPECT_TRUE(graph.isPublished("/a/in"));
  EXPECT_FALSE(graph.isPublished("/c/out"));
  EXPECT_THROW(a.advertise<std_msgs::Int32>("~"), std::invalid_argument);
  EXPECT_THROW(a.advertise<std_msgs::Int32>("two words"), std::invalid_argument);
  EXPECT_THROW(graph.addNode("a"), std::invalid_argument);
}

// If this fails, a graph cannot be put into a namespace, and two sites cannot run side by side.
TEST_F(LocalGraphTest, ARelativeNameBelongsToTheNodesNamespace) {
  Bus& c = graph.addNode("siteA/c", YAML::Node(), {{"in", "other"}, {"~own", "/siteA/c/renamed"}});
  for (const char* name : {"numbers", "~mine", "/numbers", "in", "~own"}) c.advertise<std_msgs::Int32>(name);
  for (const char* name : {"/siteA/numbers", "/siteA/c/mine", "/numbers", "/siteA/other", "/siteA/c/renamed"})
    EXPECT_TRUE(graph.isPublished(name)) << name;
  EXPECT_FALSE(graph.isPublished("/siteA/in"));
}

// If this fails, a node that works bit by bit does not know what has arrived meanwhile.
TEST_F(LocalGraphTest, ATaskWaitsForAllThatHasArrivedAndOfflineNothingIsLive) {
  auto numbers = a.advertise<std_msgs::Int32>("/numbers");
  b.subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32& message) {
    received.push_back(message.data);
    if (message.data == 1) b.whenDrained([&] { received.push_back(100); });
  });
  numbers.publish(number(1));
  numbers.publish(number(2));
  graph.drain();
  EXPECT_EQ(received, (std::vector<int>{1, 2, 100}));
  EXPECT_FALSE(b.live());
}

// If this fails, the operator's requests cannot be tested without a master.
TEST_F(LocalGraphTest, AServiceAnswersAndWhatItPublishesIsDelivered) {
  auto publisher = a.advertise<std_msgs::Int32>("/dropped");
  listen(b, "/dropped");
  a.serve<tws_msgs::DropTrack>("~drop",
                               [&](tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response) {
                                 for (const auto track : request.numbers)
                                   publisher.publish(number(static_cast<int>(track)));
                                 response.message = "done";
                                 return true;
                               });
  tws_msgs::DropTrack::Request request;
  tws_msgs::DropTrack::Response response;
  request.numbers = {4, 5};
  EXPECT_TRUE(graph.call<tws_msgs::DropTrack>("/a/drop", request, response));
  EXPECT_EQ(response.message, "done");
  EXPECT_EQ(received, (std::vector<int>{4, 5}));
  EXPECT_THROW(graph.call<tws_msgs::DropTrack>("/a/drip", request, response), std::runtime_error);
  tws_msgs::InitiateTrack::Request other_request;
  tws_msgs::InitiateTrack::Response other_response;
  EXPECT_THROW(graph.call<tws_msgs::InitiateTrack>("/a/drop", other_request, other_response), std::runtime_error);
}

// If this fails, two callbacks of one node can overlap, which the Bus rules out.
TEST_F(LocalGraphTest, DrivingTheGraphFromWithinAHandlerIsRefused) {
  auto publisher = a.advertise<std_msgs::Int32>("/numbers");
  b.subscribe<std_msgs::Int32>("/numbers",
                               [&](const std_msgs::Int32&) { EXPECT_THROW(graph.drain(), std::logic_error); });
  publisher.publish(number(1));
  graph.drain();
}

// If this fails, one bad handler leaves the graph unusable.
TEST_F(LocalGraphTest, AnExceptionOfAHandlerReachesTheCallerAndTheGraphGoesOn) {
  auto publisher = a.advertise<std_msgs::Int32>("/numbers");
  b.subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32& message) {
    if (message.data == 1) throw std::runtime_error("no");
    received.push_back(message.data);
  });
  publisher.publish(number(1));
  publisher.publish(number(2));
  EXPECT_THROW(graph.drain(), std::runtime_error);
  graph.drain();
  EXPECT_EQ(received, std::vector<int>{2});
}

// If this fails, time-outs in data time depend on when messages happen to come.
TEST_F(LocalGraphTest, DataTimersFireInOrderAfterAllAtTheirDeadlineAndBeforeAllThatIsLater) {
  std::vector<std::string> events;
  const auto note = [&](const std::string& name) {
    return [&, name](ros::Time deadline) {
      events.push_back(name + std::to_string(deadline.toNSec() / 1000000));
      EXPECT_EQ(a.now(), deadline);
    };
  };
  a.everyData(0.5, note("slow "));
  b.everyData(0.25, note("fast "));
  auto publisher = a.advertise<std_msgs::Int32>("/numbers");
  b.subscribe<std_msgs::Int32>(
      "/numbers", [&](const std_msgs::Int32& m) { events.push_back("message " + std::to_string(m.data)); });
  for (const int ms : {100, 250, 600}) {
    graph.advanceTo(ros::Time(0, static_cast<std::uint32_t>(ms) * 1000000u));
    publisher.publish(number(ms));
    graph.drain();
  }
  EXPECT_EQ(events, (std::vector<std::string>{"message 100", "message 250", "fast 250", "slow 500", "fast 500",
                                              "message 600"}));
  EXPECT_EQ(graph.now(), ros::Time(0, 600000000u));
  graph.advanceTo(ros::Time(0, 1));  // Data time never goes back.
  EXPECT_EQ(graph.now(), ros::Time(0, 600000000u));
}

// If this fails, what a timer publishes comes after later input.
TEST_F(LocalGraphTest, WhatATimerPublishesIsDeliveredBeforeTimeMovesOn) {
  auto publisher = a.advertise<std_msgs::Int32>("/ticks");
  a.everyData(1.0, [&](ros::Time deadline) { publisher.publish(number(static_cast<int>(deadline.sec))); });
  b.subscribe<std_msgs::Int32>("/ticks", [&](const std_msgs::Int32& message) {
    EXPECT_EQ(b.now(), ros::Time(static_cast<std::uint32_t>(message.data), 0));
    received.push_back(message.data);
  });
  graph.advanceTo(ros::Time(10, 0));
  graph.advanceTo(ros::Time(12, 1));
  EXPECT_EQ(received, (std::vector<int>{10, 11, 12}));
}

// If this fails, a night between two recordings floods the graph with what a timer would have published meanwhile.
TEST_F(LocalGraphTest, AfterALongGapATimerIsCalledOnce) {
  std::vector<std::uint32_t> deadlines;
  a.everyData(2.0, [&](ros::Time deadline) { deadlines.push_back(deadline.sec); });
  for (const std::uint32_t time : {10u, 15u, 28815u, 28817u}) graph.advanceTo(ros::Time(time, 0));
  EXPECT_EQ(deadlines, (std::vector<std::uint32_t>{10, 12, 14, 28814, 28816}));
}

// If this fails, one bad stamp in a bag ends an offline run with "Duration is out of dual 32-bit range".
TEST_F(LocalGraphTest, ARunGetsOverAStampAtTheEndOfTime) {
  class Stamps : public Source {
   public:
    std::optional<ros::Time> nextTime() const override {
      return steps < 2 ? std::optional<ros::Time>(ros::Time(steps == 0 ? 1 : 4294967295U, 0)) : std::nullopt;
    }
    void step() override { ++steps; }
    int steps = 0;
  } source;
  runOffline(graph, {&source});
  EXPECT_EQ(source.steps, 2);
}

TEST_F(LocalGraphTest, ATimerWithoutAPeriodIsRefused) {
  EXPECT_THROW(a.everyData(0.0, [](ros::Time) {}), std::invalid_argument);
  EXPECT_THROW(a.everyData(-1.0, [](ros::Time) {}), std::invalid_argument);
  EXPECT_THROW(a.everyData(std::numeric_limits<double>::quiet_NaN(), [](ros::Time) {}), std::invalid_argument);
}

// If this fails, trackers cannot place a radar's site, or know only the last of several.
TEST_F(LocalGraphTest, StaticTransformsAddUpAndAreSharedByAllNodes) {
  geometry_msgs::TransformStamped site;
  site.header.frame_id = "map";
  site.transform.rotation.w = 1.0;
  for (const char* child : {"sps12", "sps39"}) {
    site.child_frame_id = child;
    site.transform.translation.x += 1000.0;
    a.publishStaticTransform(site);
  }
  graph.drain();
  EXPECT_EQ(b.transforms().lookupTransform("map", "sps12", ros::Time()).transform.translation.x, 1000.0);
  EXPECT_EQ(b.transforms().lookupTransform("map", "sps39", ros::Time()).transform.translation.x, 2000.0);
}

// If this fails, losses are silent, or said without the counts that the end of the run needs.
TEST_F(LocalGraphTest, CountersAreSaidOnceAndListedAtTheEnd) {
  a.counter("detections").add(250);
  a.counter("bad detections").add("azimuth is NaN in /sps12/detections at 12.375");
  a.counter("bad detections").add("range is -5 in /sps12/detections at 12.5");
  b.counter("detections").add();
  EXPECT_EQ(a.counter("bad detections").value(), 2u);
  EXPECT_EQ(log.str(), "a: bad detections (1): azimuth is NaN in /sps12/detections at 12.375\n");
  std::ostringstream table;
  printCounters(table, graph.counters());
  EXPECT_EQ(table.str(),
            "node  counter                count\n"
            "a     detections               250\n"
            "a     bad detections             2 !\n"
            "b     detections                 1\n");
}

// If this fails, a node refuses to start offline because of the keys that only the live runtime reads.
TEST_F(LocalGraphTest, ANodeSeesItsParametersWithoutTheRuntimesOwn) {
  Bus& c = graph.addNode("c", YAML::Load("{gain: 2, live: {rate: 10}}"));
  EXPECT_EQ(c.parameters()["gain"].as<int>(), 2);
  EXPECT_FALSE(c.parameters()["live"].IsDefined());
}

}  // namespace
}  // namespace tws_runtime
