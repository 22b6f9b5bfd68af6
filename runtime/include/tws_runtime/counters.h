#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace tws_runtime {

/// What a counter of one node says now.
struct CounterReading {
  std::string node;
  std::string name;
  std::uint64_t value = 0;
  bool bad = false;  ///< Something was counted with a reason: bad news, not just statistics.
};

/// A table of `readings`, one line each, columns aligned. Bad ones are marked with an exclamation mark.
void printCounters(std::ostream& out, const std::vector<CounterReading>& readings);

}  // namespace tws_runtime
