#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "run_options.h"

namespace tws_launch {

/// The words of a command line, read: options of a run, others that the program knows, and the rest.
struct CommandWords {
  RunOptions options;
  std::map<std::string, std::string> others;
  std::vector<std::string> arguments;
};

/// Reads words like `--rate 5`, `--rviz`, `--no-rviz`, and, as roslaunch has them, `rate:=5`. `allowed`: names of
/// run options; empty: all. `others`: further options that take a value. At most so many `arguments`. Throws
/// UsageError.
CommandWords readCommandWords(const std::vector<std::string>& words, const std::set<std::string>& allowed,
                              const std::set<std::string>& others, std::size_t arguments);

/// What the options mean, a line each.
std::string explained(const std::set<std::string>& allowed);

}  // namespace tws_launch
