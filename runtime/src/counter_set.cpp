#include "counter_set.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace tws_runtime {

CounterSet::CounterSet(std::string node, Say say, WallClock clock)
    : node_(std::move(node)), say_(std::move(say)), clock_(std::move(clock)) {}

Counter& CounterSet::get(const std::string& name) {
  for (LoggedCounter& counter : counters_)
    if (counter.name() == name) return counter;
  return counters_.emplace_back(*this, name);
}

std::vector<CounterReading> CounterSet::readings() const {
  std::vector<CounterReading> readings;
  for (const LoggedCounter& counter : counters_)
    readings.push_back({node_, counter.name(), counter.value(), counter.reasons() > 0});
  return readings;
}

std::uint64_t CounterSet::badNews() const {
  std::uint64_t sum = 0;
  for (const LoggedCounter& counter : counters_) sum += counter.reasons();
  return sum;
}

void CounterSet::LoggedCounter::add(const std::string& reason) {
  constexpr std::chrono::seconds kQuiet{5};
  ++value_;
  ++reasons_;
  const auto now = set_.clock_();
  if (last_said_ && now - *last_said_ < kQuiet) return;
  last_said_ = now;
  set_.say_(set_.node_ + ": " + name_ + " (" + std::to_string(value_) + "): " + reason);
}

void printCounters(std::ostream& out, const std::vector<CounterReading>& readings) {
  std::size_t node_width = 4;
  std::size_t name_width = 7;
  for (const CounterReading& reading : readings) {
    node_width = std::max(node_width, reading.node.size());
    name_width = std::max(name_width, reading.name.size());
  }
  const auto line = [&](const std::string& node, const std::string& name, const std::string& value) {
    out << std::left << std::setw(static_cast<int>(node_width) + 2) << node
        << std::setw(static_cast<int>(name_width) + 2) << name << std::right << std::setw(12) << value;
  };
  line("node", "counter", "count");
  out << '\n';
  for (const CounterReading& reading : readings) {
    line(reading.node, reading.name, std::to_string(reading.value));
    out << (reading.bad ? " !\n" : "\n");
  }
}

}  // namespace tws_runtime
