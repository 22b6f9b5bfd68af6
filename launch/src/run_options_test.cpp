#include "run_options.h"

#include <gtest/gtest.h>

#include <tws_core/temporary_folder_test_helpers.h>
#include "command_words.h"

namespace tws_launch {
namespace {

using tws::TemporaryFolder;

// If one of these fails, a slip on the command line is silently something else than what was meant.

std::string refusal(const std::vector<std::string>& words, const std::set<std::string>& allowed = {}) {
  try {
    readCommandWords(words, allowed, {"out"}, 1);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(RunOptions, AreReadAsWordsOfACommandAndAsRoslaunchHasThem) {
  const CommandWords read =
      readCommandWords({"x.yaml", "--rate", "5", "seed:=3", "--no-rviz", "duration:=", "--out", "/o"}, {}, {"out"}, 1);
  EXPECT_EQ(read.arguments, (std::vector<std::string>{"x.yaml"}));
  EXPECT_EQ(read.options["rate"], "5");
  EXPECT_EQ(read.options["seed"], "3");
  EXPECT_EQ(read.options["rviz"], "false");
  EXPECT_FALSE(read.options.has("duration"));
  EXPECT_EQ(read.others.at("out"), "/o");
}

TEST(RunOptions, AreCheckedOneByOne) {
  EXPECT_EQ(refusal({"--rate", "fast"}), "--rate wants a number from 0 to 1000000, not 'fast'");
  EXPECT_EQ(refusal({"--duration", "0.5"}), "--duration wants a number from 1 to 1000000, not '0.5'");
  EXPECT_EQ(refusal({"--seed", "-3"}), "--seed wants a whole number from 0, not '-3'");
  EXPECT_EQ(refusal({"rviz:=maybe"}), "--rviz wants true or false, not 'maybe'");
  EXPECT_EQ(refusal({"--clutter-map", "/nowhere"}), "--clutter-map: no file '/nowhere'");
  EXPECT_EQ(refusal({"--params", "adit=/nowhere.yaml"}), "--params: no file '/nowhere.yaml'");
  EXPECT_NE(refusal({"--trackers", "{adit: [1]}"}), "");
}

TEST(RunOptions, RefuseWordsThatMeanNothing) {
  EXPECT_EQ(refusal({"--speed", "3"}), "unknown option --speed");
  EXPECT_EQ(refusal({"speed:=3"}), "unknown option --speed");
  EXPECT_EQ(refusal({"--seed", "3"}, {"rate"}), "unknown option --seed");
  EXPECT_EQ(refusal({"--rate"}), "--rate wants a value");
  EXPECT_EQ(refusal({"a", "b"}), "too many arguments");
}

TEST(RunOptions, NameTheParametersOfAnyNode) {
  RunOptions options;
  options.set("params", "nrl7952");
  options.set("params", "mfa_stub=default");
  EXPECT_EQ(options.choices().at("adit").set, "nrl7952");
  EXPECT_EQ(options.choices().at("mfa_stub").set, "default");
}

}  // namespace
}  // namespace tws_launch
