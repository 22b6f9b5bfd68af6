#pragma once

#include <map>
#include <string>

#include "metric_list.h"
#include "sample.h"

namespace track_evaluation {

/// How long it takes from the beam to the track, in data time. doc/metrics.md defines each figure.
class Timing {
 public:
  /// A radar's sector of plots with this stamp [s] was published at `now` [s].
  void addPlots(const std::string& radar, double now, double stamp, std::size_t plots);
  /// A tracker's message about a sector of `radar` whose mark was crossed at `stamp` was published at `now`.
  void addTracks(const std::string& radar, double now, double stamp, std::size_t tracks);

  MetricList report() const;

 private:
  void extendTo(double now);

  double first_ = 0.0, last_ = 0.0;
  bool started_ = false;
  double plots_ = 0.0, tracks_ = 0.0;
  std::map<std::string, double> newest_plots_;  // when each radar's latest sector was published
  Sample plots_latency_, tracks_latency_, tracks_processing_;
};

}  // namespace track_evaluation
