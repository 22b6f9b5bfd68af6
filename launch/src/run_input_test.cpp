#include "run_input.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tws_msgs/Detections.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace tws_launch {
namespace {

// The tracker listens to the radars that are named here: one that is missed is never tracked.

/// A file that goes when the test ends.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& ending, const std::string& content = "")
      : path("/tmp/run_input_test_" + std::to_string(getpid()) + ending) {
    std::ofstream(path) << content;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::remove(path.c_str()); }

  const std::string path;
};

std::string reasonOfRefusal(const std::string& path) {
  try {
    inspectInput(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(RunInput, OfAScenarioHasItsRadarsByNameAndItsLength) {
  const TemporaryFile file(".yaml",
                           "duration_s: 42\nradars: [{name: zeta, type: SPS-12}, {name: alpha, type: SPS-39}]\n");
  const RunInput input = inspectInput(file.path);
  EXPECT_FALSE(input.is_bag);
  EXPECT_EQ(input.radars, (std::vector<std::string>{"alpha", "zeta"}));  // In one order, as from its bag.
  EXPECT_EQ(input.length, 42.0);
}

TEST(RunInput, OfABagHasTheRadarsOfItsDetectionsAndTheTimeBetweenFirstAndLast) {
  const TemporaryFile file(".bag");
  rosbag::Bag bag(file.path, rosbag::bagmode::Write);
  bag.write("/sps12/detections", ros::Time(100.0), tws_msgs::Detections());
  bag.write("/sps39/detections", ros::Time(130.0), tws_msgs::Detections());
  bag.close();
  const RunInput input = inspectInput(file.path);
  EXPECT_TRUE(input.is_bag);
  EXPECT_EQ(input.radars, (std::vector<std::string>{"sps12", "sps39"}));
  EXPECT_EQ(input.length, 30.0);
}

TEST(RunInput, WithoutARadarIsRefused) {
  const TemporaryFile file(".yaml", "duration_s: 42\n");
  EXPECT_EQ(reasonOfRefusal(file.path), file.path + ": no rotating radar in it");
}

TEST(RunInput, ThatCannotBeReadIsRefusedByName) {
  const TemporaryFile yaml(".yaml", "radars: [\n");
  const TemporaryFile bag(".bag", "no bag");
  for (const std::string& path : {yaml.path, bag.path, std::string("/nowhere.yaml"), std::string("/nowhere.bag")})
    EXPECT_EQ(reasonOfRefusal(path).substr(0, path.size() + 2), path + ": ");
}

}  // namespace
}  // namespace tws_launch
