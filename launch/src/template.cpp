#include "template.h"

#include <tws_runtime/parameters.h>

#include <sstream>
#include <stdexcept>

#include "condition.h"

namespace tws_launch {
namespace {

const char* const kWordCharacters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
const std::string kEach = "$each.";
const std::string kLater = "known later";  // A tag; the space keeps it out of any file.

/// The word that stands at `dollar` in the text, without the dollar.
std::string wordAt(const std::string& text, std::size_t dollar) {
  const std::size_t end = text.find_first_not_of(kWordCharacters, dollar + 1);
  return text.substr(dollar + 1, end == std::string::npos ? end : end - dollar - 1);
}

/// The kind in the first "$each.KIND" of a tree; empty: there is none.
std::string kindRepeated(const YAML::Node& tree) {
  std::string kind;
  if (tree.IsScalar()) {
    const std::size_t found = tree.Scalar().find(kEach);
    return found == std::string::npos ? "" : wordAt(tree.Scalar(), found).substr(kEach.size() - 1);
  }
  for (auto entry = tree.begin(); entry != tree.end() && kind.empty(); ++entry) {
    if (tree.IsMap()) kind = kindRepeated(entry->first);
    if (kind.empty()) kind = kindRepeated(tree.IsMap() ? entry->second : YAML::Node(*entry));
  }
  return kind;
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// A copy of the tree in which $each.KIND is a name.
YAML::Node withName(const YAML::Node& tree, const std::string& kind, const std::string& name) {
  if (tree.IsScalar()) {
    std::string text = tree.Scalar();
    replaceAll(text, kEach + kind, name);
    return YAML::Node(text);
  }
  YAML::Node copy(tree.Type());
  for (const auto& entry : tree)
    if (tree.IsMap())
      copy[withName(entry.first, kind, name).Scalar()] = withName(entry.second, kind, name);
    else
      copy.push_back(withName(entry, kind, name));
  return copy;
}

bool isThere(const YAML::Node& value) { return value.IsDefined() && !value.IsNull(); }

/// Text with the words in it; null when one of them has no value.
YAML::Node filledInText(const YAML::Node& scalar, const TemplateWords& words) {
  std::string text = scalar.Scalar();
  std::size_t dollar = text.find('$');
  if (dollar == std::string::npos) return YAML::Clone(scalar);
  if (dollar == 0 && wordAt(text, 0).size() + 1 == text.size()) return words.valueOf(text.substr(1));
  while (dollar != std::string::npos) {
    const std::string word = wordAt(text, dollar);
    const YAML::Node value = words.valueOf(word);
    if (!isThere(value)) return {};
    if (!laterWord(value).empty()) throw std::runtime_error("graph.yaml: $" + word + " must stand alone: " + text);
    text.replace(dollar, word.size() + 1, value.as<std::string>());
    dollar = text.find('$', dollar + value.Scalar().size());
  }
  return YAML::Node(text);
}

/// Adds the value of an entry: what a word stands for may be several.
void append(YAML::Node& list, const YAML::Node& entry, const YAML::Node& value) {
  if (entry.IsScalar() && value.IsSequence())
    for (const YAML::Node& one : value) list.push_back(one);
  else if (isThere(value))
    list.push_back(value);
}

/// The entry, as often as it is to be repeated, filled in.
std::vector<YAML::Node> repeated(const YAML::Node& entry, const TemplateWords& words) {
  const std::string kind = kindRepeated(entry);
  if (kind.empty()) return {filledIn(entry, words)};
  std::vector<YAML::Node> copies;
  for (const std::string& name : words.namesOf(kind)) copies.push_back(filledIn(withName(entry, kind, name), words));
  return copies;
}

YAML::Node filledInList(const YAML::Node& list, const TemplateWords& words) {
  YAML::Node result(YAML::NodeType::Sequence);
  for (const YAML::Node& entry : list)
    for (const YAML::Node& copy : repeated(entry, words)) append(result, entry, copy);
  return result;
}

YAML::Node filledInMap(const YAML::Node& map, const TemplateWords& words) {
  YAML::Node result(YAML::NodeType::Map);
  for (const auto& entry : map) {
    YAML::Node single;
    single.push_back(entry.first);
    single.push_back(entry.second);
    const bool repeats_key = !kindRepeated(entry.first).empty();
    for (const YAML::Node& copy : repeats_key ? repeated(single, words) : std::vector<YAML::Node>{})
      result[copy[0].Scalar()] = copy[1];
    if (repeats_key) continue;
    const YAML::Node key = filledInText(entry.first, words);
    const YAML::Node value = filledIn(entry.second, words);
    if (isThere(key) && isThere(value)) result[key.Scalar()] = value;
  }
  return result;
}

}  // namespace

YAML::Node later(const std::string& word) {
  YAML::Node node(word);
  node.SetTag(kLater);
  return node;
}

std::string laterWord(const YAML::Node& node) { return node.IsScalar() && node.Tag() == kLater ? node.Scalar() : ""; }

YAML::Node completed(const YAML::Node& tree, const TemplateWords& words) {
  if (const std::string word = laterWord(tree); !word.empty()) return words.valueOf(word);
  if (!tree.IsMap() && !tree.IsSequence()) return tree;
  YAML::Node result(tree.Type());
  for (const auto& entry : tree) {
    const YAML::Node value = completed(tree.IsMap() ? entry.second : YAML::Node(entry), words);
    if (!tree.IsMap())
      append(result, entry, value);
    else if (isThere(value))
      result[entry.first.Scalar()] = value;
  }
  return result;
}

YAML::Node filledIn(const YAML::Node& tree, const TemplateWords& words) {
  if (tree.IsScalar()) return filledInText(tree, words);
  if (tree.IsSequence()) return filledInList(tree, words);
  return tree.IsMap() ? filledInMap(tree, words) : YAML::Node();
}

YAML::Node joinedParameters(const YAML::Node& maps, const TemplateWords& words) {
  YAML::Node result(YAML::NodeType::Map);
  if (!maps) return result;
  if (maps.IsMap()) return filledIn(maps, words);
  for (const YAML::Node& map : maps) {
    YAML::Node plain = YAML::Clone(map);
    plain.remove("when");
    if (holds(map["when"].as<std::string>(""), words.holds))
      result = tws_runtime::mergeParameters(result, filledIn(plain, words));
  }
  return result;
}

std::vector<std::string> filledInArguments(const std::string& arguments, const TemplateWords& words) {
  std::vector<std::string> result;
  std::istringstream all(arguments);
  for (std::string word; all >> word;) {
    const YAML::Node value = filledInText(YAML::Node(word), words);
    if (!isThere(value)) continue;
    if (value.IsSequence())
      for (const YAML::Node& one : value) result.push_back(one.Scalar());
    else
      result.push_back(value.Scalar());
  }
  return result;
}

}  // namespace tws_launch
