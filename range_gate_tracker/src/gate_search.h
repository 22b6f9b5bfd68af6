#pragma once

#include <cstddef>
#include <vector>

#include "range_gate_params.h"

namespace range_gate_tracker {

/// From `min` to `max` [m].
struct RangeInterval {
  double min = 0.0;
  double max = 0.0;
  double centre() const { return 0.5 * (min + max); }
};

/// An interval of that length about `centre`, moved into the ranges that the gate may lie in.
RangeInterval gateAbout(double centre, double length, const RangeGateParams& params);

/// Where to look for a target that is lost, which the report leaves open. First the gate stays at the last range and
/// opens on both sides as fast as the target may have moved (the velocity limit), up to the widest gate. After the
/// widening time the gate, as long as ever, sweeps over all ranges, the places nearest to the last range first,
/// overlapping by one detection window; then again.
class GateSearch {
 public:
  explicit GateSearch(const RangeGateParams& params) : params_(params) { begin(params.min_range, 0.0); }

  /// The target was last at `range` [m], `time` [s].
  void begin(double range, double time);
  RangeInterval gate(double time) const;

 private:
  void makePlaces(double range);

  RangeGateParams params_;
  double range_ = 0.0;
  double since_ = 0.0;
  double sweep_from_ = 0.0;      // [s of data time]
  std::vector<double> centres_;  // of the gate in the sweep, in turn [m]
};

/// Length of the gate about a target that was last seen so long ago [s].
double lengthAfter(double unseen, const RangeGateParams& params);

}  // namespace range_gate_tracker
