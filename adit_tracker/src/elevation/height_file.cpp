#include "elevation/height_file.h"

#include <cmath>

#include <tws_core/refraction.h>

namespace adit_tracker {
namespace {

// Right over the site, slant range leaves no ground range to speak of.
constexpr double kSteepest = 0.996;  // sine, of 85°

struct Measurement {
  double height, sigma;
};

/// First order: h = R sin e + R²/2a, so dh = R cos e de + (sin e + R/a) dR.
Measurement measured(const tws::Plot& plot, double elevation_sigma) {
  const double sine = std::sin(plot.elevation);
  const double by_elevation = plot.range * std::cos(plot.elevation) * elevation_sigma;
  const double range_sigma = std::isnan(plot.range_sigma) ? 0.0 : plot.range_sigma;
  const double by_range = (sine + plot.range / tws::kEffectiveEarthRadius) * range_sigma;
  return {tws::heightOf(0.0, sine, plot.range), std::hypot(by_elevation, by_range)};
}

}  // namespace

void HeightFile::measure(std::uint32_t track, const tws::Plot& plot) {
  const bool said = !std::isnan(plot.elevation_sigma) && plot.elevation_sigma > 0.0;
  const Measurement z = measured(plot, said ? plot.elevation_sigma : params_.sigma);
  const double variance = z.sigma * z.sigma;
  const auto [entry, is_new] = filters_.try_emplace(track);
  Filter f = movedTo(entry->second, plot.time);
  const double innovation = z.height - f.height, spread = f.hh + variance;
  if (is_new || innovation * innovation > params_.gate_sigmas * params_.gate_sigmas * spread) {
    entry->second = {plot.time, z.height, 0.0, variance, 0.0, params_.climb_sigma * params_.climb_sigma};
    return;
  }
  const double gain_h = f.hh / spread, gain_c = f.hc / spread;
  f.height += gain_h * innovation;
  f.climb += gain_c * innovation;
  f.cc -= gain_c * f.hc;
  f.hc *= 1.0 - gain_h;
  f.hh *= 1.0 - gain_h;
  entry->second = f;
}

/// Constant climb, disturbed by white acceleration. An earlier time than the last search changes nothing but the
/// height.
HeightFile::Filter HeightFile::movedTo(const Filter& filter, double time) const {
  Filter f = filter;
  const double dt = time - filter.time, ahead = std::max(dt, 0.0), q = params_.climb_acceleration;
  f.time = std::max(filter.time, time);
  f.height += dt * filter.climb;
  f.hh += 2.0 * ahead * filter.hc + ahead * ahead * filter.cc + q * ahead * ahead * ahead / 3.0;
  f.hc += ahead * filter.cc + q * ahead * ahead / 2.0;
  f.cc += q * ahead;
  return f;
}

std::optional<Height> HeightFile::at(std::uint32_t track, double time) const {
  const auto found = filters_.find(track);
  if (found == filters_.end()) return std::nullopt;
  const Filter f = movedTo(found->second, time);
  if (f.hh > params_.greatest_sigma * params_.greatest_sigma) return std::nullopt;
  return Height{f.height, std::sqrt(f.hh), f.climb, std::sqrt(f.cc)};
}

std::optional<HeightGeometry> placeAt(double slant_range, double height) {
  const double seen = tws::sineOfElevation(0.0, height, slant_range);
  const double sine = tws::sineOfElevation(0.0, height, slant_range, tws::kMeanEarthRadius);
  if (std::abs(seen) > kSteepest || std::abs(sine) > kSteepest) return std::nullopt;
  return HeightGeometry{std::asin(seen), slant_range * std::sqrt(1.0 - sine * sine), slant_range * sine};
}

}  // namespace adit_tracker
