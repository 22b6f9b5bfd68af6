#pragma once

#include <tws_msgs/TrackerStatus.h>
#include <tws_runtime/bus.h>

#include <cstdint>
#include <vector>

#include "core/adit.h"

namespace adit_tracker {

/// What the node knows of the tracker's state besides the tracker itself.
struct NodeState {
  std::uint32_t operator_calls = 0;   ///< How often it was caught up since the last status.
  std::uint32_t skipped_sectors = 0;  ///< Since the last status.
  std::uint64_t bad_detections = 0;   ///< Refused before they reached the tracker.
  std::vector<double> silence;  ///< Of each radar: since the end of its last sector [s]; infinity: nothing came yet.
};

/// The report's ISTA, without header and name.
tws_msgs::TrackerStatus statusMessage(const Adit& adit, const NodeState& state);

/// The share of track numbers in use above which a warning is due.
constexpr double kNearlyFull = 0.9;
/// Is this share of the track numbers in use?
bool isFilled(const Adit& adit, double share);

/// Stale radars, lag, capacity and faults in words, the worst first.
tws_runtime::Diagnosis diagnosisOf(const Adit& adit, const NodeState& state);

}  // namespace adit_tracker
