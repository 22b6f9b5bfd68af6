#pragma once

#include "random_stream.h"

namespace radar_sim {

/// How a target's radar cross-section fluctuates from scan to scan (Swerling, "Probability of detection for fluctuating
/// targets", IRE Trans. IT-6, 1960). One test a scan, after the integration of the dwell's pulses.
enum class Fluctuation {
  kSteady,       ///< Swerling 0: none.
  kExponential,  ///< Swerling 1: many equal scatterers, exponential power.
  kOneDominant,  ///< Swerling 3: one dominant scatterer, gamma power of shape 2.
};

/// Chance that one scan detects, after a square-law detector whose threshold gives the false-alarm probability `pfa`.
/// `mean_snr`: linear power ratio, >= 0. `pfa` in (0, 1). With T = -ln(pfa) and S the mean SNR:
///   Swerling 0: Q1(sqrt(2 S), sqrt(2 T))                        (Marcum's Q function)
///   Swerling 1: pfa^(1 / (1 + S))
///   Swerling 3: exp(-T/c) (1 + (1 - 1/c) T/c), c = 1 + S/2
/// Throws std::invalid_argument outside these ranges.
double detectionProbability(Fluctuation fluctuation, double mean_snr, double pfa);

/// The mean SNR (linear) at which detectionProbability() is `probability`, in (pfa, 1).
double snrForDetectionProbability(Fluctuation fluctuation, double probability, double pfa);

/// Power behind the square-law detector on one scan, in units of the mean noise power: the fluctuating echo in noise.
/// It exceeds -ln(pfa) with the probability that detectionProbability() states.
double drawPower(Fluctuation fluctuation, double mean_snr, RandomStream& random);
/// Its two parts: the power of the fluctuating echo alone, and that of an echo of this power in noise.
double drawSignalPower(Fluctuation fluctuation, double mean_snr, RandomStream& random);
double addNoise(double signal_power, RandomStream& random);

/// Marcum's Q function of order 1, Q1(a, b), for a, b >= 0.
double marcumQ(double a, double b);

}  // namespace radar_sim
