#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "target.h"

namespace radar_sim {

/// What a radar of high range resolution sees of one target: scatterers along its length, which fade each by itself.
class Scatterers {
 public:
  /// `stream`: key of the random numbers, one for each radar and target.
  Scatterers(const Target& target, std::uint64_t seed, std::uint64_t stream);

  /// Moves the fading on by dt [s], with the random numbers of that profile.
  void fade(std::uint32_t profile, double dt);

  struct Scatterer {
    double offset = 0.0;             ///< Along the target's course from its middle [m].
    double phase = 0.0;              ///< [rad]
    std::complex<double> fading[2];  ///< Two Gaussian components of mean power 1.
  };
  const std::vector<Scatterer>& all() const { return scatterers_; }
  /// Amplitude [m]: its square has the mean rcs / number of scatterers [m²].
  std::complex<double> amplitude(const Scatterer& scatterer) const;

 private:
  Reflection reflection_;
  double fading_time_;
  std::uint64_t seed_, stream_;
  std::vector<Scatterer> scatterers_;
  bool has_faded_ = false;
};

}  // namespace radar_sim
