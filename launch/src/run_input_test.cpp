#include "run_input.h"

#include <gtest/gtest.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>

#include "input_test_helpers.h"

namespace tws_launch {
namespace {

using Names = std::vector<std::string>;
using tws_msgs::Detections;
using tws_msgs::SectorMark;

// The trackers hear the radars that are found here: one that is missed is never tracked.

RunInput read(const std::string& path, const RunOptions& said = {}) { return inspectInput(path, graphFile(), said); }

std::string reasonOfRefusal(const std::string& path, const RunOptions& said = {}) {
  return reasonOf([&] { read(path, said); });
}

TEST(RunInput, OfAScenarioHasItsSensorsInOneOrderAndItsLength) {
  const TemporaryFolder folder;
  const RunInput input =
      read(folder.write("all.yaml",
                        "duration_s: 42\nradars: [{name: zeta}, {name: alpha}, {name: sps39, type: SPS-39}]\n"
                        "secondary_radars: [{name: z}, {name: s}]\narray_radars: [{name: e}]\n"));
  EXPECT_EQ(input.kind, InputKind::kScenario);
  EXPECT_EQ(input.names("rotating"), (Names{"sps39", "alpha", "zeta"}));  // The report's radars first; as from a bag.
  EXPECT_EQ(input.names("secondary"), (Names{"s", "z"}));
  EXPECT_EQ(input.names("array"), (Names{"e"}));
  EXPECT_TRUE(input.names("fed").empty());
  EXPECT_EQ(input.length, 42.0);
}

// If this fails, trackers run beside tracks that are fed in their place, or nobody correlates them.
TEST(RunInput, SaysWhetherAScenarioOrABagFeedsTracks) {
  const TemporaryFolder folder;
  const RunInput fed = read(folder.write("fed.yaml", "radars: [{name: a}]\ntrack_feed: {clock_radar: a}\n"));
  EXPECT_EQ(fed.names("fed"), (Names{"primary", "secondary"}));
  BagUnderTest(folder.file("run.bag"))
      .withRadar("/", "a")
      .with("/primary/tracks", tws_msgs::Tracks())
      .with("/adit/tracks", tws_msgs::Tracks())
      .close();
  EXPECT_EQ(read(folder.file("run.bag")).names("fed"), (Names{"primary"}));
}

TEST(RunInput, OfABagHasItsSensorsByTheirTypesAndTheTimeBetweenFirstAndLast) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag"))
      .with("/sps12/detections", of<Detections>("sps12"))
      .with("/ssr/plots", of<tws_msgs::SsrPlots>("ssr"))
      .with("/esa/dwell_reports", of<tws_msgs::DwellReports>("esa"))
      .with("/mrs/range_profile", of<tws_msgs::RangeProfile>("mrs"))
      .with("/a/detections", of<Detections>("a"))
      .with("/other", tws_msgs::Tracks())
      .close();
  const RunInput input = read(folder.file("run.bag"));
  EXPECT_EQ(input.kind, InputKind::kBag);
  EXPECT_EQ(input.names("rotating"), (Names{"sps12", "a"}));
  EXPECT_EQ(input.names("secondary"), (Names{"ssr"}));
  EXPECT_EQ(input.names("array"), (Names{"esa"}));
  EXPECT_EQ(input.names("range"), (Names{"mrs"}));
  EXPECT_EQ(input.length, 4.0);
  EXPECT_TRUE(input.space.empty());
  EXPECT_TRUE(input.remaps.empty());
  EXPECT_EQ(read(folder.file("run.bag"), options({{"duration", "2"}})).length, 2.0);
  EXPECT_EQ(read(folder.file("run.bag"), options({{"duration", "4000"}})).length, 4.0);  // There is no more in it.
}

// A bag that another tool wrote. If this fails, its radars are named "ps12" and never tracked.
TEST(RunInput, ReadsTopicsWithoutALeadingSlash) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("", "sps12").close();
  const RunInput input = read(folder.file("run.bag"));
  EXPECT_EQ(input.names("rotating"), (Names{"sps12"}));
  EXPECT_EQ(input.topics.at("/sps12/detections"), "sps12/detections");
  EXPECT_TRUE(input.remaps.empty());
}

// If this fails, a ship's bag has four radars of the name of the ship.
TEST(RunInput, TakesTheNamespaceThatAllTopicsShareForTheGraphs) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("/ship1/", "sps12").withRadar("/ship1/", "sps39").close();
  const RunInput input = read(folder.file("run.bag"));
  EXPECT_EQ(input.names("rotating"), (Names{"sps12", "sps39"}));
  EXPECT_EQ(input.space, "/ship1");
  EXPECT_TRUE(input.remaps.empty());
}

// If this fails, a radar whose driver has another topic than ours is refused, or tracked under a name that is not its.
TEST(RunInput, FindsARadarUnderAnyTopicByTheNameInItsMessages) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag"))
      .with("/north/video/plots", of<Detections>("sps12"))
      .with("/north/marks", of<SectorMark>("sps12"))
      .withRadar("/", "sps39")
      .close();
  const RunInput input = read(folder.file("run.bag"));
  EXPECT_EQ(input.names("rotating"), (Names{"sps12", "sps39"}));
  EXPECT_EQ(input.remaps, (std::map<std::string, std::string>{{"/sps12/detections", "/north/video/plots"},
                                                              {"/sps12/sector_marks", "/north/marks"}}));
}

TEST(RunInput, RefusesTwoRadarsOfOneNameUnlessANamespaceIsChosen) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("/ship1/", "sps12").withRadar("/ship2/", "sps12").close();
  const std::string path = folder.file("run.bag");
  EXPECT_EQ(reasonOfRefusal(path), path +
                                       ": two radars are named sps12: /ship1/sps12/detections and "
                                       "/ship2/sps12/detections; choose those of one namespace by --namespace");
  const RunInput input = read(path, options({{"namespace", "ship2"}}));
  EXPECT_EQ(input.space, "/ship2");
  EXPECT_TRUE(input.remaps.empty());
}

TEST(RunInput, RefusesDetectionsOfNobodyKnowsWhichRadar) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).with("/plots", Detections()).close();
  const std::string path = folder.file("run.bag");
  EXPECT_EQ(reasonOfRefusal(path), path +
                                       ": topic /plots holds tws_msgs/Detections, but neither its messages nor its "
                                       "name say of which radar");
}

// If this fails, the progress shown knows no end.
TEST(RunInput, OfAScenarioThatDoesNotSayHasTheSimulatorsLength) {
  const TemporaryFolder folder;
  const std::string path = folder.write("short.yaml", "radars: [{name: a}]\n");
  EXPECT_EQ(read(path).length, 300.0);  // As radar_sim/doc/scenario.md says.
  EXPECT_EQ(read(path, options({{"duration", "12"}})).length, 12.0);
  EXPECT_EQ(read(path, options({{"duration", "4000"}})).length, 4000.0);
}

TEST(RunInput, WithoutARadarIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("none.yaml", "duration_s: 42\n");
  EXPECT_EQ(reasonOfRefusal(path), path + ": no primary radar in it");
  BagUnderTest(folder.file("run.bag")).with("/adit/tracks", tws_msgs::Tracks()).close();
  EXPECT_EQ(reasonOfRefusal(folder.file("run.bag")), folder.file("run.bag") + ": no primary radar in it");
}

TEST(RunInput, ThatCannotBeReadIsRefusedByName) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.write("bad.yaml", "radars: [\n"), folder.write("bad.bag", "no bag"),
                                  std::string("/nowhere.yaml"), std::string("/nowhere.bag")})
    EXPECT_EQ(reasonOfRefusal(path).substr(0, path.size() + 1), path + ":");
}

// If this fails, a renamed bag is taken for a radar's recording.
TEST(RunInput, KnowsABagByItsContent) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.20261129")).withRadar("/", "a").close();
  EXPECT_EQ(read(folder.file("run.20261129")).kind, InputKind::kBag);
}

// If this fails, the user of a scenario with a slip in it learns of it from a node that died, or not where it is.
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
