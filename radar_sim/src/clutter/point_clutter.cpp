#include "clutter/point_clutter.h"

#include <cmath>
#include <random>

#include <tws_core/geometry.h>

#include "detection_probability.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

constexpr std::uint64_t kStreamStep = 0x9e3779b97f4a7c15u;  // spreads the objects' numbers over all keys

}  // namespace

PointView::PointView(const ClutterView& view, const std::string& stream)
    : params_(view.params),
      map_to_site_(view.map_to_site),
      seed_(view.seed),
      stream_(RandomStream::hash(view.params.name + "/" + stream)),
      rate_stream_(RandomStream::hash(view.params.name + "/" + stream + "/range rate")) {}

void PointView::raise(const ClutterPoint& point, std::size_t number, const Spoke& spoke,
                      std::vector<Echo>& echoes) const {
  const tws::Polar polar = tws::polarFromEnu(map_to_site_ * point.position);
  const double part = spoke.partOf(polar.azimuth);
  if (part >= 1.0) return;
  RandomStream random(seed_, stream_ + number * kStreamStep, static_cast<std::uint64_t>(spoke.running));
  const double snr = meanSnr(params_, point.rcs / params_.clutter_suppression, polar.range, point.position.z());
  const double power = drawPower(Fluctuation::kExponential, snr, random);
  if (snr <= 0.0 || power < -std::log(params_.false_alarm_probability)) return;
  Echo echo{spoke.timeAt(part), polar.range, polar.azimuth, power};
  std::normal_distribution<> normal;
  const double cell = rangeCell(params_), beam = params_.azimuth_beamwidth;
  echo.range_error =
      std::hypot(noiseSigma(params_, params_.range_sigma, cell, power - 1.0), point.jitter) * normal(random);
  echo.azimuth_error =
      std::hypot(noiseSigma(params_, params_.azimuth_sigma, beam, power - 1.0), point.jitter / polar.range) *
      normal(random);
  if (params_.measuresRangeRates()) {
    RandomStream rates(seed_, rate_stream_ + number * kStreamStep, static_cast<std::uint64_t>(spoke.running));
    const Eigen::Vector3d direction = (map_to_site_ * point.position).normalized();
    echo.range_rate =
        drawRangeRate(params_, radialVelocity(map_to_site_, point.motion, direction), point.motion.spread, rates);
  }
  echoes.push_back(echo);
}

}  // namespace radar_sim
