#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <tws_core/angles.h>

namespace radar_sim {

enum class FaultKind {
  kOutage,           ///< The radar is silent: no marks, no detections.
  kMissedScan,       ///< Marks come, detections do not.
  kFalseAlarmBurst,  ///< More false alarms.
};

/// Something that goes wrong with a radar during [from, to) [s of data time].
struct Fault {
  FaultKind kind = FaultKind::kOutage;
  std::string radar;
  double from = 0.0;
  double to = 0.0;
  // Of a burst: as if this many false alarms came on a whole scan, but only within these azimuths (clockwise from
  // `from`) [rad].
  double false_alarms_per_scan = 0.0;
  double azimuth_from = 0.0;
  double azimuth_to = tws::kTwoPi;

  bool isActiveAt(double time) const { return time >= from && time < to; }
};

/// One of these faults of that kind is active.
inline bool isFaulty(const std::vector<Fault>& faults, FaultKind kind, double time) {
  const auto applies = [&](const Fault& fault) { return fault.kind == kind && fault.isActiveAt(time); };
  return std::any_of(faults.begin(), faults.end(), applies);
}

}  // namespace radar_sim
