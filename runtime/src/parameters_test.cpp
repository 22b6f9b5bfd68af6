#include <tws_runtime/defaults.h>
#include <tws_runtime/parameters.h>

#include <gtest/gtest.h>

#include <tws_core/temporary_folder_test_helpers.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "xml_rpc_tree.h"

namespace tws_runtime {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

/// A tree without marks, as from the parameter server.
YAML::Node plain() {
  YAML::Node tree;
  tree["gate"] = "1e6";
  tree["turns"] = "4.0";
  tree["radar"] = "sps12";
  tree["on"] = "true";
  return tree;
}

// If this fails, a value that rosparam takes for text ("1e6") stops the node or is misread.
// If this fails, a parameter file may say something else than what holds without it, and no package's test sees it.
TEST(DeparturesFromDefaults, AreTheKeysWhoseValueIsNotThatOfTheCode) {
  const auto read = [](const char* yaml) {
    return departuresFromDefaults([&] {
      double gate = 0.1;
      long turns = 4;
      std::string radar = "sps12";
      bool on = false;
      std::vector<double> weights{1.0, 2.0};
      ParameterReader reader(YAML::Load(yaml), "x.yaml");
      ParameterReader map = reader.map("map");
      scaledNumber(map, "gate", gate, 3.0, 0.0, 9.0);
      reader.integer("turns", turns, 0, 9);
      reader.choice("radar", radar, {"sps12", "sps39"});
      reader.flag("on", on);
      reader.numbers("weights", weights, 0.0, 9.0);
    });
  };
  const char* defaults = "{map: {gate: 0.033333333333333333}, turns: 4.0, radar: sps12, on: false, weights: [1, 2]}";
  EXPECT_EQ(read(defaults), std::vector<std::string>{});
  const auto found = read("{map: {gate: 0.1}, turns: 5, radar: sps39, on: true, weights: [1]}");
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[0], "map.gate: '0.1' is not the default");
}

TEST(ParameterReader, ReadsScalarsByWhatTheySay) {
  ParameterReader reader(plain(), "adit");
  double gate = 1.0;
  long turns = 1;
  bool on = false;
  std::string radar;
  reader.number("gate", gate, 0.0, 1e7);
  reader.integer("turns", turns, 0, 10);
  reader.flag("on", on);
  reader.text("radar", radar);
  reader.done();
  EXPECT_EQ(gate, 1e6);
  EXPECT_EQ(turns, 4);
  EXPECT_TRUE(on);
  EXPECT_EQ(radar, "sps12");
}

TEST(ParameterReader, KeepsTheDefaultOfAnAbsentKey) {
  ParameterReader reader(YAML::Node(), "adit");
  double gate = 7.0;
  std::vector<double> table{1.0, 2.0};
  reader.number("gate", gate, 0.0, 10.0);
  reader.numbers("table", table, 0.0, 10.0);
  reader.done();
  EXPECT_EQ(gate, 7.0);
  EXPECT_EQ(table, (std::vector<double>{1.0, 2.0}));
}

// If this fails, a slip of the pen in a parameter file silently keeps the default.
TEST(ParameterReader, AnUnknownKeyIsRefusedAndTheNearestKnownOneNamed) {
  ParameterReader reader(YAML::Load("{drop_tine: 3}"), "adit.yaml");
  double value = 1.0;
  reader.number("drop_time", value, 0.0, 10.0);
  reader.number("firm_time", value, 0.0, 10.0);
  EXPECT_EQ(errorOf([&] { reader.done(); }), "adit.yaml:1:2: drop_tine: is not a known key; did you mean 'drop_time'?");
}

TEST(ParameterReader, AnUnknownKeyUnlikeAnyKnownOneListsThemAll) {
  ParameterReader reader(YAML::Load("{colour: red}"), "adit.yaml");
  double value = 1.0;
  reader.number("firm_time", value, 0.0, 10.0);
  reader.number("drop_time", value, 0.0, 10.0);
  EXPECT_EQ(errorOf([&] { reader.done(); }),
            "adit.yaml:1:2: colour: is not a known key; known keys: drop_time, firm_time");
}

// If this fails, a value out of range or of the wrong type reaches the algorithm, or the error does not say where it
// is.
TEST(ParameterReader, ABadValueIsRefusedWithPlaceValueAndWhatIsAllowed) {
  ParameterReader reader(YAML::Load("gate: -2\nname: [1]\nodd: .nan\nhalf: 2.5\non: 3\nmode: fast\n"), "f");
  double number = 1.0;
  long integer = 1;
  bool flag = false;
  std::string text = "slow";
  EXPECT_EQ(errorOf([&] { reader.number("gate", number, 0.5, 10.0); }), "f:1:7: gate: -2 is not in [0.5, 10]");
  EXPECT_EQ(errorOf([&] { reader.number("name", number, 0.5, 10.0); }), "f:2:7: name: expected a number, found a list");
  EXPECT_EQ(errorOf([&] { reader.number("odd", number, -kInfinity, kInfinity); }),
            "f:3:6: odd: expected a number, found '.nan'");
  EXPECT_EQ(errorOf([&] { reader.integer("half", integer, 0, 9); }),
            "f:4:7: half: expected a whole number, found '2.5'");
  EXPECT_EQ(errorOf([&] { reader.flag("on", flag); }), "f:5:5: on: expected true or false, found '3'");
  EXPECT_EQ(errorOf([&] {
              reader.choice("mode", text, {"slow", "medium"});
            }),
            "f:6:7: mode: 'fast' is not one of slow, medium");
  EXPECT_EQ(errorOf([&] { reader.require("period"); }), "f:1:1: period: is required and missing");
  EXPECT_EQ(number, 1.0);
  EXPECT_EQ(text, "slow");
}

TEST(ParameterReader, TheBoundsThemselvesAreAllowed) {
  ParameterReader reader(YAML::Load("{a: 1, b: 2, c: .inf}"), "f");
  double value = 0.0;
  reader.number("a", value, 1.0, 2.0);
  EXPECT_EQ(value, 1.0);
  reader.number("b", value, 1.0, 2.0);
  EXPECT_EQ(value, 2.0);
  reader.number("c", value, 0.0, kInfinity);
  EXPECT_EQ(value, kInfinity);
}

// If this fails, an error in the third radar of a scenario sends its user to the wrong one.
TEST(ParameterReader, NestedErrorsNameTheWholePathAndTheLine) {
  ParameterReader reader(YAML::Load("radars:\n  - {period: 6}\n  - {period: 0}\nmap: {deep: {a: 1}}\n"), "s.yaml");
  std::vector<ParameterReader> radars = reader.list("radars");
  ASSERT_EQ(radars.size(), 2u);
  double period = 0.0;
  radars[0].number("period", period, 0.1, 60.0);
  EXPECT_EQ(period, 6.0);
  EXPECT_EQ(errorOf([&] { radars[1].number("period", period, 0.1, 60.0); }),
            "s.yaml:3:14: radars[1].period: 0 is not in [0.1, 60]");
  ParameterReader deep = reader.map("map").map("deep");
  EXPECT_EQ(errorOf([&] { deep.done(); }), "s.yaml:4:14: map.deep.a: is not a known key; no keys are known here");
  EXPECT_EQ(errorOf([&] { reader.map("radars"); }), "s.yaml:2:3: radars: expected a map, found a list");
}

TEST(ParameterReader, ListsOfNumbersAndTextsAreCheckedElementByElement) {
  ParameterReader reader(YAML::Load("gates: [1, 2, 30]\nradars: [sps12, 39]\nbad: 4\n"), "f");
  std::vector<double> gates;
  std::vector<std::string> radars;
  EXPECT_EQ(errorOf([&] { reader.numbers("gates", gates, 0.0, 10.0); }), "f:1:15: gates[2]: 30 is not in [0, 10]");
  reader.numbers("gates", gates, 0.0, 100.0);
  reader.texts("radars", radars);
  EXPECT_EQ(gates, (std::vector<double>{1.0, 2.0, 30.0}));
  EXPECT_EQ(radars, (std::vector<std::string>{"sps12", "39"}));
  EXPECT_EQ(errorOf([&] { reader.texts("bad", radars); }), "f:3:6: bad: expected a list of texts, found '4'");
}

TEST(ParameterReader, KeysComeInTheOrderOfTheFile) {
  const ParameterReader reader(YAML::Load("{sps39: {}, sps12: {}}"), "f");
  EXPECT_EQ(reader.keys(), (std::vector<std::string>{"sps39", "sps12"}));
}

TEST(ParameterFile, ErrorsNameFileLineColumnAndReason) {
  const tws::TemporaryFolder folder;
  const std::string broken = folder.write("broken.yaml", "a: 1\nb: [1, 2\nc: 3\n");
  EXPECT_EQ(errorOf([&] { loadParameterFile(broken); }).rfind(broken + ":3:", 0), 0u)
      << errorOf([&] { loadParameterFile(broken); });
  const std::string twice = folder.write("twice.yaml", "radars:\n  - a: 1\n    b: 2\n    a: 3\n");
  EXPECT_EQ(errorOf([&] { loadParameterFile(twice); }), twice + ":4:5: key 'a' stands twice in this map");
  EXPECT_EQ(errorOf([] { loadParameterFile("/nowhere/a.yaml"); }), "/nowhere/a.yaml: cannot be read");
  EXPECT_TRUE(loadParameterFile(folder.write("empty.yaml", "# nothing\n")).IsMap());
}

// If these fail, a file of a few lines takes the memory of the machine, or ends the program without a word.
TEST(LoadParameterFile, RefusesAliasesThatStandForMoreThanAFileCanHold) {
  const tws::TemporaryFolder folder;
  std::string text = "a0: &a0 [1, 1]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string name = "a" + std::to_string(i), before = "*a" + std::to_string(i - 1);
    text += name + ": &" + name + " [" + before + ", " + before + "]\n";
  }
  const std::string path = folder.write("aliases.yaml", text);
  EXPECT_NE(errorOf([&] { loadParameterFile(path); }).find("aliases"), std::string::npos);
}

TEST(LoadParameterFile, RefusesAnAliasOfItself) {
  const tws::TemporaryFolder folder;
  const std::string path = folder.write("itself.yaml", "a: &a\n  b: *a\n");
  EXPECT_NE(errorOf([&] { loadParameterFile(path); }).find(": is nested deeper"), std::string::npos);
}

TEST(LoadParameterFile, TakesAliasesInTheirPlace) {
  const tws::TemporaryFolder folder;
  const YAML::Node tree = loadParameterFile(folder.write("usual.yaml", "a: &a {x: 1}\nb: [*a, *a]\n"));
  EXPECT_EQ(tree["b"][1]["x"].as<int>(), 1);
}

TEST(LoadParameterFile, RefusesWhatIsNoFileOrEndless) {
  EXPECT_EQ(errorOf([] { loadParameterFile("/"); }), "/: cannot be read");
  EXPECT_EQ(errorOf([] { loadParameterFile("/dev/zero"); }).rfind("/dev/zero: is larger than 16 MB", 0), 0u);
}

// If this fails, a log has lines that say nothing, or what the file wants it to say.
TEST(ParameterErrors, AreOneLineWhateverTheyQuote) {
  const tws::TemporaryFolder folder;
  const std::string path = folder.write("lines.yaml", "\"a\\nb\": 1\n\"a\\nb\": 2\n");
  EXPECT_EQ(errorOf([&] { loadParameterFile(path); }), path + ":2:1: key 'a b' stands twice in this map");
  const std::string choice = folder.write("choice.yaml", "x: \"a\\nb\"\n");
  std::string value;
  EXPECT_EQ(errorOf([&] { ParameterReader(loadParameterFile(choice), choice).choice("x", value, {"one"}); }),
            choice + ":1:4: x: 'a b' is not one of one");
}

// If this fails, one changed value in a user's file throws away the rest of the set, or its error loses its line.
TEST(MergeParameters, ReplacesValuesKeyByKeyAndKeepsLines) {
  const YAML::Node base = YAML::Load("{a: 1, map: {x: 1, y: 2}, list: [1, 2]}");
  const YAML::Node other = YAML::Load("map:\n  y: 3\n  z: 4\nlist: [9]\nb: 5\n");
  const YAML::Node merged = mergeParameters(base, other);
  EXPECT_EQ(merged["a"].as<int>(), 1);
  EXPECT_EQ(merged["b"].as<int>(), 5);
  EXPECT_EQ(merged["map"]["x"].as<int>(), 1);
  EXPECT_EQ(merged["map"]["y"].as<int>(), 3);
  EXPECT_EQ(merged["map"]["z"].as<int>(), 4);
  EXPECT_EQ(merged["list"].size(), 1u);
  EXPECT_EQ(merged["map"]["y"].Mark().line, 1);
  EXPECT_EQ(base["map"]["y"].as<int>(), 2) << "the base was changed";
  EXPECT_EQ(mergeParameters(base, YAML::Node())["a"].as<int>(), 1);
}

// If this fails, a node gets other numbers over the parameter server than from the file, and runs differ in the last
// bit.
// If this fails, a file of another kind given by mistake fills the screen.
TEST(ParameterReader, ALongTextIsShownByItsBeginningInOneLine) {
  EXPECT_EQ(errorOf([] { ParameterReader(YAML::Load("first\n\nsecond\n"), "f"); }),
            "f:1:1: expected a map, found 'first…'");
  EXPECT_EQ(errorOf([] { ParameterReader(YAML::Load(std::string(100, 'a')), "f"); }),
            "f:1:1: expected a map, found '" + std::string(40, 'a') + "…'");
}

TEST(TreeFromXmlRpc, KeepsEveryBitOfANumberAndTheShapeOfTheTree) {
  XmlRpc::XmlRpcValue value;
  const double third = 1.0 / 3.0;
  value["third"] = third;
  value["tiny"] = 5e-324;
  value["count"] = 3;
  value["on"] = true;
  value["text"] = std::string("1e6");
  value["list"][0] = 1.5;
  value["list"][1] = 2;
  const YAML::Node tree = treeFromXmlRpc(value, "adit");
  EXPECT_EQ(tree["third"].as<double>(), third);
  EXPECT_EQ(tree["tiny"].as<double>(), 5e-324);
  EXPECT_EQ(tree["count"].as<int>(), 3);
  EXPECT_TRUE(tree["on"].as<bool>());
  EXPECT_EQ(tree["text"].as<double>(), 1e6);
  EXPECT_EQ(tree["list"][0].as<double>(), 1.5);
  EXPECT_EQ(tree["list"][1].as<int>(), 2);
  EXPECT_TRUE(treeFromXmlRpc(XmlRpc::XmlRpcValue(), "adit").IsNull());
}

TEST(TreeFromXmlRpc, RefusesWhatIsNoParameter) {
  XmlRpc::XmlRpcValue value;
  value["blob"] = XmlRpc::XmlRpcValue(const_cast<char*>("ab"), 2);
  EXPECT_EQ(errorOf([&] { treeFromXmlRpc(value, "adit"); }),
            "adit/blob: is a date or binary data, which no parameter is");
}

// If this fails, an angle in degrees arrives as radians, or a default is scaled that nobody gave.
TEST(ParameterReader, ReadsOtherUnitsAndOtherWholeNumbers) {
  ParameterReader reader(YAML::Load("{turn_deg: 180, count: 7}"), "node");
  double turn = 0.25, kept = 0.25;
  scaledNumber(reader, "turn_deg", turn, 0.01, 0.0, 360.0);
  scaledNumber(reader, "absent_deg", kept, 0.01, 0.0, 360.0);
  EXPECT_DOUBLE_EQ(turn, 1.8);
  EXPECT_EQ(kept, 0.25);
  std::uint32_t count = 3, other = 3;
  reader.integer("count", count, 0, 10);
  reader.integer("absent", other, 0, 10);
  EXPECT_EQ(count, 7U);
  EXPECT_EQ(other, 3U);
  reader.done();
}

}  // namespace
}  // namespace tws_runtime
