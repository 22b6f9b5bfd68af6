#include "range_rates.h"

#include <cmath>
#include <random>

namespace radar_sim {

double folded(const RadarParams& radar, double rate) {
  return radar.range_rate_ambiguity > 0.0 ? std::remainder(rate, radar.range_rate_ambiguity) : rate;
}

double drawRangeRate(const RadarParams& radar, double rate, double spread, RandomStream& random) {
  std::normal_distribution<> error(0.0, std::hypot(radar.range_rate_sigma, spread));
  return folded(radar, rate + error(random));
}

double drawFalseRangeRate(const RadarParams& radar, RandomStream& random) {
  const double ambiguity = radar.range_rate_ambiguity, span = ambiguity > 0.0 ? ambiguity : radar.range_rate_span;
  return std::uniform_real_distribution<>(-0.5 * span, 0.5 * span)(random);
}

}  // namespace radar_sim
