#include "antenna.h"

#include <cmath>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace radar_sim {

Antenna::Antenna(double period, double start_azimuth, double start_time, const AzimuthErrors& errors)
    : beam_{start_time, start_azimuth, tws::kTwoPi / period},
      errors_(errors),
      before_start_(-tws::kTwoPi * std::floor(measured(start_azimuth, start_time) / tws::kTwoPi)),
      first_sector_(tws::sectorOf(tws::wrapTwoPi(measured(start_azimuth, start_time)))) {
  if (!(period > 0.0)) throw std::invalid_argument("the rotation period is not positive");
}

double Antenna::azimuthAt(double time) const { return tws::wrapTwoPi(angleAt(time)); }

double Antenna::entryTime(std::int64_t running_sector) const {
  if (running_sector <= first_sector_) return beam_.time;
  // Fixed-point iteration: without errors the first guess is the answer.
  const double angle = static_cast<double>(running_sector) * tws::kSectorWidth;
  double time = beam_.timeAt(angle);
  for (int i = 0; i < 50; ++i) {
    const double missing = (angle - measuredAngleAt(time)) / rate();
    if (std::abs(missing) < 1e-9) break;
    time += missing;
  }
  return time;
}

// Fixed-point iteration: go on by the angle that is missing. It contracts by (azimuth rate / rotation rate) a step.
std::optional<double> Antenna::crossing(double after, const std::function<double(double)>& azimuth) const {
  double time = after + tws::wrapTwoPi(azimuth(after) - azimuthAt(after)) / rate();
  for (int i = 0; i < 50; ++i) {
    const double missing = tws::wrapPi(azimuth(time) - azimuthAt(time)) / rate();
    time += missing;
    if (std::abs(missing) < 1e-9) return time > after ? std::optional<double>(time) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace radar_sim
