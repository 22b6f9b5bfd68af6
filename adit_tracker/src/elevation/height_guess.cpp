#include "elevation/height_guess.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr double kSteepest = 0.25;  // square of sin 30°
constexpr double kFlattest = 0.1;   // least square of the ground range, as share of that of the slant range
// Of h² of a target that climbs and sinks by 5 m/s, a minute each, at 5 km: (2 h · 5 m/s)² · 60 s [m⁴/s].
constexpr double kClimbing = 1.5e11;

/// Heights from 0 to the greatest are alike likely: mean and standard deviation of their squares, as shares of its
/// square.
constexpr double kMeanSquare = 1.0 / 3.0;
constexpr double kSigmaSquare = 0.298;  // sqrt(1/5 - 1/9)

tws::Symmetric2 sumOf(const tws::Symmetric2& a, const tws::Symmetric2& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

}  // namespace

HeightGuess HeightGuess::below(double greatest, double slant_range) {
  // At the steepest angle, what is below counts as the greatest height.
  const double limit = std::min(greatest * greatest, kSteepest * slant_range * slant_range);
  HeightGuess guess;
  guess.squared = static_cast<float>(kMeanSquare * limit);
  guess.variance = static_cast<float>(kSigmaSquare * limit * kSigmaSquare * limit);
  return guess;
}

bool HeightGuess::known() const {
  constexpr double kGoodEnough = 1000.0;  // standard deviation [m]
  const double sigma = std::sqrt(variance);
  return variance > 0.0F && std::sqrt(squared + sigma) - std::sqrt(std::max(0.0, squared - sigma)) < 2.0 * kGoodEnough;
}

GuessedPlace HeightGuess::placeOf(const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                                  const tws::SiteFrame& site) const {
  const double r2 = plot.range * plot.range;
  const double ground = std::sqrt(std::max(r2 - squared, kFlattest * r2));
  const double azimuth = site.onPlane(plot.azimuth);
  GuessedPlace z{tws::planarMeasurement(ground, azimuth, range_sigma * plot.range / ground, azimuth_sigma), 0.0, 0.0};
  z.x_per_squared = -0.5 * z.place.x / (ground * ground);
  z.y_per_squared = -0.5 * z.place.y / (ground * ground);
  z.place.x += site.x;
  z.place.y += site.y;
  return z;
}

tws::PlanarPosition HeightGuess::begin(const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                                       const tws::SiteFrame& site) {
  const GuessedPlace z = placeOf(plot, range_sigma, azimuth_sigma, site);
  x_per_squared = static_cast<float>(z.x_per_squared);
  y_per_squared = static_cast<float>(z.y_per_squared);
  return z.place;
}

tws::PlanarPosition HeightGuess::against(const GuessedPlace& z) const {
  const double dx = z.x_per_squared - x_per_squared, dy = z.y_per_squared - y_per_squared;
  tws::PlanarPosition wider = z.place;
  wider.covariance = sumOf(wider.covariance, {variance * dx * dx, variance * dx * dy, variance * dy * dy});
  return wider;
}

tws::Symmetric2 HeightGuess::widened(const tws::Symmetric2& position) const {
  const double x = x_per_squared, y = y_per_squared;
  return sumOf(position, {variance * x * x, variance * x * y, variance * y * y});
}

tws::PlanarPosition HeightGuess::moveTo(double new_squared) {
  const double change = new_squared - squared;
  squared = static_cast<float>(new_squared);
  return {x_per_squared * change, y_per_squared * change, {}};
}

tws::PlanarPosition HeightGuess::flatten(double slant_range) {
  constexpr double kSure = 0.1;        // of the height's square, as share of it
  constexpr double kStraightUp = 0.9;  // a target that is known to be high may pass overhead
  const double share = variance < kSure * squared * squared ? kStraightUp : kSteepest;
  return moveTo(std::min<double>(squared, share * slant_range * slant_range));
}

void HeightGuess::age(double dt, double greatest) {
  const double sigma = kSigmaSquare * greatest * greatest;
  variance = static_cast<float>(std::min(variance + kClimbing * dt, std::max<double>(variance, sigma * sigma)));
}

tws::PlanarPosition HeightGuess::learn(const GuessedPlace& z, const tws::PlanarPosition& predicted, double greatest) {
  const tws::Symmetric2 S = sumOf(predicted.covariance, against(z).covariance), P = predicted.covariance;
  const double inverse = 1.0 / S.determinant();
  const tws::Symmetric2 W{S.yy * inverse, -S.xy * inverse, S.xx * inverse};
  const double dx = z.x_per_squared - x_per_squared, dy = z.y_per_squared - y_per_squared;
  const double wx = W.xx * dx + W.xy * dy, wy = W.xy * dx + W.yy * dy;
  const double error = variance * (wx * (z.place.x - predicted.x) + wy * (z.place.y - predicted.y));
  variance = static_cast<float>(variance * std::max(0.0, 1.0 - variance * (wx * dx + wy * dy)));
  // The corrected position depends on the height as prediction and plot do, by the weights of the correction.
  x_per_squared += static_cast<float>(P.xx * wx + P.xy * wy);
  y_per_squared += static_cast<float>(P.xy * wx + P.yy * wy);
  return moveTo(std::clamp(squared - error, 0.0, greatest * greatest));
}

}  // namespace adit_tracker
