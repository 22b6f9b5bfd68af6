#include "metrics_file.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <sstream>

namespace track_evaluation {
namespace {

// Scripts of users read metrics.json; people read the table.

RunScore example() {
  RequirementRow row{"en route", "long gaps", "", 0.5, 0.01, false};
  RequirementRow unknown{"en route", "Mode C detection", "", std::nan(""), 0.96, true};
  return {
      "a \"b\"\\c", {{"cutoff_m", 1000.0}}, {{"adit", {{"ospa_m", 0.1}, {"x", std::nan("")}}, {}, {}, {row, unknown}}}};
}

TEST(MetricsFile, IsJsonThatOthersRead) {
  std::ostringstream out;
  writeJson(out, example());
  const YAML::Node tree = YAML::Load(out.str());  // JSON is YAML.
  EXPECT_EQ(tree["version"].as<int>(), 1);
  EXPECT_EQ(tree["input"].as<std::string>(), "a \"b\"\\c");
  const YAML::Node adit = tree["trackers"]["adit"];
  EXPECT_EQ(adit["metrics"]["ospa_m"].as<double>(), 0.1);  // Every digit is there.
  EXPECT_TRUE(adit["metrics"]["x"].IsNull());
  EXPECT_EQ(adit["requirements"][0]["passed"].as<bool>(), false);
  EXPECT_TRUE(adit["requirements"][1]["passed"].IsNull());
}

TEST(MetricsFile, OfNoTrackerIsJsonToo) {
  std::ostringstream out;
  writeJson(out, {});
  EXPECT_EQ(YAML::Load(out.str())["trackers"].size(), 0U);
}

TEST(MetricsFile, ItsTableSaysPassAndFail) {
  std::ostringstream out;
  writeTable(out, example());
  EXPECT_NE(out.str().find("FAIL"), std::string::npos) << out.str();
  EXPECT_EQ(out.str().find("pass"), std::string::npos) << out.str();
}

TEST(MetricsFile, NumbersAreShortForPeople) {
  EXPECT_EQ(inShort(1234.56), "1235");
  EXPECT_EQ(inShort(12.345), "12.3");
  EXPECT_EQ(inShort(0.97341), "0.9734");
  EXPECT_EQ(inShort(60.0), "60");
  EXPECT_EQ(inShort(std::nan("")), "-");
}

}  // namespace
}  // namespace track_evaluation
