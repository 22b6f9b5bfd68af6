#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "metric_list.h"

namespace track_evaluation {

struct IdentityParams {
  double same_time = 0.002;          ///< A plot and an update this close in time may be one [s], >= 0.
  double same_place = 5000.0;        ///< … and this close in place [m], > 0.
  std::size_t least_plots = 20;      ///< An identity with fewer plots does not count.
  double long_gap = 16.4;            ///< Between two updates of one identity's plots [s], > 0.
  std::set<std::uint32_t> monitors;  ///< Identities of fixed devices, which must not be tracked.
};

/// Scores tracks without truth, by the identities (Mode 3/A code, 24-bit address) that the plots bear and the tracker
/// need not see: a track's update belongs to the nearest plot of the same instant. Takes for granted that an identity
/// is one aircraft, so what changes its code or shares it counts against the tracker. Metrics: doc/metrics.md.
class IdentityMetrics {
 public:
  explicit IdentityMetrics(const IdentityParams& params = {}) : params_(params) {}

  /// In any order; position on the radar's slant plane [m], time [s]. Not finite: throws std::invalid_argument.
  void addPlot(double time, std::uint32_t identity, const Eigen::Vector2d& position);
  /// An update of a confirmed track by a detection at `time`.
  void addUpdate(double time, std::uint32_t track, const Eigen::Vector2d& position);

  /// Nothing from before `until` [s] comes any more: it is counted, and its memory given back.
  void settle(double until) { join(until, plots_, updates_, counts_); }

  bool empty() const { return plots_.empty() && counts_.identities.empty(); }
  MetricList report() const;

 private:
  struct Event {
    double time;
    std::uint32_t who;
    Eigen::Vector2d position;
  };
  /// What became of one identity or of one track.
  struct Count {
    std::size_t plots = 0, updates = 0;
    std::map<std::uint32_t, std::size_t> by_other;  // updates by track, or by identity
    double last = 0.0;                              // update [s]
    double intervals = 0.0, gaps = 0.0, longest = 0.0;
  };
  struct Counts {
    std::map<std::uint32_t, Count> identities, tracks;
  };
  void join(double until, std::vector<Event>& plots, std::vector<Event>& updates, Counts& counts) const;
  void pair(const Event& plot, const Event& update, Counts& counts) const;

  IdentityParams params_;
  Counts counts_;                       // of what is settled
  std::vector<Event> plots_, updates_;  // the rest
};

}  // namespace track_evaluation
