#include "resolution.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {
namespace {

/// Sets the centre of power of the elevations, of echoes that have one.
void mergeElevations(const std::vector<Echo>& cell, Echo& merged) {
  double power = 0.0, sum = 0.0;
  for (const Echo& echo : cell) {
    if (std::isnan(echo.elevation)) continue;
    power += echo.power;
    sum += echo.power * echo.elevation;
    merged.elevation_sigma = echo.elevation_sigma;
  }
  if (power > 0.0) merged.elevation = sum / power;
}

Echo merge(const std::vector<Echo>& cell) {
  const auto weaker = [](const Echo& a, const Echo& b) { return a.power < b.power; };
  Echo merged = *std::max_element(cell.begin(), cell.end(), weaker);
  if (cell.size() == 1) return merged;
  const Echo strongest = merged;
  double power = 0.0;
  for (const Echo& echo : cell) power += echo.power;
  for (const Echo& echo : cell) {
    const double weight = echo.power / power;
    merged.time += weight * (echo.time - strongest.time);
    merged.range += weight * (echo.range - strongest.range);
    merged.azimuth += weight * tws::angularDifference(echo.azimuth, strongest.azimuth);
  }
  merged.power = power;
  mergeElevations(cell, merged);
  return merged;
}

}  // namespace

std::vector<Echo> resolve(std::vector<Echo>& pending, double until, double range_cell, double azimuth_cell) {
  std::vector<Echo> resolved;
  while (!pending.empty() && pending.front().time < until) {
    const Echo anchor = pending.front();
    const auto isOutside = [&](const Echo& echo) {
      return std::abs(echo.range - anchor.range) >= range_cell ||
             std::abs(tws::angularDifference(echo.azimuth, anchor.azimuth)) >= azimuth_cell;
    };
    const auto cell = std::stable_partition(pending.begin(), pending.end(), isOutside);
    resolved.push_back(merge({cell, pending.end()}));
    pending.erase(cell, pending.end());
  }
  return resolved;
}

}  // namespace radar_sim
