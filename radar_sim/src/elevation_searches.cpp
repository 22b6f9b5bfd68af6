#include "elevation_searches.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "radar_equation.h"

namespace radar_sim {

ElevationSearches::ElevationSearches(const RadarParams& radar)
    : params_(radar.elevation_search), azimuth_beamwidth_(radar.azimuth_beamwidth) {}

std::size_t ElevationSearches::set(const std::vector<ElevationOrder>& orders, double north) {
  if (!params_) return 0;
  const auto isOver = [&](const Search& search) { return search.begin + params_->width <= north; };
  searches_.erase(std::remove_if(searches_.begin(), searches_.end(), isOver), searches_.end());
  const std::size_t taken = std::min(orders.size(), static_cast<std::size_t>(params_->per_turn));
  for (std::size_t i = 0; i < taken; ++i) searches_.push_back({north + orders[i].azimuth, orders[i].range});
  return taken;
}

double ElevationSearches::gainAt(double angle, double range) const {
  double best = 0.0;
  for (const Search& search : searches_) {
    const bool inside = angle >= search.begin && angle < search.begin + params_->width &&
                        std::abs(range - search.range) <= params_->range_interval / 2.0;
    if (inside) best = std::max(best, gainOf(search, angle));
  }
  return best;
}

/// Each scan has its own azimuth; a Gaussian beam, there and back.
double ElevationSearches::gainOf(const Search& search, double angle) const {
  const double step = params_->width / static_cast<double>(params_->scans);
  double gain = 0.0;
  for (long scan = 0; scan < params_->scans; ++scan) {
    const double off = (angle - search.begin - (static_cast<double>(scan) + 0.5) * step) / azimuth_beamwidth_;
    gain += std::exp(-8.0 * std::log(2.0) * off * off);
  }
  return gain;
}

RadarParams scanningBeam(const RadarParams& radar, double elevation) {
  RadarParams scanning = radar;
  scanning.beams = {{elevation, radar.elevation_search->beamwidth, 0.0}};
  scanning.pulses = radar.elevation_search->pulses;
  return scanning;
}

std::optional<ElevationLook> look(const RadarParams& radar, Fluctuation fluctuation, double mean_snr, double elevation,
                                  RandomStream& random) {
  const ElevationSearchParams& search = *radar.elevation_search;
  if (elevation < 0.0 || elevation > search.max_elevation) return std::nullopt;
  const double power = drawPower(fluctuation, mean_snr, random);
  if (power < -std::log(radar.false_alarm_probability)) return std::nullopt;
  const double sigma = noiseSigma(radar, search.elevation_sigma, search.beamwidth, power - 1.0);
  const double error = sigma > 0.0 ? std::normal_distribution<>(0.0, sigma)(random) : 0.0;
  return ElevationLook{power, elevation + error, sigma};
}

}  // namespace radar_sim
