// The recorder of a LocalGraph and BagSource, one against the other.
#include <tws_runtime/bag_source.h>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <tws_core/file_size_limit_test_helpers.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/run.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "any_message.h"

namespace tws_runtime {
namespace {

/// Publishes 0, 1, … `count` - 1 on /numbers, one a second from 5 s on, a latched greeting, and each number on /other
/// too.
class Counting : public Source {
 public:
  Counting(Bus& bus, int count)
      : count_(count),
        numbers_(bus.advertise<std_msgs::Int32>("/numbers")),
        other_(bus.advertise<std_msgs::Int32>("/other")) {
    auto greeting = bus.advertise<std_msgs::String>("/greeting", true);
    std_msgs::String hello;
    hello.data = "hello";
    greeting.publish(hello);
  }
  std::optional<ros::Time> nextTime() const override {
    if (next_ == count_) return std::nullopt;
    return ros::Time(5.0 + next_);
  }
  void step() override {
    std_msgs::Int32 message;
    message.data = next_++;
    numbers_.publish(message);
    other_.publish(message);
  }

 private:
  int count_;
  int next_ = 0;
  Publisher<std_msgs::Int32> numbers_;
  Publisher<std_msgs::Int32> other_;
};

class BagTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  std::string recordNumbers(const std::string& name, const std::vector<std::string>& topics = {}) {
    LocalGraph graph(log);
    Counting source(graph.addNode("counting"), 100);
    graph.record(path(name), topics);
    runOffline(graph, {&source});
    graph.finishRecording();
    return path(name);
  }

  /// Publishes so many texts of 100 kB while a bag is recorded; the complaint, or nothing.
  std::string recordTexts(const std::string& name, int count, const std::function<void(int)>& before = {}) {
    LocalGraph graph(log);
    auto texts = graph.addNode("texts").advertise<std_msgs::String>("/texts");
    std_msgs::String text;
    text.data.assign(100000, 'x');
    try {
      graph.record(path(name));
      for (int i = 0; i < count; ++i) {
        if (before) before(i);
        graph.advanceTo(ros::Time(1 + i));
        texts.publish(text);
        graph.drain();
      }
      graph.finishRecording();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  /// What a node receives on /numbers when a bag is replayed.
  std::vector<int> replay(const std::string& bag, const std::string& record_to = "") {
    LocalGraph graph(log);
    std::vector<int> received;
    graph.addNode("ear").subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32& message) {
      EXPECT_EQ(graph.now(), ros::Time(5.0 + message.data));
      received.push_back(message.data);
    });
    BagSource source(graph, bag);
    if (!record_to.empty()) graph.record(record_to);
    runOffline(graph, {&source});
    return received;
  }

  std::string errorOf(const std::function<void()>& action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  void expectError(const std::function<void()>& action, const std::vector<std::string>& parts) {
    const std::string error = errorOf(action);
    for (const std::string& part : parts) EXPECT_NE(error.find(part), std::string::npos) << "'" << error << "'";
    EXPECT_EQ(error.find('\n'), std::string::npos) << "more than one line";
  }

  const tws::TemporaryFolder folder_;
  std::ostringstream log;
};

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Time, publisher, latching and bytes of each message, topic by topic.
std::map<std::string, std::vector<std::string>> messagesOf(const std::string& path) {
  std::map<std::string, std::vector<std::string>> messages;
  rosbag::Bag bag(path);
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) {
    std::string bytes(message.size(), '\0');
    ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()), message.size());
    message.write(stream);
    messages[message.getTopic()].push_back(std::to_string(message.getTime().toNSec()) + message.getCallerId() +
                                           (message.isLatching() ? " latched " : " ") + message.getMD5Sum() + bytes);
  }
  return messages;
}

std::vector<int> upTo(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) numbers[static_cast<std::size_t>(i)] = i;
  return numbers;
}

// If this fails, a disk that fills up costs all that was recorded, for a bag without index cannot be read.
TEST_F(BagTest, WhenTheDiskIsNearlyFullTheRecordingEndsAndCanBeRead) {
  const tws::FileSizeLimit limit(20U << 20U);
  const std::string complaint = recordTexts("full.bag", 200);
  EXPECT_NE(complaint.find("full.bag: the disk is nearly full (16 MB left)"), std::string::npos) << complaint;
  const rosbag::Bag bag(path("full.bag"));
  EXPECT_GE(rosbag::View(bag).size(), 20U);
}

// If this fails, a run on a full disk ends with "terminate called", and all other results are lost with it.
TEST_F(BagTest, AWriteThatFailsIsAnErrorThatNamesTheFile) {
  std::optional<tws::FileSizeLimit> limit;
  const std::string complaint = recordTexts("broken.bag", 20, [&](int i) {
    if (i == 5) limit.emplace(300000);
  });
  EXPECT_NE(complaint.find("broken.bag: cannot be written: "), std::string::npos) << complaint;
}

TEST_F(BagTest, ABagIsNotBegunWhereNothingFits) {
  const tws::FileSizeLimit limit(1000000);
  EXPECT_NE(recordTexts("none.bag", 1), "");
}

// If this fails, recorded data cannot be compared between two runs.
TEST_F(BagTest, TwoRecordingsOfTheSameRunAreTheSameFile) {
  const std::string first = contentOf(recordNumbers("first.bag"));
  EXPECT_FALSE(first.empty());
  EXPECT_TRUE(first == contentOf(recordNumbers("second.bag")));
}

// If this fails, a recording cannot be replayed with ROS's own tools: wrong times, no latching, no publisher.
TEST_F(BagTest, ARecordingHoldsDataTimesPublishersAndLatching) {
  rosbag::Bag bag(recordNumbers("times.bag"));
  rosbag::View view(bag);
  EXPECT_EQ(view.size(), 201u);
  EXPECT_EQ(view.getBeginTime(), ros::Time(5.0));
  EXPECT_EQ(view.getEndTime(), ros::Time(104.0));
  for (const rosbag::MessageInstance& message : view) {
    EXPECT_EQ(message.getCallerId(), "/counting");
    EXPECT_EQ(message.isLatching(), message.getTopic() == "/greeting");
    if (const auto number = message.instantiate<std_msgs::Int32>()) {
      EXPECT_EQ(message.getTime(), ros::Time(5.0 + number->data));
    }
  }
}

TEST_F(BagTest, ARecordingOfChosenTopicsHoldsOnlyThose) {
  rosbag::Bag bag(recordNumbers("chosen.bag", {"/numbers"}));
  EXPECT_EQ(rosbag::View(bag).size(), 100u);
}

TEST_F(BagTest, AReplayGivesANodeAllMessagesInOrderAtTheirTimes) {
  EXPECT_EQ(replay(recordNumbers("replay.bag")), upTo(100));
}

// If this fails, the bag that an offline run on a bag leaves behind lacks the sensor topics, or what no node of this
// build knows.
TEST_F(BagTest, TopicsThatNoNodeKnowsPassThroughAsTheyAre) {
  const std::string original = recordNumbers("original.bag");
  replay(original, path("copy.bag"));
  EXPECT_EQ(messagesOf(path("copy.bag")), messagesOf(original));
}

// If this fails, a tracker's old output is mixed with its new one.
TEST_F(BagTest, TopicsThatTheNodesPublishThemselvesAreNotReplayed) {
  const std::string bag = recordNumbers("own.bag");
  LocalGraph graph(log);
  int received = 0;
  graph.addNode("ear").subscribe<std_msgs::Int32>("/numbers", [&](const std_msgs::Int32&) { ++received; });
  graph.addNode("new").advertise<std_msgs::Int32>("/numbers");
  BagSource source(graph, bag);
  runOffline(graph, {&source});
  EXPECT_EQ(received, 0);
}

TEST_F(BagTest, TheDurationIsCountedFromTheFirstMessage) {
  const std::string bag = recordNumbers("duration.bag");
  LocalGraph graph(log);
  std::vector<int> received;
  graph.addNode("ear").subscribe<std_msgs::Int32>("/numbers",
                                                  [&](const std_msgs::Int32& m) { received.push_back(m.data); });
  BagSource source(graph, bag);
  EXPECT_EQ(source.endTime(), ros::Time(104.0));
  runOffline(graph, {&source}, ros::Duration(10.0));
  EXPECT_EQ(received, upTo(11));
}

// If this fails, of two sources the later one goes first and data time is wrong for the other.
TEST_F(BagTest, OfSeveralSourcesTheOneWithTheEarliestTimeGoesFirst) {
  const std::string bag = recordNumbers("several.bag");
  LocalGraph graph(log);
  std::vector<double> times;
  graph.addNode("ear").subscribe<std_msgs::Int32>(
      "/numbers", [&](const std_msgs::Int32&) { times.push_back(graph.now().toSec()); });
  Counting simulator(graph.addNode("counting"), 50);
  BagSource source(graph, bag, {"/numbers"});
  runOffline(graph, {&source, &simulator});
  EXPECT_EQ(times.size(), 150u);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

// If these fail, a damaged or foreign bag ends in a crash, in silence, or in numbers read from the wrong bytes.
TEST_F(BagTest, AMissingFileIsNamed) {
  LocalGraph graph(log);
  expectError([&] { BagSource(graph, "/nowhere/a.bag"); }, {"/nowhere/a.bag"});
}

TEST_F(BagTest, ABagCutShortAnywhereIsRefusedByName) {
  const std::string whole = contentOf(recordNumbers("whole.bag"));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{5}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    std::ofstream(path("cut.bag"), std::ios::binary) << whole.substr(0, size);
    expectError([&] { replay(path("cut.bag")); }, {path("cut.bag")});
  }
}

// If this fails, four damaged bytes ask for up to 4 GB of memory.
TEST_F(BagTest, ARecordLongerThanTheFileIsRefusedByNameAndPlace) {
  std::string bytes = contentOf(recordNumbers("whole.bag"));
  bytes.replace(13, 4, "\xff\xff\xff\x7f");  // the length of the first header, behind the line of the version
  std::ofstream(path("long.bag"), std::ios::binary) << bytes;
  expectError([&] { replay(path("long.bag")); }, {path("long.bag"), "at byte 13", "longer than the file"});
}

TEST_F(BagTest, ATopicOfAnotherTypeIsRefusedByNameAndTypes) {
  const std::string bag = recordNumbers("type.bag");
  LocalGraph graph(log);
  graph.addNode("ear").subscribe<std_msgs::String>("/numbers", [](const std_msgs::String&) {});
  expectError([&] { BagSource(graph, bag); }, {bag, "/numbers", "std_msgs/Int32", "std_msgs/String"});
}

TEST_F(BagTest, ATopicThatIsNotInTheBagIsNamed) {
  const std::string bag = recordNumbers("absent.bag");
  LocalGraph graph(log);
  expectError([&] { BagSource(graph, bag, {"/letters"}); }, {bag, "/letters"});
}

TEST_F(BagTest, AMessageWithTooFewBytesIsNamedAndTheNextOneFollows) {
  MessageType half = messageType<std_msgs::Int32>();
  half.length = [](const void*) -> std::uint32_t { return 2; };
  half.write = [](const void*, ros::serialization::OStream& stream) { stream.next(std::uint16_t{7}); };
  std_msgs::Int32 good;
  good.data = 3;
  {
    rosbag::Bag bag(path("short.bag"), rosbag::bagmode::Write);
    bag.write("/numbers", ros::Time(7.5), AnyMessage{&half, boost::make_shared<int>(0)});
    bag.write("/numbers", ros::Time(8.0), good);
  }
  LocalGraph graph(log);
  std::vector<int> received;
  graph.addNode("ear").subscribe<std_msgs::Int32>("/numbers",
                                                  [&](const std_msgs::Int32& m) { received.push_back(m.data); });
  BagSource source(graph, path("short.bag"));
  expectError([&] { source.step(); }, {path("short.bag"), "/numbers", "7.5"});
  source.step();
  graph.drain();
  EXPECT_EQ(received, std::vector<int>{3});
  EXPECT_FALSE(source.nextTime());
}

TEST_F(BagTest, AListLongerThanAnyMemoryIsNamed) {
  MessageType endless = messageType<tws_msgs::Truth>();
  endless.length = [](const void*) -> std::uint32_t { return 20; };
  endless.write = [](const void*, ros::serialization::OStream& stream) {
    for (int i = 0; i < 4; ++i) stream.next(std::uint32_t{0});  // the header
    stream.next(std::uint32_t{0xffffffff});
  };
  {
    rosbag::Bag bag(path("endless.bag"), rosbag::bagmode::Write);
    bag.write("/truth", ros::Time(7.5), AnyMessage{&endless, boost::make_shared<int>(0)});
  }
  LocalGraph graph(log);
  graph.addNode("ear").subscribe<tws_msgs::Truth>("/truth", [](const tws_msgs::Truth&) {});
  BagSource source(graph, path("endless.bag"));
  expectError([&] { source.step(); }, {path("endless.bag"), "/truth", "7.5", "too long"});
}

TEST_F(BagTest, ARecordingThatCannotBeWrittenIsRefusedByName) {
  LocalGraph graph(log);
  expectError([&] { graph.record("/nowhere/run.bag"); }, {"/nowhere/run.bag"});
}

}  // namespace
}  // namespace tws_runtime
