#include "bag_contents.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/GraphDescription.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>

namespace track_evaluation {
namespace {

using Names = std::vector<std::string>;

/// What a bag with tracks, detections and truth under these topics holds.
BagContents contentsOf(const std::string& tracks, const std::string& detections, const std::string& truth,
                       const std::string& graph = "") {
  const tws::TemporaryFolder folder;
  const std::string path = folder.file("run.bag");
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.write(tracks, ros::Time(1.0), tws_msgs::Tracks());
  bag.write(detections, ros::Time(1.0), tws_msgs::Detections());
  bag.write(truth, ros::Time(1.0), tws_msgs::Truth());
  tws_msgs::GraphDescription description;
  description.yaml = graph;
  if (!graph.empty()) bag.write("/graph", ros::Time(1.0), description);
  bag.close();
  return inspectBag(path);
}

// If one of these fails, a bag from elsewhere is scored under odd names, or not at all.

TEST(BagContents, ReadsTopicsWithAndWithoutALeadingSlash) {
  for (const std::string slash : {"/", ""}) {
    const BagContents contents = contentsOf(slash + "adit/tracks", slash + "sps12/detections", slash + "truth");
    EXPECT_EQ(contents.space, "");
    EXPECT_EQ(contents.trackers, (Names{"adit"}));
    EXPECT_EQ(contents.radars, (Names{"sps12"}));
    EXPECT_EQ(contents.truth, "/truth");
    EXPECT_EQ(contents.topics(), (Names{"/adit/tracks", "/sps12/detections", "/truth"}));
  }
}

TEST(BagContents, NamesTrackersWithinTheNamespaceThatAllShare) {
  const BagContents contents = contentsOf("/ship1/adit/tracks", "/ship1/sps12/detections", "/truth");
  EXPECT_EQ(contents.space, "/ship1");
  EXPECT_EQ(contents.trackers, (Names{"adit"}));
  EXPECT_EQ(contents.remaps().at("/ship1/truth"), "/truth");  // Where the evaluation looks for it.
  EXPECT_EQ(contents.topics(), (Names{"/ship1/adit/tracks", "/ship1/sps12/detections", "/truth"}));
}

TEST(BagContents, NamesTrackersOfSeveralNamespacesInFull) {
  const BagContents contents = contentsOf("/ship1/adit/tracks", "/ship2/sps12/detections", "/truth");
  EXPECT_EQ(contents.space, "");
  EXPECT_EQ(contents.trackers, (Names{"ship1/adit"}));
  EXPECT_EQ(contents.radars, (Names{"ship2/sps12"}));
}

TEST(BagContents, KnowsTheOriginWhereTheGraphSaysIt) {
  const auto origin_of = [](const std::string& parameters) {
    return contentsOf("/adit/tracks", "/sps12/detections", "/truth",
                      "nodes: [{type: evaluation_node, parameters: " + parameters + "}]")
        .origin;
  };
  EXPECT_TRUE(origin_of("{origin: {latitude_deg: 48}}").IsMap());
  EXPECT_FALSE(origin_of("{period_s: 5}").IsMap());  // Of a bag that was recorded from a bag.
}

}  // namespace
}  // namespace track_evaluation
