#include "template.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "graph_description.h"

namespace tws_launch {
namespace {

// What a row of graph.yaml means. If one of these fails, nodes get wrong topics or parameters.

TemplateWords words() {
  TemplateWords words;
  words.namesOf = [](const std::string& kind) {
    return kind == "rotating" ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{};
  };
  words.holds = [](const std::string& word) { return word == "yes"; };
  words.valueOf = [](const std::string& word) {
    if (word == "one") return YAML::Node("1.5");
    if (word == "several") return YAML::Load("[p, q]");
    if (word == "path") return YAML::Node("/a$one b");
    if (word == "later" || word == "late_none") return later(word);
    if (word != "none") throw std::runtime_error(word);
    return YAML::Node();
  };
  return words;
}

std::string filled(const std::string& yaml) { return inOneLine(filledIn(YAML::Load(yaml), words())); }

TEST(Template, PutsValuesInPlaceOfWords) {
  EXPECT_EQ(filled("{a: $one, b: x$one/y, c: text}"), R"({"a": 1.5, "b": "x1.5/y", "c": "text"})");
  EXPECT_EQ(filled("{a: $several}"), R"({"a": ["p", "q"]})");
}

TEST(Template, LeavesOutWhatHasNoValue) {
  EXPECT_EQ(filled("{a: $none, b: 1, c: pre$none}"), R"({"b": 1})");
  EXPECT_EQ(filled("[$none, b]"), R"(["b"])");
}

TEST(Template, RepeatsEntriesForEachSensor) {
  EXPECT_EQ(filled("[{name: $each.rotating}]"), R"([{"name": "x"}, {"name": "y"}])");
  EXPECT_EQ(filled("[$each.rotating/plots, last]"), R"(["x/plots", "y/plots", "last"])");
  EXPECT_EQ(filled("{$each.rotating/plots: Type}"), R"({"x/plots": "Type", "y/plots": "Type"})");
  EXPECT_EQ(filled("[$each.array/plots]"), "[]");
}

TEST(Template, PutsTheEntriesOfAListIntoTheListAround) { EXPECT_EQ(filled("[a, $several]"), R"(["a", "p", "q"])"); }

TEST(Template, JoinsTheMapsWhoseConditionHolds) {
  const YAML::Node maps = YAML::Load("[{a: 1, b: 1}, {when: yes, b: 2}, {when: not yes, b: 3}]");
  EXPECT_EQ(inOneLine(joinedParameters(maps, words())), R"({"a": 1, "b": 2})");
}

TEST(Template, MakesTheWordsOfACommandLine) {
  EXPECT_EQ(filledInArguments("--rate=$one --gone=$none --topics $several end", words()),
            (std::vector<std::string>{"--rate=1.5", "--topics", "p", "q", "end"}));
}

// If one of these fails, a person's /data/$day/run.bag is taken for a word of graph.yaml.
TEST(Template, LeavesWhatCameInPlaceOfAWord) {
  EXPECT_EQ(filled("{a: $path, b: --out=$path/x$one}"), R"({"a": "/a$one b", "b": "--out=/a$one b/x1.5"})");
  EXPECT_EQ(filledInArguments("--out=$path", words()), std::vector<std::string>{"--out=/a$one b"});
}

TEST(Template, CompletesOnlyWhatWasLeftForLater) {
  YAML::Node tree = filledIn(YAML::Load("{a: $path, b: [$later, x], c: {d: $later}, e: $late_none}"), words());
  tree["file"] = YAML::Load("[\"$one\", $each.rotating/x, ~]");
  TemplateWords known = words();
  known.valueOf = [](const std::string& word) { return word == "later" ? YAML::Load("[p, q]") : YAML::Node(); };
  EXPECT_EQ(inOneLine(completed(tree, known)),
            R"({"a": "/a$one b", "b": ["p", "q", "x"], "c": {"d": ["p", "q"]}, "file": ["$one", "$each.rotating/x"]})");
}

TEST(Template, RefusesAWordForLaterInsideOfText) { EXPECT_THROW(filled("[x$later]"), std::runtime_error); }

TEST(Template, RefusesAWordThatIsNotKnown) { EXPECT_THROW(filled("[$unknown]"), std::runtime_error); }

}  // namespace
}  // namespace tws_launch
