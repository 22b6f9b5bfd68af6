#include "run_input.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>

#include "temporary_folder_test_helpers.h"

namespace tws_launch {
namespace {

// The tracker listens to the radars that are named here: one that is missed is never tracked.

std::string reasonOfRefusal(const std::string& path) {
  try {
    inspectInput(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(RunInput, OfAScenarioHasItsRadarsByNameAndItsLength) {
  const TemporaryFolder folder;
  const RunInput input = inspectInput(
      folder.write("two.yaml", "duration_s: 42\nradars: [{name: zeta, type: SPS-12}, {name: alpha, type: SPS-39}]\n"));
  EXPECT_FALSE(input.is_bag);
  EXPECT_EQ(input.radars, (std::vector<std::string>{"alpha", "zeta"}));  // In one order, as from its bag.
  EXPECT_EQ(input.length, 42.0);
}

// If this fails, the secondary radar is neither recorded nor drawn.
TEST(RunInput, NamesTheSecondaryRadarsOfAScenarioAndOfABag) {
  const TemporaryFolder folder;
  const std::string path = folder.write("ssr.yaml", "radars: [{name: a}]\nsecondary_radars: [{name: z}, {name: s}]\n");
  EXPECT_EQ(inspectInput(path).secondary_radars, (std::vector<std::string>{"s", "z"}));
  EXPECT_EQ(inspectInput(path).radars, (std::vector<std::string>{"a"}));
  rosbag::Bag bag(folder.file("run.bag"), rosbag::bagmode::Write);
  bag.write("/sps12/detections", ros::Time(100.0), tws_msgs::Detections());
  bag.write("/ssr/plots", ros::Time(100.0), tws_msgs::SsrPlots());
  bag.close();
  EXPECT_EQ(inspectInput(folder.file("run.bag")).secondary_radars, (std::vector<std::string>{"ssr"}));
}

// If this fails, trackers run beside tracks that are fed in their place, or nobody correlates them.
TEST(RunInput, SaysWhetherAScenarioOrABagFeedsTracks) {
  const TemporaryFolder folder;
  EXPECT_FALSE(inspectInput(folder.write("plots.yaml", "radars: [{name: a}]\n")).feeds_tracks);
  EXPECT_TRUE(
      inspectInput(folder.write("fed.yaml", "radars: [{name: a}]\ntrack_feed: {clock_radar: a}\n")).feeds_tracks);
  rosbag::Bag bag(folder.file("run.bag"), rosbag::bagmode::Write);
  bag.write("/a/detections", ros::Time(100.0), tws_msgs::Detections());
  bag.write("/primary/tracks", ros::Time(100.0), tws_msgs::Tracks());
  bag.close();
  EXPECT_TRUE(inspectInput(folder.file("run.bag")).feeds_tracks);
}

// If this fails, an array's dwells are neither framed nor tracked nor recorded.
TEST(RunInput, NamesTheArrayRadarsOfAScenarioAndOfABagThatMayHaveNoOthers) {
  const TemporaryFolder folder;
  const RunInput scenario = inspectInput(folder.write("esa.yaml", "array_radars: [{name: z}, {name: e}]\n"));
  EXPECT_EQ(scenario.array_radars, (std::vector<std::string>{"e", "z"}));
  EXPECT_TRUE(scenario.radars.empty());
  rosbag::Bag bag(folder.file("run.bag"), rosbag::bagmode::Write);
  bag.write("/esa/dwell_reports", ros::Time(100.0), tws_msgs::DwellReports());
  bag.write("/esa/dwell_reports", ros::Time(120.0), tws_msgs::DwellReports());
  bag.close();
  const RunInput recorded = inspectInput(folder.file("run.bag"));
  EXPECT_EQ(recorded.array_radars, (std::vector<std::string>{"esa"}));
  EXPECT_TRUE(recorded.radars.empty());
  EXPECT_EQ(recorded.length, 20.0);
}

// If this fails, the progress shown knows no end.
TEST(RunInput, OfAScenarioThatDoesNotSayHasTheSimulatorsLength) {
  const TemporaryFolder folder;
  const std::string path = folder.write("short.yaml", "radars: [{name: a}]\n");
  EXPECT_EQ(inspectInput(path).length, 300.0);  // As radar_sim/README.md says.
  EXPECT_EQ(inspectInput(path, 12.0).length, 12.0);
  EXPECT_EQ(inspectInput(path, 4000.0).length, 4000.0);
}

TEST(RunInput, OfABagHasTheRadarsOfItsDetectionsAndTheTimeBetweenFirstAndLast) {
  const TemporaryFolder folder;
  rosbag::Bag bag(folder.file("run.bag"), rosbag::bagmode::Write);
  bag.write("/sps12/detections", ros::Time(100.0), tws_msgs::Detections());
  bag.write("/sps39/detections", ros::Time(130.0), tws_msgs::Detections());
  bag.close();
  const RunInput input = inspectInput(folder.file("run.bag"));
  EXPECT_TRUE(input.is_bag);
  EXPECT_EQ(input.radars, (std::vector<std::string>{"sps12", "sps39"}));
  EXPECT_EQ(input.length, 30.0);
  EXPECT_EQ(inspectInput(folder.file("run.bag"), 12.0).length, 12.0);
  EXPECT_EQ(inspectInput(folder.file("run.bag"), 4000.0).length, 30.0);  // There is no more in it.
}

TEST(RunInput, WithoutARadarIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("none.yaml", "duration_s: 42\n");
  EXPECT_EQ(reasonOfRefusal(path), path + ": no primary radar in it");
}

TEST(RunInput, ThatCannotBeReadIsRefusedByName) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.write("bad.yaml", "radars: [\n"), folder.write("bad.bag", "no bag"),
                                  std::string("/nowhere.yaml"), std::string("/nowhere.bag")})
    EXPECT_EQ(reasonOfRefusal(path).substr(0, path.size() + 1), path + ":");
}

// If this fails, the user of a scenario with a slip in it hears of it from a node that died, or not where it is.
TEST(RunInput, OfAWrongScenarioIsRefusedInOneLineWithFileAndLine) {
  const TemporaryFolder folder;
  const std::string path = folder.file("slip.yaml");
  for (const auto& [content, line, reason] : {std::tuple{"radars:\n  - {type: SPS-12}\n", 2, "name"},
                                              {"radars: [{name: a}]\nduraton_s: 42\n", 2, "duraton_s"},
                                              {"radars: [{name: a}]\n\nduration_s: long\n", 3, "duration_s"}}) {
    folder.write("slip.yaml", content);
    const std::string said = reasonOfRefusal(path);
    EXPECT_EQ(said.find(path + ":" + std::to_string(line) + ":"), 0U) << said;
    EXPECT_NE(said.find(reason), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace tws_launch
