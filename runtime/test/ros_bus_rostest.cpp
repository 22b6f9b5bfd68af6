#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>
#include <rosgraph_msgs/Clock.h>
#include <tws_runtime/live_test_helpers.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/lock_step.h>
#include <tws_runtime/nodelet.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "example_nodes.h"
#include "subscriber_counts.h"

namespace tws_runtime {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A message as bytes, without header.seq, which roscpp fills.
template <class M>
Bytes bytesOf(M message) {
  if (std_msgs::Header* header = ros::message_traits::header(message)) header->seq = 0;
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

struct Received {
  std::vector<Bytes> out;
  std::vector<ros::Time> ticks;
};

Received runInOneProcess() {
  Received received;
  LocalGraph graph(std::cerr);
  NumbersSource source(graph.addNode("numbers"));
  const RelayNode relay(graph.addNode("relay", YAML::Load("{gain: 3}")));
  Bus& ear = graph.addNode("ear");
  ear.subscribe<tws_msgs::Detections>("/relay/out", [&](const auto& m) { received.out.push_back(bytesOf(m)); });
  ear.subscribe<std_msgs::Header>("/relay/ticks", [&](const auto& m) { received.ticks.push_back(m.stamp); });
  runOffline(graph, {&source});
  return received;
}

template <class M>
ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic, const std::function<void(const M&)>& handler) {
  return node.subscribe<M>(topic, 0, [handler](const boost::shared_ptr<const M>& message) { handler(*message); });
}

bool comesTrue(const std::function<bool()>& condition) { return waitFor(condition, 20.0); }

/// Listens to a whole live run, the start of which waits for this listener.
class RosBusTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    ros::NodeHandle node;
    Received received;
    ros::Time last_clock;
    const ros::Subscriber out = listen<tws_msgs::Detections>(
        node, "/relay/out", [&](const auto& message) { received.out.push_back(bytesOf(message)); });
    const ros::Subscriber ticks = listen<std_msgs::Header>(
        node, "/relay/ticks", [&](const auto& message) { received.ticks.push_back(message.stamp); });
    const ros::Subscriber clock = listen<rosgraph_msgs::Clock>(node, "/clock", [&](const auto& message) {
      clocks_go_on = clocks_go_on && message.clock >= last_clock;
      last_clock = message.clock;
      ++clock_count;
    });
    EXPECT_TRUE(comesTrue([&] { return out.getNumPublishers() > 0 && ticks.getNumPublishers() > 0; }));
    const ros::WallTime start = ros::WallTime::now();
    const ros::Subscriber numbers = listen<tws_msgs::Detections>(node, "/numbers", [](const auto&) {});
    EXPECT_TRUE(comesTrue([&] { return received.out.size() >= NumbersSource::kCount; }));
    comesTrue([&] { return received.ticks.size() >= 4; });
    wall_seconds = (ros::WallTime::now() - start).toSec();
    live = received;
  }

  static Received live;
  static bool clocks_go_on;
  static int clock_count;
  static double wall_seconds;
};

Received RosBusTest::live;
bool RosBusTest::clocks_go_on = true;
int RosBusTest::clock_count = 0;
double RosBusTest::wall_seconds = 0.0;

// If this fails, an offline run says nothing about the live system: the first or last messages are lost, or the two
// lives differ.
TEST_F(RosBusTest, TheSameNodesGiveTheSameBytesLiveAndInOneProcess) {
  const Received offline = runInOneProcess();
  EXPECT_EQ(offline.out.size(), NumbersSource::kCount);
  EXPECT_EQ(live.out, offline.out);
}

// If this fails, timers on data time depend on the wall clock. The last number is at 11.95 s, so 12.0 s is never
// passed.
TEST_F(RosBusTest, DataTimersStampTheirDeadlines) {
  const std::vector<ros::Time> expected{ros::Time(10, 0), ros::Time(10, 500000000), ros::Time(11, 0),
                                        ros::Time(11, 500000000)};
  EXPECT_EQ(runInOneProcess().ticks, expected);
  EXPECT_EQ(live.ticks, expected);
}

// If this fails, time jumps for everybody who asks /clock. 1.95 s of data at rate 2 are 0.975 s of wall time, 50
// messages each.
TEST_F(RosBusTest, ClockGoesOnInSmallSteps) {
  EXPECT_TRUE(clocks_go_on);
  EXPECT_GE(wall_seconds, 0.97);
  EXPECT_GE(clock_count, static_cast<int>(NumbersSource::kCount));
}

// If this fails, an operator's request is lost.
TEST_F(RosBusTest, AServiceIsCalledOverRos) {
  tws_msgs::DropTrack call;
  call.request.numbers = {4, 5};
  ASSERT_TRUE(ros::service::call("/relay/add", call));
  EXPECT_EQ(call.response.message, "added 2");
}

// If this fails, faults do not show in /diagnostics. Of 0 .. 39 four numbers end in 7.
TEST_F(RosBusTest, CountersShowInTheDiagnostics) {
  ros::NodeHandle node;
  std::map<std::string, std::string> values;
  std::string hardware_id;
  const ros::Subscriber diagnostics =
      listen<diagnostic_msgs::DiagnosticArray>(node, "/diagnostics", [&](const auto& array) {
        for (const auto& status : array.status) {
          if (status.name != "relay: counters") continue;
          hardware_id = status.hardware_id;
          for (const auto& value : status.values) values[value.key] = value.value;
        }
      });
  EXPECT_TRUE(comesTrue([&] { return !values.empty(); }));
  EXPECT_EQ(hardware_id, "relay");
  EXPECT_EQ(values["numbers"], "40");
  EXPECT_EQ(values["sevens"], "4");
}

// If this fails, nodelets are called from a thread of their manager, several at a time.
TEST_F(RosBusTest, ANodeIsCalledByItsOwnThreadOnly) {
  ros::param::set("/nodelet/gain", 2);
  RosBus bus(ros::NodeHandle("/nodelet"));
  const RelayNode node(bus);
  EXPECT_EQ(bus.name(), "nodelet");
  tws_msgs::Detections number;
  number.running_sector = 21;
  Publisher<tws_msgs::Detections> numbers = bus.advertise<tws_msgs::Detections>("/numbers");
  std::vector<std::uint32_t> answers;
  bus.subscribe<tws_msgs::Detections>("/nodelet/out", [&](const auto& m) { answers.push_back(m.running_sector); });
  numbers.publish(number);
  ros::spinOnce();
  EXPECT_TRUE(answers.empty()) << "called from the global queue";
  EXPECT_TRUE(comesTrue([&] {
    bus.spinFor(0.0);
    return !answers.empty();
  }));
  EXPECT_EQ(answers, std::vector<std::uint32_t>{42});
}

// If this fails, nodelets copy every message.
TEST_F(RosBusTest, BetweenNodesOfOneProcessMessagesAreNotCopied) {
  RosBus sender(ros::NodeHandle("/first"));
  RosBus receiver(ros::NodeHandle("/second"));
  Publisher<tws_msgs::Detections> publisher = sender.advertise<tws_msgs::Detections>("/shared");
  const tws_msgs::Detections* received = nullptr;
  receiver.subscribe<tws_msgs::Detections>("/shared", [&](const auto& message) { received = &message; });
  const auto message = boost::make_shared<const tws_msgs::Detections>();
  publisher.publish(message);
  EXPECT_TRUE(comesTrue([&] {
    receiver.spinFor(0.0);
    return received != nullptr;
  }));
  EXPECT_EQ(received, message.get());
}

// If this fails, a source waits in vain for its listeners when the graph runs as nodelets: roscpp counts a process
// once.
TEST_F(RosBusTest, SubscribersOfTheSameProcessAreCountedOneByOne) {
  RosBus sender(ros::NodeHandle("/first"));
  const auto publisher = sender.advertise<tws_msgs::Detections>("/counted");
  const auto count = [] { return subscriberCounts({"/counted"}, 10.0).at("/counted"); };
  EXPECT_EQ(count(), 0u);
  {
    RosBus receiver(ros::NodeHandle("/second"));
    receiver.subscribe<tws_msgs::Detections>("/counted", [](const auto&) {});
    sender.subscribe<tws_msgs::Detections>("/counted", [](const auto&) {});
    EXPECT_EQ(count(), 2u);
  }
  EXPECT_EQ(count(), 1u);
}

// If this fails, anybody in the network can end a node that was told to be for this machine alone: roscpp opens each
// node's XML-RPC port to all.
TEST_F(RosBusTest, TheXmlRpcPortOfANodeOnLocalhostIsReachedThroughTheLoopbackOnly) {
  if (ros::network::getHost() != "localhost") GTEST_SKIP() << "this machine's name is " << ros::network::getHost();
  const RosBus bus{ros::NodeHandle("~")};
  int found = 0;
  for (int file = 3; file < 1024; ++file) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (::getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) != 0 || address.sin_family != AF_INET ||
        ntohs(address.sin_port) != ros::XMLRPCManager::instance()->getServerPort())
      continue;
    int listens = 0;  // What was accepted before is on that port, too.
    size = sizeof listens;
    ASSERT_EQ(::getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size), 0);
    if (listens == 0) continue;
    char device[IFNAMSIZ] = "";
    size = sizeof device;
    ASSERT_EQ(::getsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, device, &size), 0);
    EXPECT_STREQ(device, "lo");
    ++found;
  }
  EXPECT_GE(found, 1);
}

// If this fails, two nodes that disagree about a topic's type talk past each other.
TEST_F(RosBusTest, ATopicOfAnotherTypeIsRefused) {
  RosBus bus(ros::NodeHandle("/types"));
  const auto publisher = bus.advertise<tws_msgs::Detections>("/typed");
  EXPECT_THROW(bus.advertise<std_msgs::Header>("/typed"), std::runtime_error);
}

/// Of a node, by its own word.
int pidOf(const std::string& name) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = name;
  if (!ros::master::execute("lookupNode", request, response, payload, false)) return -1;
  std::string host;
  std::uint32_t port = 0;
  ros::network::splitURI(payload, host, port);
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue asked;
  asked[0] = ros::this_node::getName();
  return client.execute("getPid", asked, response) ? static_cast<int>(response[2]) : -1;
}

/// What a program says and its exit status.
std::pair<std::string, int> outcomeOf(const std::string& command) {
  FILE* pipe = popen(("rosrun tws_runtime " + command + " 2>&1").c_str(), "r");
  std::string said;
  char buffer[256];
  while (std::fgets(buffer, sizeof buffer, pipe)) said += buffer;
  return {said, WEXITSTATUS(pclose(pipe))};
}

// If this fails, a node with a wrong parameter runs on all the same, or leaves its user to guess why it does not.
TEST_F(RosBusTest, AWrongParameterStopsANodeWithOneLineAndStatusTwo) {
  const auto [said, status] = outcomeOf("tws_runtime_test_relay __name:=wrong _gain:=1000");
  EXPECT_EQ(said, "wrong: gain: 1000 is not in [1, 100]\n");
  EXPECT_EQ(status, 2);
}

// If this fails, a run waits for ever for somebody who never comes, or gives up in silence.
TEST_F(RosBusTest, ASourceGoesOnWithoutSubscribersAfterAWarningAndRunsAsFastAsPossible) {
  ros::param::set("/lonely/live/wait_for", std::vector<std::string>{"/nobody"});
  const std::string options = " _live/wait_timeout:=0.3 _live/rate:=0 _live/linger:=0.0";
  const auto [said, status] = outcomeOf("tws_runtime_test_numbers __name:=lonely" + options);
  EXPECT_NE(said.find("lonely: too few subscribers after 0.3 s: /nobody (0 of 1); starting without them"),
            std::string::npos)
      << said;
  EXPECT_EQ(status, 0);
}

/// Five reports, each answered by a node of the same process while that has `answers` left.
class LoopSource : public Source {
 public:
  LoopSource(Bus& bus, int answers) : reports_(bus.advertise<std_msgs::Header>("~report")), answers_left_(answers) {
    Publisher<std_msgs::Header> commands = bus.advertise<std_msgs::Header>("~command");
    bus.subscribe<std_msgs::Header>("~report", [this, commands](const std_msgs::Header& report) mutable {
      if (answers_left_-- > 0) commands.publish(report);
    });
    bus.subscribe<std_msgs::Header>("~command", [this](const auto& m) { loop_.add(m.stamp, m.stamp); });
  }
  std::optional<ros::Time> nextTime() const override {
    return steps < 5 ? std::optional<ros::Time>(ros::Time(1.0 + steps)) : std::nullopt;
  }
  void step() override {
    for (const ros::Time stamp : loop_.takeDue(*nextTime())) in_force.push_back(stamp.toSec());
    std_msgs::Header report;
    report.stamp = *nextTime();
    loop_.sent(report.stamp);
    reports_.publish(report);
    ++steps;
  }
  bool isReady() const override { return loop_.isReady(*nextTime()); }
  void stopWaiting() override {
    ++waits_in_vain;
    loop_.stopWaiting();
  }

  int steps = 0;
  int waits_in_vain = 0;
  std::vector<double> in_force;

 private:
  Publisher<std_msgs::Header> reports_;
  LockStep<ros::Time> loop_{ros::Duration(1.0)};
  int answers_left_;
};

LiveOptions asFastAsPossible(double command_timeout) {
  LiveOptions options;
  options.rate = 0.0;
  options.linger = 0.0;
  options.command_timeout = command_timeout;
  return options;
}

// If this fails, a recording begins without the first words of a tracker to whom the recorder is connected late: relay
// is another process, whose topic nobody hears until the source has waited for a second.
TEST_F(RosBusTest, ASourceWaitsForTheListenersOfOtherNodes) {
  RosBus bus(ros::NodeHandle("/patient"));
  LoopSource source(bus, 5);
  LiveOptions options = asFastAsPossible(20.0);
  options.wait_for = {"/relay/ticks", "~report"};
  options.wait_timeout = 60.0;
  ros::NodeHandle node;
  ros::Subscriber ticks;
  bool early = false;
  bus.everyWall(1.0, [&] {
    if (ticks) return;
    early = source.steps > 0;
    ticks = listen<std_msgs::Header>(node, "/relay/ticks", [](const auto&) {});
  });
  const ros::WallTime start = ros::WallTime::now();
  runLive(bus, source, options);
  EXPECT_FALSE(early);
  EXPECT_EQ(source.steps, 5);
  EXPECT_EQ(ticks.getNumPublishers(), 1u);
  EXPECT_LT((ros::WallTime::now() - start).toSec(), options.wait_timeout / 2);
}

/// A node that has been stopped answers nobody: the longest that asking it may take [s].
constexpr double kPatience = 5.0;

// If this fails, a run whose tracker stands never starts.
TEST_F(RosBusTest, ANodeThatDoesNotAnswerIsNotAwaitedForEver) {
  const int pid = pidOf("/relay");
  ASSERT_EQ(kill(pid, SIGSTOP), 0);
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_EQ(subscriberCounts({"/relay/out"}, 0.5).at("/relay/out"), 0u);
  EXPECT_LT((ros::WallTime::now() - start).toSec(), kPatience);
  ASSERT_EQ(kill(pid, SIGCONT), 0);
}

// If this fails, a radar that is steered by its tracker runs away from it, and no live run is like an offline one.
TEST_F(RosBusTest, AStepOfAClosedLoopWaitsForTheCommandsThatItGoesBy) {
  RosBus bus(ros::NodeHandle("/loop"));
  LoopSource source(bus, 5);
  runLive(bus, source, asFastAsPossible(20.0));
  EXPECT_EQ(source.steps, 5);
  EXPECT_EQ(source.waits_in_vain, 0);
  EXPECT_EQ(source.in_force, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
}

// If this fails, a radar stands still because its tracker has died.
TEST_F(RosBusTest, AClosedLoopGoesOnWithoutCommandsAfterOneWaitInVain) {
  RosBus bus(ros::NodeHandle("/broken_loop"));
  LoopSource source(bus, 1);
  runLive(bus, source, asFastAsPossible(0.2));
  EXPECT_EQ(source.steps, 5);
  EXPECT_EQ(source.waits_in_vain, 1);
  EXPECT_EQ(source.in_force, std::vector<double>{1.0});
}

/// Numbers and relay as nodelets of this process. roscpp keeps one list of parameters, so their names differ from those
/// of the programs.
class NodeletTest : public ::testing::Test {
 protected:
  static boost::shared_ptr<nodelet::Nodelet> make(const std::string& type) {
    return boost::make_shared<Nodelet>(type == "numbers" ? sourceProgram<NumbersSource>() : nodeProgram<RelayNode>());
  }
  bool load(const std::string& name, const std::string& type) {
    const std::map<std::string, std::string> remaps{{"/numbers", "/nodelets/numbers"}};
    return loader.load(name, type, remaps, {});
  }

  nodelet::Loader loader{boost::function<boost::shared_ptr<nodelet::Nodelet>(const std::string&)>(make)};
};

// If this fails, a graph in one manager gives other tracks than the same graph in programs of its own.
TEST_F(NodeletTest, NodeletsGiveTheSameBytesAsOneProcessWithoutAMaster) {
  ros::NodeHandle node;
  std::vector<Bytes> received;
  const ros::Subscriber out = listen<tws_msgs::Detections>(
      node, "/nodelets/relay/out", [&](const auto& message) { received.push_back(bytesOf(message)); });
  ros::param::set("/nodelets/relay/gain", 3);
  ros::param::set("/nodelets/source/live/rate", 20);
  ASSERT_TRUE(load("/nodelets/relay", "relay"));
  EXPECT_TRUE(comesTrue([&] { return out.getNumPublishers() > 0; }));
  ASSERT_TRUE(load("/nodelets/source", "numbers"));
  EXPECT_TRUE(comesTrue([&] { return received.size() >= NumbersSource::kCount; }));
  EXPECT_EQ(received, runInOneProcess().out);
}

// If this fails, one wrong parameter takes all nodes of a manager with it, or is not noticed.
TEST_F(NodeletTest, AWrongParameterKeepsItsOwnNodeletFromLoading) {
  ros::param::set("/nodelets/wrong/gain", 1000);
  EXPECT_FALSE(load("/nodelets/wrong", "relay"));
  ros::param::set("/nodelets/right/gain", 1);
  EXPECT_TRUE(load("/nodelets/right", "relay"));
  EXPECT_EQ(loader.listLoadedNodelets(), std::vector<std::string>{"/nodelets/right"});
}

// If this fails, unloading a simulator in its run hangs the manager or leaves a thread that writes into freed memory.
TEST_F(NodeletTest, ASourceIsUnloadedInTheMiddleOfItsRun) {
  ros::NodeHandle node;
  int received = 0;
  const ros::Subscriber numbers =
      listen<tws_msgs::Detections>(node, "/nodelets/numbers", [&](const auto&) { ++received; });
  ros::param::set("/nodelets/slow/live/rate", 0.1);
  ASSERT_TRUE(load("/nodelets/slow", "numbers"));
  EXPECT_TRUE(comesTrue([&] { return received > 0; }));
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_TRUE(loader.unload("/nodelets/slow"));
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 1.0);
  EXPECT_EQ(numbers.getNumPublishers(), 0u);
}

}  // namespace
}  // namespace tws_runtime

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_bus_rostest");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
