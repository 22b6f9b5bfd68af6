#include "range_filter.h"

#include <algorithm>
#include <cmath>

namespace range_gate_tracker {

void DampedRange::start(double measured) {
  measured_ = smoothed_ = measured;
  rate_ = 0.0;
}

void DampedRange::update(double measured, double dt) {
  measured_ = measured;
  const double alpha = std::exp(-dt / damping_time_);                    // eq. (10)
  const double smoothed = alpha * smoothed_ + (1.0 - alpha) * measured;  // eq. (8)
  rate_ = std::clamp((smoothed - smoothed_) / dt, -velocity_limit_, velocity_limit_);
  smoothed_ += rate_ * dt;
}

tws::LinearMeasurement KalmanRange::measurement(double range) const {
  tws::LinearMeasurement measurement;
  measurement.position << range;
  measurement.covariance << params_.range_sigma * params_.range_sigma;
  return measurement;
}

void KalmanRange::start(double measured) { state_ = tws::startState(measurement(measured), params_.velocity_limit); }

void KalmanRange::coast(double dt) { tws::predict(state_, dt, params_.acceleration_density); }

void KalmanRange::update(double measured, double dt) {
  coast(dt);
  const tws::LinearMeasurement taken = measurement(measured);
  tws::update(state_, taken, tws::innovation(state_, taken));
  state_.mean[1] = std::clamp(state_.mean[1], -params_.velocity_limit, params_.velocity_limit);
}

RangeFilter makeFilter(const RangeGateParams& params) {
  if (params.predictor == Predictor::kKalman) return KalmanRange(params);
  return DampedRange(params);
}

}  // namespace range_gate_tracker
