#include "core/stray_plots.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

constexpr double kStray = 0.01;  // chance of a stray plot, of a target that was not detected
constexpr double kWider = 3.0;   // its errors against those of others
constexpr double kReach = 4.0;   // of these, standard deviations

}  // namespace

void suspectStrays(const Track& track, RadarState& radar, std::int64_t running) {
  if (!track.firm) return;
  const Prediction& p = track.predicted;
  constexpr double kSquared = kWider * kWider;
  const tws::Symmetric2 wide{kSquared * p.innovation.xx, kSquared * p.innovation.xy, kSquared * p.innovation.yy};
  const double greatest = kStray * track.existence / (2.0 * tws::kPi * std::sqrt(wide.determinant()));
  const auto suspect = [&](Detection& detection, double by_range, double by_azimuth) {
    const double stray = greatest * std::exp(-0.5 * wide.mahalanobis(by_range, p.range * by_azimuth));
    const double others = radar.quality.falsePlotMap().density(detection.plot.range, detection.plot.azimuth);
    detection.fresh *= others / (others + stray);
  };
  const double along = kReach * std::sqrt(wide.xx);
  const double across = std::min(tws::kSectorWidth, kReach * std::sqrt(wide.yy) / p.range);
  for (std::int64_t s = running - 1; s <= running + 1; ++s)
    radar.detections.at(s).near(p.range, p.azimuth, along, across, suspect);
}

}  // namespace adit_tracker
