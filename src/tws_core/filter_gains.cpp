#include <tws_core/filter_gains.h>

#include <algorithm>
#include <cmath>

namespace tws {
namespace {

/// With u = 1 - s, where α = 1 - s², β = 2(1 - s)², γ = β²/(2α), the cubic s³ + (Λ/2 - 3)s² + (Λ/2 + 3)s - 1 = 0 is
/// u³ = Λ/2·(1 - u)(2 - u): no difference of nearly equal numbers where Λ is small.
FilterGains steadyAlphaBetaGamma(double index) {
  double u = std::min(1.0, std::cbrt(index));  // at the root or beyond
  for (int i = 0; i < 50; ++i) {
    const double step =
        (u * u * u - 0.5 * index * (1.0 - u) * (2.0 - u)) / (3.0 * u * u + 0.5 * index * (3.0 - 2.0 * u));
    u -= step;
    if (std::abs(step) < 1e-15 * u) break;
  }
  const double alpha = u * (2.0 - u), beta = 2.0 * u * u;
  return {alpha, beta, beta * beta / (2.0 * alpha)};
}

}  // namespace

int degreeOf(const FilterGains& gains) {
  if (gains.gamma != 0.0) return 2;
  return gains.beta != 0.0 ? 1 : 0;
}

bool isStable(const FilterGains& gains) {
  const auto [alpha, beta, gamma] = gains;
  const int degree = degreeOf(gains);
  if (degree == 0) return alpha > 0.0 && alpha < 2.0;
  const bool alpha_beta = alpha > 0.0 && beta > 0.0 && 4.0 - 2.0 * alpha - beta > 0.0;
  return alpha_beta && (degree == 1 || (gamma > 0.0 && gamma * (2.0 - alpha) < 2.0 * alpha * beta));
}

double predictedLag(const FilterGains& gains, double derivative, double T) {
  const int degree = degreeOf(gains);
  if (degree == 0) return derivative * T / gains.alpha;
  return degree == 1 ? derivative * T * T / gains.beta : derivative * T * T * T / gains.gamma;
}

double smoothedLag(const FilterGains& gains, double derivative, double T) {
  return (1.0 - gains.alpha) * predictedLag(gains, derivative, T);
}

double meanAge(double alpha) { return (1.0 - alpha) / alpha; }

NoiseReduction noiseReduction(const FilterGains& gains, double T) {
  const auto [a, b, g] = gains;
  if (degreeOf(gains) == 0) return {a / (2.0 - a), 0.0, 0.0};
  const double edge = 4.0 - 2.0 * a - b;  // 0 where the stability region ends, as is `inner`
  const double inner = edge * (2.0 * a * b + a * g - 2.0 * g);
  const double T2 = T * T;
  return {(2.0 * b * (2.0 * a * a + 2.0 * b - 3.0 * a * b) - a * g * edge) / inner,
          (4.0 * b * b * b - 4.0 * b * b * g + 2.0 * g * g * (2.0 - a)) / (inner * T2),
          4.0 * b * g * g / (inner * T2 * T2)};
}

FilterGains expandingGains(int degree, int count) {
  const double n = count;
  switch (std::min(degree, count - 1)) {
    case 0:
      return {1.0 / n, 0.0, 0.0};
    case 1:
      return {2.0 * (2.0 * n - 1.0) / (n * (n + 1.0)), 6.0 / (n * (n + 1.0)), 0.0};
    default:
      const double product = n * (n + 1.0) * (n + 2.0);
      return {3.0 * (3.0 * n * n - 3.0 * n + 2.0) / product, 18.0 * (2.0 * n - 1.0) / product, 60.0 / product};
  }
}

FilterGains fadingGains(int degree, double theta) {
  const double fresh = 1.0 - theta;
  if (degree == 0) return {fresh, 0.0, 0.0};
  if (degree == 1) return {1.0 - theta * theta, fresh * fresh, 0.0};
  return {1.0 - theta * theta * theta, 1.5 * fresh * fresh * (1.0 + theta), fresh * fresh * fresh};
}

double trackingIndex(double acceleration_sigma, double measurement_sigma, double T) {
  return acceleration_sigma * T * T / measurement_sigma;
}

FilterGains steadyGains(int degree, double index) {
  if (index == 0.0) return {};
  if (degree == 0) return {index * (std::sqrt(index * index + 16.0) - index) / 8.0, 0.0, 0.0};
  if (degree == 2) return steadyAlphaBetaGamma(index);
  // Λ² = β²/(1 - α) and β = 2(2 - α) - 4√(1 - α), with u = 1 - √(1 - α): 2u² = Λ(1 - u).
  const double u = 2.0 * index / (index + std::sqrt(index * index + 8.0 * index));
  return {u * (2.0 - u), 2.0 * u * u, 0.0};
}

}  // namespace tws
