#include "track_window.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace range_gate_tracker {
namespace {

// A target is never taken to be nearer than this where a distance is turned into an angle [m].
constexpr double kNearest = 1.0;

double squared(double x) { return x * x; }

/// The angle under which a distance is seen across the line of sight, at most `widest`.
double angleOf(double distance, double range, double widest) {
  return distance >= range ? widest : std::min(std::asin(distance / std::max(range, kNearest)), widest);
}

/// Weights of plots: amplitudes, or all alike when some signal-to-noise ratio [dB] is unknown.
std::vector<double> weightsOf(const std::vector<tws::Plot>& plots) {
  const bool known = std::all_of(plots.begin(), plots.end(), [](const auto& e) { return std::isfinite(e.snr); });
  std::vector<double> weights;
  weights.reserve(plots.size());
  for (const tws::Plot& plot : plots) weights.push_back(known ? std::pow(10.0, plot.snr / 20.0) : 1.0);
  return weights;
}

tws::Plot centreOfGravity(const std::vector<tws::Plot>& plots) {
  const std::vector<double> weights = weightsOf(plots);
  tws::Plot centre = plots.front();
  double total = 0.0, time = 0.0, range = 0.0, azimuth = 0.0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    total += weights[i];
    time += weights[i] * (plots[i].time - centre.time);
    range += weights[i] * (plots[i].range - centre.range);
    azimuth += weights[i] * tws::angularDifference(plots[i].azimuth, centre.azimuth);
  }
  centre.time += time / total;
  centre.range += range / total;
  centre.azimuth = tws::wrapTwoPi(centre.azimuth + azimuth / total);
  return centre;
}

}  // namespace

bool TrackWindow::contains(const tws::Plot& plot) const {
  return std::abs(plot.range - range) <= half_range &&
         std::abs(tws::angularDifference(plot.azimuth, azimuth)) <= half_azimuth;
}

double TrackWindow::distance(const tws::Plot& plot) const {
  return std::hypot((plot.range - range) / half_range, tws::angularDifference(plot.azimuth, azimuth) / half_azimuth);
}

WindowSize acquisitionSize(double range, double dt, const PlotSigmas& sigmas, const WindowParams& params) {
  const double manoeuvre = params.greatest_speed * dt + 0.5 * params.greatest_acceleration * dt * dt;
  return {manoeuvre + params.window_sigmas * sigmas.range,
          std::min(params.widest, angleOf(manoeuvre, range, params.widest) + params.window_sigmas * sigmas.azimuth)};
}

WindowSize trackingSize(double range, double dt, const PlotSigmas& sigmas, const PredictionError& error, int misses,
                        const WindowParams& params) {
  const WindowSize most = acquisitionSize(range, dt, sigmas, params);
  const double sigmas_now = params.window_sigmas * (1.0 + misses);
  const double across = std::sqrt(std::max(error.across, 2.0 * squared(range * sigmas.azimuth)));
  const double along = std::sqrt(std::max(error.range, 2.0 * squared(sigmas.range)));
  return {std::min(most.range, sigmas_now * along),
          std::min(most.azimuth, angleOf(sigmas_now * across, range, params.widest))};
}

PredictionError firstError(double range, double dt, const PlotSigmas& sigmas, const WindowParams& params) {
  const double manoeuvre = squared(params.manoeuvre * dt * dt);
  return {6.0 * squared(sigmas.range) + manoeuvre, 6.0 * squared(range * sigmas.azimuth) + manoeuvre};
}

void learnError(PredictionError& error, const tws::Plot& measured, const WindowKinematics& predicted, double weight) {
  const double along = measured.range - predicted.range;
  const double across = measured.range * tws::angularDifference(measured.azimuth, predicted.azimuth);
  error.range += weight * (along * along - error.range);
  error.across += weight * (across * across - error.across);
}

tws::Plot resolved(const std::vector<tws::Plot>& plots, const TrackWindow& window, Ambiguity rule) {
  if (rule == Ambiguity::kCentreOfGravity) return centreOfGravity(plots);
  return *std::min_element(plots.begin(), plots.end(), [&](const tws::Plot& a, const tws::Plot& b) {
    return window.distance(a) < window.distance(b);
  });
}

}  // namespace range_gate_tracker
