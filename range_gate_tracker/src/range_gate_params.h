#pragma once

#include <limits>

#include "detection_window.h"

namespace range_gate_tracker {

enum class Predictor {
  kDamped,  ///< R_T of eq. (11): the damped range itself, for prediction times of about 0.1 s.
  kKalman,  ///< Constant-velocity Kalman filter, which the report recommends for longer ones.
};

/// Constants of the range gate. The defaults are those of the report's aircraft; what it leaves open is ours.
struct RangeGateParams {
  // Detection window and smoothing, DDRE A-5/2005.
  double window = 24.0;  ///< Length of the detection window [m], > 0; s is the whole number of bins next to it.
  Background background = Background::kLocal;
  double threshold = 0.1;         ///< Least S0 that is taken for a target [m²], >= 0.
  double damping_time = 0.5;      ///< τ [s], > 0.
  double velocity_limit = 200.0;  ///< Greatest change of R_S in a second [m/s], > 0.
  double prediction_time = 0.1;   ///< t_pred [s], >= 0.
  /// While locked, only windows within this distance of the last measured range are looked at, of the predicted one
  /// with the Kalman predictor [m]; infinite: all in the gate, as in the report.
  double jump_limit = std::numeric_limits<double>::infinity();

  // Kalman predictor.
  Predictor predictor = Predictor::kDamped;
  double range_sigma = 3.0;            ///< Standard deviation of R [m], > 0.
  double acceleration_density = 20.0;  ///< White acceleration of the target [m²/s³], > 0.

  // The gate.
  double gate_length = 1200.0;  ///< Of the open gate [m], >= window.
  double min_range = 500.0;     ///< Where the gate may lie [m].
  double max_range = 40000.0;

  // Loss and reacquisition.
  double coast_time = 1.0;       ///< A target on which no measurements agree for longer is lost [s], > 0.
  double widest_gate = 4000.0;   ///< The gate opens up to this length [m], >= gate_length,
  double widening_time = 5.0;    ///< and after so long without the target it sweeps [s], >= coast_time.
  double sweep_dwell = 0.4;      ///< Time at each place of the sweep [s], > 0; more than the radar takes to follow.
  long confirming_profiles = 3;  ///< Profiles in a row that agree on a new target, measurements on an old one, >= 1.
};

}  // namespace range_gate_tracker
