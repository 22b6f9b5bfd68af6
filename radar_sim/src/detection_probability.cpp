#include "detection_probability.h"

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace radar_sim {
namespace {

void check(double mean_snr, double pfa) {
  if (!(mean_snr >= 0.0)) throw std::invalid_argument("mean SNR " + std::to_string(mean_snr) + " is not >= 0");
  if (!(pfa > 0.0 && pfa < 1.0))
    throw std::invalid_argument("false-alarm probability " + std::to_string(pfa) + " is not in (0, 1)");
}

}  // namespace

// b² of a square-law detector's two quadratures is noncentral chi-squared, with a² as its noncentrality.
double marcumQ(double a, double b) {
  if (a == 0.0) return std::exp(-b * b / 2.0);
  return boost::math::cdf(boost::math::complement(boost::math::non_central_chi_squared(2.0, a * a), b * b));
}

double detectionProbability(Fluctuation fluctuation, double mean_snr, double pfa) {
  check(mean_snr, pfa);
  const double threshold = -std::log(pfa);
  if (fluctuation == Fluctuation::kExponential) return std::pow(pfa, 1.0 / (1.0 + mean_snr));
  if (fluctuation == Fluctuation::kSteady) return marcumQ(std::sqrt(2.0 * mean_snr), std::sqrt(2.0 * threshold));
  const double c = 1.0 + mean_snr / 2.0;
  return std::exp(-threshold / c) * (1.0 + (1.0 - 1.0 / c) * threshold / c);
}

double snrForDetectionProbability(Fluctuation fluctuation, double probability, double pfa) {
  check(0.0, pfa);
  if (!(probability > pfa && probability < 1.0)) {
    throw std::invalid_argument("detection probability " + std::to_string(probability) +
                                " is not between the false-alarm probability and 1");
  }
  double low = 0.0;
  double high = 1.0;
  while (detectionProbability(fluctuation, high, pfa) < probability) high *= 2.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (detectionProbability(fluctuation, middle, pfa) < probability ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

double drawPower(Fluctuation fluctuation, double mean_snr, RandomStream& random) {
  return addNoise(drawSignalPower(fluctuation, mean_snr, random), random);
}

double drawSignalPower(Fluctuation fluctuation, double mean_snr, RandomStream& random) {
  if (fluctuation == Fluctuation::kSteady || mean_snr <= 0.0) return mean_snr;
  if (fluctuation == Fluctuation::kExponential) return std::exponential_distribution<>(1.0 / mean_snr)(random);
  return std::gamma_distribution<>(2.0, mean_snr / 2.0)(random);
}

double addNoise(double signal_power, RandomStream& random) {
  std::normal_distribution<> noise(0.0, std::sqrt(0.5));
  const double in_phase = std::sqrt(signal_power) + noise(random);
  const double quadrature = noise(random);
  return in_phase * in_phase + quadrature * quadrature;
}

}  // namespace radar_sim
