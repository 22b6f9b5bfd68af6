#pragma once

#include <tws_msgs/GraphDescription.h>
#include <tws_runtime/bus.h>

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "run_summary.h"

namespace tws_launch {

/// Listens to a run, says from time to time how far it has come, and knows at the end what happened.
/// Private parameters: `radars` (names of rotating radars), `array_radars`, `range_radars`, `trackers` and
/// `correlators` (names), `length` of the run [s], 0: unknown, `graph`: its description, which goes out latched on the
/// topic `graph`, so that a recording says how it came about.
class ProgressNode {
 public:
  /// Lines go to `out`, which must outlive the node. Throws tws_runtime::ParameterError.
  ProgressNode(tws_runtime::Bus& bus, std::ostream& out);

  /// Says one line, unless the last one was said less than `period` [s of wall time] ago or nothing has come yet.
  void say(double period);
  const RunSummary& summary() const { return summary_; }

 private:
  using Clock = std::chrono::steady_clock;

  template <class M>
  void listen(tws_runtime::Bus& bus, const std::string& topic) {
    bus.subscribe<M>(topic, [this](const M& message) { summary_.add(message); });
  }

  std::ostream& out_;
  tws_runtime::Publisher<tws_msgs::GraphDescription> graph_;
  double length_ = 0.0;
  RunSummary summary_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_said_ = start_;
  Clock::time_point last_grown_ = start_;
  std::uint64_t plots_ = 0;
};

/// "12.0 of 300.0 s simulated (4 %), 17 tracks, 340 plots/s, 29 s left, adit silent for 20.0 s", from what was counted
/// in `wall_time` [s, > 0]. `length` of the run [s], 0: unknown.
std::string progressLine(const RunSummary& summary, double length, double wall_time);

}  // namespace tws_launch
