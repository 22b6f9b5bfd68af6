#pragma once

#include <limits>
#include <optional>

#include "detection_window.h"
#include "gate_search.h"
#include "range_filter.h"
#include "range_gate_params.h"
#include "range_profile.h"

namespace range_gate_tracker {

enum class Lock {
  kSearching,  ///< No target.
  kLocked,     ///< Measured in this profile.
  kCoasting,   ///< Below the threshold for a while: the previous range is reused.
};

/// What one profile led to.
struct GateReport {
  double time = 0.0;  ///< Of the profile [s].
  Lock lock = Lock::kSearching;
  RangeInterval gate;    ///< Commanded for the next profiles.
  double measured;       ///< R [m]. NaN: below the threshold.
  double smoothed;       ///< R_S [m]. NaN: no target.
  double predicted;      ///< R_T, for the prediction time after this profile [m]. NaN: no target.
  double rate;           ///< Of R_S [m/s]. NaN: no target.
  double power = 0.0;    ///< S0(r_max) [m²].
  double quality = 0.0;  ///< Share of the window's power that exceeds the level of the rest of the gate, 0 .. 1.
};

/// Keeps the range gate of a radar on one target, after DDRE A-5/2005: the brightest window is measured, the ranges are
/// damped, and the gate is centred on the prediction. Without a target GateSearch says where to look, at first about
/// the centre of the first profile; a new target is one that some profiles in a row agree on, and it stays one as long
/// as as many measurements in a row do again and again.
class RangeGateTracker {
 public:
  explicit RangeGateTracker(const RangeGateParams& params);

  /// Throws std::invalid_argument, and changes nothing, when the time is not later than before, the profile is shorter
  /// than the detection window, its place or bin size make no sense, or an amplitude is not finite.
  GateReport process(const RangeProfile& profile);

 private:
  void check(const RangeProfile& profile) const;
  BinSpan spanToLookAt(const RangeProfile& profile, std::size_t bins) const;
  std::optional<double> measuredRange(const WindowReading& reading, const RangeProfile& profile) const;
  bool agrees(double measured) const;
  void follow(std::optional<double> measured, double dt);
  void seek(std::optional<double> measured, const RangeProfile& profile);
  void note(double measured);
  bool isUnderWay(const RangeProfile& profile) const;
  bool isRefuted(double range) const;
  void refute();
  GateReport report(const WindowReading& reading, std::optional<double> measured, const RangeProfile& profile) const;
  RangeInterval nextGate() const;

  RangeGateParams params_;
  DetectionWindow window_;
  RangeFilter filter_;
  GateSearch search_;
  Lock lock_ = Lock::kSearching;
  std::optional<double> time_;    // of the last profile [s]
  double last_measured_ = 0.0;    // R(t - 1) [m]
  double last_seen_ = 0.0;        // when that was measured [s]
  double last_agreed_ = 0.0;      // when enough measurements in a row had last agreed [s]
  long agreeing_ = 0;             // how many in a row do; without a target: on the candidate that the gate stays with
  double candidate_since_ = 0.0;  // or since another one had the gate [s]
  double refuted_ = 0.0;          // where none of them was a target [m]
  double refuted_until_ = -std::numeric_limits<double>::infinity();
};

}  // namespace range_gate_tracker
