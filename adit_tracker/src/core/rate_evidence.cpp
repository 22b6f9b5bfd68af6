#include "core/rate_evidence.h"

#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {

double againstFalse(const tws::RangeRate& rate, const RadarQuality& quality) {
  return rate.known() ? std::log(quality.rateSpan()) : 0.0;
}

double standingAgainstFalse(const tws::RangeRate& rate, const RadarQuality& quality) {
  if (!rate.known()) return 0.0;
  constexpr double kDrift = 10.0, kTurns = 0.1;  // standard deviation [m/s], share of what stands
  const double variance = rate.sigma * rate.sigma + kDrift * kDrift, off = rate.difference(rate.value, 0.0);
  const double drifts = quality.rateSpan() * std::exp(-0.5 * off * off / variance) / std::sqrt(tws::kTwoPi * variance);
  return std::log((1.0 - kTurns) * drifts + kTurns);
}

}  // namespace adit_tracker
