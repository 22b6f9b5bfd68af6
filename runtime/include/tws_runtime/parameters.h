#pragma once

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tws_runtime {

/// A parameter that is missing, unknown, of the wrong type or out of range, or a file that cannot be read. what() is
/// one line that names it, its value and what is allowed.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a tree of parameters into plain variables and refuses what it does not know.
///
///   ParameterReader reader(bus.parameters(), bus.name());
///   reader.number("drop_time", params.drop_time, 1.0, 600.0);   // keeps the default when the key is absent
///   reader.done();                                              // an unread key is an error
///
/// Scalars may come as text ("1e6", which rosparam does not take for a number): they are read by what they say.
/// An error line reads `where:line:column: path.to.key: reason`; line and column only when the tree came from a file.
class ParameterReader {
 public:
  /// `where` starts every error line: the node's name, or the file's. Throws when the tree is neither a map nor empty.
  ParameterReader(const YAML::Node& tree, std::string where);

  bool has(const std::string& key) const;
  /// All keys of the map in the order of the file, read or not. For maps whose keys are names.
  std::vector<std::string> keys() const;

  /// All throw ParameterError; bounds are inclusive; NaN is refused.
  void number(const std::string& key, double& value, double least, double greatest);
  void integer(const std::string& key, long& value, long least, long greatest);
  /// The same for other whole numbers; the bounds must lie within their type.
  template <class Integer>
  void integer(const std::string& key, Integer& value, long least, long greatest) {
    long number = static_cast<long>(value);
    integer(key, number, least, greatest);
    value = static_cast<Integer>(number);
  }
  void flag(const std::string& key, bool& value);
  void text(const std::string& key, std::string& value);
  /// One of `allowed`, else an error that lists them.
  void choice(const std::string& key, std::string& value, const std::vector<std::string>& allowed);
  void numbers(const std::string& key, std::vector<double>& values, double least, double greatest);
  void texts(const std::string& key, std::vector<std::string>& values);
  /// Requires the key to be there.
  void require(const std::string& key) const;

  /// A reader of the map under `key` (empty when absent), whose errors name the whole path. Call its done() too.
  ParameterReader map(const std::string& key);
  /// Readers of the maps in the list under `key`. Call done() of each.
  std::vector<ParameterReader> list(const std::string& key);
  /// Throws when a key was never read: it names the key and the nearest known one.
  void done() const;

  /// Throws a ParameterError about `key` in the form of all others, for checks that span several keys.
  [[noreturn]] void fail(const std::string& key, const std::string& reason) const;

 private:
  ParameterReader(const YAML::Node& tree, std::string where, std::string path);
  YAML::Node find(const std::string& key);
  [[noreturn]] void failAt(const YAML::Node& node, const std::string& path, const std::string& reason) const;
  std::string pathTo(const std::string& key) const;

  YAML::Node tree_;
  std::string where_;
  std::string path_;
  std::set<std::string> known_;
};

/// A number whose unit in the file is `unit` SI units; the bounds are in the file's unit.
void scaledNumber(ParameterReader& reader, const std::string& key, double& value, double unit, double least,
                  double greatest);

/// One of several names, each of which means a value; `value` is the default, and must be among them.
template <class T>
void choice(ParameterReader& reader, const std::string& key, T& value,
            const std::vector<std::pair<std::string, T>>& names) {
  std::vector<std::string> allowed;
  std::string chosen;
  for (const auto& [name, meaning] : names) {
    allowed.push_back(name);
    if (meaning == value) chosen = name;
  }
  reader.choice(key, chosen, allowed);
  value = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == chosen; })->second;
}

/// The tree in a YAML file. Throws ParameterError with file, line, column and reason when it cannot be read, is no
/// YAML, or holds a key twice in one map. An empty file is an empty map.
YAML::Node loadParameterFile(const std::string& path);
/// The same of a text that is called `name` in complaints.
YAML::Node parseParameters(const std::string& text, const std::string& name);

/// The tree without the keys that are the runtime's own (`live`): what a node may see of its private parameters.
YAML::Node withoutRuntimeKeys(const YAML::Node& tree);

/// `base` with every key that `overriding` has replaced by it; maps are merged key by key, all else is replaced as a
/// whole. Neither argument changes. Line numbers of the values stay.
YAML::Node mergeParameters(const YAML::Node& base, const YAML::Node& overriding);

}  // namespace tws_runtime
