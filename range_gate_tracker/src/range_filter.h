#pragma once

#include <variant>

#include <tws_core/kalman.h>

#include "range_gate_params.h"

namespace range_gate_tracker {

/// The damped moving average of the measured range, section 3 of DDRE A-5/2005. It lags a target of constant velocity v
/// by v·Δt·α/(1 - α), about v·τ.
class DampedRange {
 public:
  explicit DampedRange(const RangeGateParams& params)
      : damping_time_(params.damping_time), velocity_limit_(params.velocity_limit) {}

  void start(double measured);
  /// dt [s] after the last one, > 0.
  void update(double measured, double dt);
  /// No measurement: the previous range is reused.
  void coast(double dt) { update(measured_, dt); }

  /// Where the next measurement is looked for, dt [s] later: where the last one was.
  double expected(double /*dt*/) const { return measured_; }

  double range() const { return smoothed_; }  ///< R_S [m]
  double rate() const { return rate_; }       ///< Of R_S [m/s].
  /// R_T, eq. (11): the same as R_S, for a time t_pred later.
  double predicted(double /*prediction_time*/) const { return smoothed_; }

 private:
  double damping_time_, velocity_limit_;
  double measured_ = 0.0, smoothed_ = 0.0, rate_ = 0.0;
};

/// Range and rate by the Kalman filter of constant velocity, for prediction times over which a target moves.
class KalmanRange {
 public:
  explicit KalmanRange(const RangeGateParams& params) : params_(params) {}

  void start(double measured);
  void update(double measured, double dt);
  /// No measurement: the target goes on.
  void coast(double dt);

  double expected(double dt) const { return predicted(dt); }

  double range() const { return state_.mean[0]; }
  double rate() const { return state_.mean[1]; }
  double predicted(double prediction_time) const { return range() + rate() * prediction_time; }

 private:
  tws::LinearMeasurement measurement(double range) const;

  RangeGateParams params_;
  tws::LinearState state_;
};

using RangeFilter = std::variant<DampedRange, KalmanRange>;

RangeFilter makeFilter(const RangeGateParams& params);

}  // namespace range_gate_tracker
