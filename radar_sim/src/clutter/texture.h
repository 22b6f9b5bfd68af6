#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

namespace radar_sim {

/// How the mean power of clutter varies over place and time.
struct TextureParams {
  double spread_db = 5.0;  ///< Standard deviation of the level in decibels; 0: even.
  double length = 2000.0;  ///< Over which the level's correlation falls as exp(-d²/2 length²) [m].
  double time = 300.0;     ///< Over which it falls as exp(-t/time) [s]; infinite: it stays.
};

/// A log-normal random field of mean 1 over the map and time. Its level (the logarithm) is a sum of cosines with random
/// wave vectors, frequencies and phases (Shinozuka and Jan, "Digital simulation of random processes and its
/// applications", J. Sound and Vibration 25, 1972): wave vectors are normal, frequencies Cauchy, which gives the
/// correlations above exactly. It needs no memory: each radar may ask for any place and time, in any order.
class Texture {
 public:
  Texture(const TextureParams& params, std::uint64_t seed, const std::string& stream);

  /// `place`: east, north [m]; `time` [s].
  double at(const Eigen::Vector2d& place, double time) const;
  /// Almost never exceeded: four standard deviations up.
  double greatest() const { return greatest_; }

 private:
  struct Wave {
    double east, north;  // [rad/m]
    double frequency;    // [rad/s]
    double phase;        // [rad]
  };
  static constexpr std::size_t kWaves = 24;

  double scale_;     // of the sum of cosines, in nepers of power
  double mean_log_;  // what makes the mean 1
  double greatest_;
  std::array<Wave, kWaves> waves_{};
};

}  // namespace radar_sim
