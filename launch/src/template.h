#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tws_launch {

/// What the words of a template stand for; see graph.yaml.
struct TemplateWords {
  /// The value of a word like "first.rotating", without the dollar; undefined or null: there is none. Throws when the
  /// word is not known.
  std::function<YAML::Node(const std::string& word)> valueOf;
  /// The names of a kind's sensors, for $each.KIND.
  std::function<std::vector<std::string>(const std::string& kind)> namesOf;
  /// Whether a condition's word holds.
  std::function<bool(const std::string& word)> holds;
};

/// Stands for the value of a word that is known only later, see completed().
YAML::Node later(const std::string& word);
/// The word that stands there; empty: it is no such node. No file of a user's can hold one.
std::string laterWord(const YAML::Node& node);

/// A tree of graph.yaml with values in place of its words: an entry without a value is left out, one with $each.KIND is
/// repeated. Throws std::runtime_error.
YAML::Node filledIn(const YAML::Node& tree, const TemplateWords& words);

/// What filledIn() left for later, filled in. All else stays as it is: what came in place of a word is no template, nor
/// is what a user's files hold.
YAML::Node completed(const YAML::Node& tree, const TemplateWords& words);

/// The maps of a list of maps, or one map, whose condition `when` holds, joined and filled in.
YAML::Node joinedParameters(const YAML::Node& maps, const TemplateWords& words);

/// The words of a command line, filled in: lists become several words, a word without a value goes, with the option
/// that it belongs to.
std::vector<std::string> filledInArguments(const std::string& arguments, const TemplateWords& words);

}  // namespace tws_launch
