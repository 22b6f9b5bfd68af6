#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tracker_choices.h"

namespace tws_launch {

/// Something that a person said and that cannot be. what() is one line that names the option.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a person may say of a run, the same for `./tws`, the launch files and tws_offline.
struct RunOption {
  enum class Type { kText, kNumber, kWhole, kFlag, kFile };
  std::string name;  ///< --clutter-map, or the argument clutter_map.
  Type type = Type::kText;
  double least = 0.0, greatest = 0.0;  ///< Of a number.
  std::string meaning;
};
const std::vector<RunOption>& runOptions();

/// What was said, checked.
class RunOptions {
 public:
  /// One more, as "clutter_map" or "clutter-map"; an empty value says nothing. Paths are made absolute. Throws
  /// UsageError.
  void set(const std::string& name, const std::string& value);

  /// Empty when nothing was said and there is no default.
  std::string operator[](const std::string& name) const;
  bool has(const std::string& name) const { return !(*this)[name].empty(); }
  /// Whether a person said it.
  bool isSaid(const std::string& name) const { return values_.count(name) > 0; }
  /// Whether a flag was said to be true.
  bool flag(const std::string& name) const { return (*this)[name] == "true"; }
  /// What `params` and `trackers` say.
  const TrackerChoices& choices() const { return choices_; }
  /// What was said, for a program that is told the same.
  const std::vector<std::pair<std::string, std::string>>& said() const { return said_; }

 private:
  void choose(const std::string& params);

  std::map<std::string, std::string> values_;
  TrackerChoices choices_;
  std::vector<std::pair<std::string, std::string>> said_;
};

}  // namespace tws_launch
