#pragma once

#include <tws_msgs/GraphDescription.h>
#include <tws_runtime/bus.h>

#include <chrono>
#include <iosfwd>
#include <string>

#include "heartbeats.h"
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

  /// Says one line, unless the last one was said less than `period` [s of wall time] ago or nothing has come yet: that
  /// is said only of who has been silent for some time.
  void say(double period);
  const RunSummary& summary() const { return summary_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// `speaker`: who says it all the time.
  template <class M>
  void listen(tws_runtime::Bus& bus, const std::string& topic, const std::string& speaker) {
    beats_.expect(speaker, elapsed());
    bus.subscribe<M>(topic, [this, speaker](const M& message) {
      summary_.add(message);
      beats_.heard(speaker, elapsed());
    });
  }
  /// Since the node began [s of wall time].
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  std::ostream& out_;
  tws_runtime::Publisher<tws_msgs::GraphDescription> graph_;
  double length_ = 0.0;
  RunSummary summary_;
  Heartbeats beats_;
  Clock::time_point begin_ = Clock::now();
  double start_ = 0.0;      ///< When the first plot came, as elapsed().
  double last_said_ = 0.0;  ///< The same.
  std::uint64_t said_plots_ = 0;
};

/// "12.0 of 300.0 s simulated (4 %), 17 tracks, 340 plots/s, 29 s left", from what was counted in `wall_time` [s, > 0]
/// and the `rate` of plots of late [1/s]. `length` of the run [s], 0: unknown. When the tracks are not of now: "17
/// tracks as of 5.0 s".
std::string progressLine(const RunSummary& summary, double length, double wall_time, double rate);

}  // namespace tws_launch
