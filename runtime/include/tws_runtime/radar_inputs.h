#pragma once

#include <tws_core/plot.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/intake.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tws_runtime {

/// Where one rotating radar publishes.
struct RadarTopics {
  std::string radar;         ///< The name in its messages.
  std::string detections;    ///< Topic of tws_msgs/Detections.
  std::string sector_marks;  ///< Topic of tws_msgs/SectorMark.
};
/// The usual ones, in the node's namespace: <radar>/detections and <radar>/sector_marks.
RadarTopics usualTopics(const std::string& radar);

/// Subscribes to rotating radars and gives their complete sectors: of each radar every sector once and in order,
/// whatever the order in which its two topics arrive; radars among each other in order of arrival (merge them with
/// tws::TimeOrder).
///
/// Nothing stalls it: what is lost is replaced (see SectorJoin). All that is wrong is counted: what Intake counts, and
/// "bad detections", "lost detections", "lost sector marks", "late messages", "duplicate messages", "count mismatches",
/// "stray messages", "gaps".
class RadarInputs {
 public:
  struct Options {
    double wait_limit = 0.5;     ///< Longest wait for a lost message [s of data time], >= 0; below the merger's limit.
    double restart_limit = 5.0;  ///< Time that goes back by more begins a new run [s], > 0.
    /// A radar whose clock steps this far from the others' is set aside [s], > 0.
    double skew_limit = std::numeric_limits<double>::infinity();
  };
  using OnSector = std::function<void(std::size_t radar, tws::RadarSector sector)>;
  /// Time has gone back to this [s], for all radars: forget the old run.
  using OnNewRun = std::function<void(double time)>;

  RadarInputs(Bus& bus, const std::vector<RadarTopics>& radars, Options options, OnSector on_sector,
              OnNewRun on_new_run);
  ~RadarInputs();

  /// The frame of a radar's site as its latest message says it; empty before the first one.
  const std::string& frame(std::size_t radar) const;
  /// For further topics of the same run, which the radars then decide on, too.
  Intake& intake();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_runtime
