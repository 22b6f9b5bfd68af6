#include "elevation/height_guess.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr double kSteepest = 0.5;          // sine of 30°
constexpr double kClimbing = 25.0 * 60.0;  // of a target that climbs and sinks by 5 m/s, a minute each [m²/s]
// What is learned may be higher than what is assumed: by so much.
constexpr double kHigher = 2.0;

/// Heights from 0 to the greatest are alike likely. The guess is the root of the mean square, so that the ground range
/// near the site is right in the mean; the standard deviation is about that. Both as shares of the greatest.
constexpr double kMean = 0.57735;   // sqrt(1/3)
constexpr double kSigma = 0.29888;  // sqrt(1/12 + (kMean - 1/2)²)

tws::Symmetric2 sumOf(const tws::Symmetric2& a, const tws::Symmetric2& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

}  // namespace

HeightGuess HeightGuess::below(double greatest, double slant_range) {
  // At the steepest angle, what is below counts as the greatest height.
  const double limit = std::min(greatest, kSteepest * slant_range);
  HeightGuess guess;
  guess.height = static_cast<float>(kMean * limit);
  guess.variance = static_cast<float>(kSigma * limit * kSigma * limit);
  return guess;
}

bool HeightGuess::known() const {
  constexpr double kGoodEnough = 1000.0;  // standard deviation [m]
  return variance > 0.0F && variance < kGoodEnough * kGoodEnough;
}

void HeightGuess::begin(const tws::PlaceAtHeight& z) {
  x_per_height = static_cast<float>(z.x_per_height);
  y_per_height = static_cast<float>(z.y_per_height);
}

tws::PlanarPosition HeightGuess::against(const tws::PlaceAtHeight& z) const {
  const double dx = z.x_per_height - x_per_height, dy = z.y_per_height - y_per_height;
  tws::PlanarPosition wider = z.place;
  // Ground range bends with the height: its second derivative is the first one over the height above the site's plane.
  constexpr double kLeast = 500.0;  // of that [m]; there both are small
  const double up2 = std::max(z.up * z.up, kLeast * kLeast), bent = variance * (1.0 + 0.5 * variance / up2);
  wider.covariance = sumOf(wider.covariance, {bent * dx * dx, bent * dx * dy, bent * dy * dy});
  return wider;
}

tws::Symmetric2 HeightGuess::widened(const tws::Symmetric2& position) const {
  const double x = x_per_height, y = y_per_height;
  return sumOf(position, {variance * x * x, variance * x * y, variance * y * y});
}

tws::PlanarPosition HeightGuess::moveTo(double new_height) {
  const double change = new_height - height;
  height = static_cast<float>(new_height);
  return {x_per_height * change, y_per_height * change, {}};
}

tws::PlanarPosition HeightGuess::flatten(double slant_range, double antenna) {
  constexpr double kSure = 0.15;        // standard deviation as share of the height
  constexpr double kStraightUp = 0.95;  // a target that is known to be high may pass overhead
  const bool sure = variance < kSure * kSure * height * height;
  const double limit = std::max(antenna, 0.0) + (sure ? kStraightUp : kSteepest) * slant_range;
  return height > limit ? moveTo(limit) : tws::PlanarPosition{};
}

void HeightGuess::age(double dt, double greatest) {
  const double sigma = kSigma * greatest;
  variance = static_cast<float>(std::min(variance + kClimbing * dt, std::max<double>(variance, sigma * sigma)));
}

tws::PlanarPosition HeightGuess::learn(const tws::PlaceAtHeight& z, const tws::PlanarPosition& predicted,
                                       double greatest) {
  const tws::Symmetric2 S = sumOf(predicted.covariance, against(z).covariance), P = predicted.covariance;
  const double inverse = 1.0 / S.determinant();
  const tws::Symmetric2 W{S.yy * inverse, -S.xy * inverse, S.xx * inverse};
  const double dx = z.x_per_height - x_per_height, dy = z.y_per_height - y_per_height;
  const double wx = W.xx * dx + W.xy * dy, wy = W.xy * dx + W.yy * dy;
  const double error = variance * (wx * (z.place.x - predicted.x) + wy * (z.place.y - predicted.y));
  variance = static_cast<float>(variance * std::max(0.0, 1.0 - variance * (wx * dx + wy * dy)));
  // The corrected position depends on the height as prediction and plot do, by the weights of the correction.
  x_per_height += static_cast<float>(P.xx * wx + P.xy * wy);
  y_per_height += static_cast<float>(P.xy * wx + P.yy * wy);
  return moveTo(std::clamp(height - error, 0.0, kHigher * greatest));
}

}  // namespace adit_tracker
