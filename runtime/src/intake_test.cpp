#include <tws_runtime/intake.h>

#include <gtest/gtest.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/local_graph.h>

#include <sstream>
#include <vector>

namespace tws_runtime {
namespace {

constexpr double kDay = 86400.0;

class IntakeTest : public ::testing::Test {
 protected:
  IntakeTest() {
    intake.subscribe<tws_msgs::SectorMark>({"/a/sector_marks", "a", StampOrder::kNotBackward},
                                           [this](const auto& mark) { marks.push_back(mark.header.stamp.toSec()); });
    intake.subscribe<tws_msgs::Tracks>({"/b/tracks"},
                                       [this](const auto& m) { tracks.push_back(m.header.stamp.toSec()); });
  }

  void sendMark(double time, const std::string& radar = "a") {
    tws_msgs::SectorMark mark;
    mark.header.stamp = ros::Time(time);
    mark.radar = radar;
    mark_topic.publish(mark);
    graph.drain();
  }
  void sendTracks(double time) {
    tws_msgs::Tracks message;
    message.header.stamp = ros::Time(time);
    track_topic.publish(message);
    graph.drain();
  }
  std::uint64_t count(const std::string& name) { return node.counter(name).value(); }

  std::ostringstream log;
  LocalGraph graph{log};
  Bus& node = graph.addNode("tracker");
  Publisher<tws_msgs::SectorMark> mark_topic = node.advertise<tws_msgs::SectorMark>("/a/sector_marks");
  Publisher<tws_msgs::Tracks> track_topic = node.advertise<tws_msgs::Tracks>("/b/tracks");
  std::vector<double> marks, tracks, new_runs;
  Intake intake{node, 5.0, [this](double time) {
                  new_runs.push_back(time);
                  marks.clear();
                  tracks.clear();
                }};
};

// If this fails, one damaged message ends all tracks of a node.
TEST_F(IntakeTest, AStrayStampIsLeftOutAndNamed) {
  for (const double off : {kDay, -kDay, 10.0, -10.0}) {
    marks.clear();
    sendMark(2 * kDay);
    sendTracks(2 * kDay);
    sendMark(2 * kDay + off);
    sendTracks(2 * kDay + off);
    sendMark(2 * kDay);
    EXPECT_EQ(marks.size(), 2u) << off;
  }
  EXPECT_TRUE(new_runs.empty());
  EXPECT_EQ(count("stray messages"), 8u);
  EXPECT_NE(log.str().find("the stamp is out of line: held back until others agree with it in /a/sector_marks at "
                           "259200.000000 s"),
            std::string::npos)
      << log.str();
}

// If this fails, a bag that is played again shows the tracks of the first time, or loses its first second.
TEST_F(IntakeTest, ANewRunLosesNothing) {
  for (int i = 0; i < 20; ++i) sendMark(100.0 + 0.1 * i);
  for (int i = 0; i < 20; ++i) {
    sendMark(1.0 + 0.1 * i);
    sendTracks(1.0 + 0.1 * i);
  }
  ASSERT_EQ(new_runs.size(), 1u);
  EXPECT_EQ(new_runs[0], 1.0);
  EXPECT_EQ(marks.size(), 20u);
  EXPECT_EQ(tracks.size(), 20u);
  EXPECT_EQ(count("new runs"), 1u);
}

// If this fails, a live tracker takes the burst at the beginning of a new run for overload, and skips it.
TEST_F(IntakeTest, SaysThatWhatItGivesWasHeldBack) {
  std::vector<bool> held_back;
  intake.subscribe<tws_msgs::SectorMark>({"/c/sector_marks"},
                                         [&](const auto&) { held_back.push_back(intake.isReleasing()); });
  Publisher<tws_msgs::SectorMark> topic = node.advertise<tws_msgs::SectorMark>("/c/sector_marks");
  tws_msgs::SectorMark mark;
  for (int i = 0; i < 20; ++i) {
    mark.header.stamp = ros::Time(i == 0 ? 100.0 : 1.0 + 0.1 * i);
    topic.publish(mark);
    graph.drain();
  }
  ASSERT_EQ(new_runs.size(), 1u);
  ASSERT_EQ(held_back.size(), 20u);
  EXPECT_FALSE(held_back.front()) << "nothing was held back before";
  EXPECT_TRUE(held_back[1]);
  EXPECT_FALSE(held_back.back()) << "the run is new, and goes on by itself";
}

TEST_F(IntakeTest, APauseIsNoNewRun) {
  sendMark(100.0);
  for (int i = 0; i < 20; ++i) sendMark(1000.0 + 0.1 * i);
  EXPECT_TRUE(new_runs.empty());
  EXPECT_EQ(marks.size(), 21u);
  EXPECT_EQ(count("pauses"), 1u);
}

TEST_F(IntakeTest, LateMessagesAreCountedWhereOrderMatters) {
  sendMark(100.0);
  sendMark(99.0);
  sendTracks(99.0);
  sendTracks(98.0);
  EXPECT_EQ(marks.size(), 1u);
  EXPECT_EQ(tracks.size(), 2u);
  EXPECT_EQ(count("late messages"), 1u);
}

// If these fail, one source's clock ends what others hold, or nobody learns which one it was.
TEST_F(IntakeTest, ASourceWhoseClockIsOffIsSetAsideNamedAndJoinedAgain) {
  for (int i = 0; i < 600; ++i) {
    sendTracks(5000.0 + 0.1 * i);
    sendMark(5000.0 + 0.1 * i - (i >= 200 && i < 400 ? 3600.0 : 0.0));
  }
  EXPECT_TRUE(new_runs.empty());
  EXPECT_EQ(tracks.size(), 600u);
  EXPECT_EQ(marks.size(), 400u);
  EXPECT_EQ(count("set aside"), 1u);
  EXPECT_EQ(count("joined again"), 1u);
  EXPECT_NE(log.str().find("off the others': left out until it agrees with them in /a/sector_marks at 1421.000000 s"),
            std::string::npos)
      << log.str();
}

TEST_F(IntakeTest, ASecondPublisherIsNamed) {
  for (int i = 0; i < 20; ++i) {
    sendMark(5000.0 + 0.1 * i);
    sendMark(1000.0 + 0.1 * i);
  }
  EXPECT_EQ(marks.size(), 20u);
  EXPECT_EQ(count("messages of a second publisher"), 18u);
}

// If this fails, a node that stood still leaves out what its sockets have kept for it.
TEST_F(IntakeTest, ABacklogOfOneTopicIsTakenAndSaid) {
  sendTracks(100.0);
  for (int i = 0; i < 900; ++i) sendMark(100.0 + 0.1 * i);
  for (int i = 1; i < 900; ++i) sendTracks(100.0 + 0.1 * i);
  EXPECT_EQ(tracks.size(), 900u);
  EXPECT_EQ(count("backlogs"), 1u);
  EXPECT_TRUE(new_runs.empty());
}

TEST_F(IntakeTest, AStampAtTheEndOfTimeIsRefused) {
  sendMark(4294967295.5);
  sendMark(100.0);
  EXPECT_EQ(marks.size(), 1u);
  EXPECT_EQ(count("bad messages"), 1u);
}

// If this fails, a radar under a remapped topic is refused, or a stray message of another one is taken for its own.
TEST_F(IntakeTest, TheNameThatThePublisherUsesCounts) {
  EXPECT_EQ(intake.radarOf("/a/sector_marks"), "a");
  sendMark(100.0, "myradar");
  sendMark(100.1, "other");
  sendMark(100.2, "myradar");
  EXPECT_EQ(marks.size(), 2u);
  EXPECT_EQ(intake.radarOf("/a/sector_marks"), "myradar");
  EXPECT_EQ(count("bad messages"), 1u);
  EXPECT_EQ(log.str(),
            "tracker: bad messages (1): radar 'other', expected 'myradar' in /a/sector_marks at 100.100000 s\n");
}

TEST_F(IntakeTest, AStrayFirstNameIsGotOver) {
  sendMark(100.0, "other");
  for (int i = 1; i < 10; ++i) sendMark(100.0 + 0.1 * i);
  EXPECT_EQ(count("bad messages"), 2u);
  EXPECT_EQ(marks.size(), 8u);
}

}  // namespace
}  // namespace tws_runtime
