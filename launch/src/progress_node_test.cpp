#include "progress_node.h"

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>

#include <sstream>

namespace tws_launch {
namespace {

// Who starts a long run wants to know whether it works and when it ends.

tws_msgs::Detections detections(double time, std::size_t plots) {
  tws_msgs::Detections message;
  message.header.stamp = ros::Time(time);
  message.radar = "a";
  message.detections.resize(plots);
  return message;
}

TEST(Progress, SaysTimeTracksPlotsPerSecondAndWhatIsLeft) {
  RunSummary summary;
  summary.add(detections(1000.0, 100));
  summary.add(detections(1030.0, 200));
  tws_msgs::Tracks tracks;
  tracks.tracks.resize(1);
  tracks.tracks[0].state = tws_msgs::Track::FIRM;
  tracks.header.stamp = ros::Time(1029.0);
  summary.add(tracks);
  // 30 of 120 s took 3 s of wall time, so the other 90 s take 9 s.
  EXPECT_EQ(progressLine(summary, 120.0, 3.0, 100.0),
            "30.0 of 120.0 s simulated (25 %), 1 tracks, 100 plots/s, 9 s left");
}

// If this fails, the picture of a tracker that stands is taken for the one of now.
TEST(Progress, TracksThatAreNotOfNowAreSaidWithTheirTime) {
  RunSummary summary;
  tws_msgs::Tracks tracks;
  tracks.tracks.resize(1);
  tracks.tracks[0].state = tws_msgs::Track::FIRM;
  tracks.header.stamp = ros::Time(1010.0);
  summary.add(detections(1000.0, 100));
  summary.add(tracks);
  summary.add(detections(1030.0, 200));
  EXPECT_EQ(progressLine(summary, 0.0, 3.0, 7.0), "30.0 s simulated, 1 tracks as of 10.0 s, 7 plots/s");
}

TEST(Progress, OfARunOfUnknownLengthSaysNoPercentAndNoRest) {
  RunSummary summary;
  summary.add(detections(5.0, 1));
  summary.add(detections(7.5, 1));
  EXPECT_EQ(progressLine(summary, 0.0, 1.0, 2.0), "2.5 s simulated, 0 tracks, 2 plots/s");
}

TEST(Progress, HearsTheRadarsItIsTold) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  ProgressNode progress(graph.addNode("progress", YAML::Load("{radars: [a], trackers: [adit], length: 10}")), log);
  auto publisher = graph.addNode("a").advertise<tws_msgs::Detections>("/a/detections");
  publisher.publish(detections(1.0, 3));
  graph.drain();
  EXPECT_EQ(progress.summary().plots(), 3U);
}

TEST(Progress, RefusesAParameterItDoesNotKnow) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  tws_runtime::Bus& bus = graph.addNode("progress", YAML::Load("{lenght: 10}"));
  EXPECT_THROW(ProgressNode(bus, log), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace tws_launch
