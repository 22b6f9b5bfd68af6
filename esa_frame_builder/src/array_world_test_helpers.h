#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include <tws_core/random_test_helpers.h>
#include <tws_core/sine_space.h>

#include "array_pose.h"
#include "frame_view.h"

namespace esa_frame_builder {

/// A small world for tests: targets on straight lines before an array at the origin, and a schedule of dwells that does
/// not depend on any tracker. Each resource period of 0.1 s has ten dwells: three overlapping beams over a group of
/// closely spaced objects, two on targets elsewhere in turn, and five of a search raster where nothing is.
class ArrayWorld {
 public:
  static constexpr double kPeriod = 0.1;  // [s]
  static constexpr double kBeamwidth = 0.035;
  static constexpr std::size_t kObjects = 8;  // closely spaced, within two beamwidths
  static constexpr std::size_t kSeparate = 4;

  struct Target {
    Eigen::Vector3d place, velocity;  // in the array's frame, at time 0
    double snr;                       // mean, in the beam's centre
    Eigen::Vector3d at(double time) const { return place + time * velocity; }
  };

  explicit ArrayWorld(std::uint64_t seed) : generator_(seed) {
    for (std::size_t i = 0; i < kObjects; ++i) addObject(i);
    for (std::size_t i = 0; i < kSeparate; ++i)
      targets_.push_back(
          {tws::arrayFromRuv({70e3 + 9e3 * static_cast<double>(i), separateU(i), 0.1}), {-200.0, 40.0, 0.0}, 100.0});
  }

  const std::vector<Target>& targets() const { return targets_; }

  /// The dwells of the period that begins at `start` [s].
  std::vector<Dwell> dwells(double start) {
    std::vector<Dwell> dwells;
    const tws::Ruv centre = tws::ruvFromArray(0.5 * (targets_[0].at(start) + targets_[kObjects - 1].at(start)));
    for (int beam = -1; beam <= 1; ++beam) point(dwells, start, centre.u + 0.7 * kBeamwidth * beam, centre.v, true);
    for (int n = 0; n < 2; ++n) {
      const std::size_t i = kObjects + static_cast<std::size_t>(turn_++) % kSeparate;
      const tws::Ruv place = tws::ruvFromArray(targets_[i].at(start));
      point(dwells, start, place.u, place.v, true);
    }
    for (int n = 0; n < 5; ++n, ++raster_) point(dwells, start, 0.8 * kBeamwidth * (raster_ % 20 - 10), -0.2, false);
    return dwells;
  }

 private:
  // A loose line across the beams, each 150 m deeper than the one before, so that range parts them.
  void addObject(std::size_t i) {
    const double step = 2.0 * kBeamwidth / (kObjects - 1), number = static_cast<double>(i);
    const double u = -0.1 + step * number, v = tws::uniform(generator_, -0.004, 0.004);
    const double range = 60e3 + 150.0 * static_cast<double>((3 * i) % kObjects);
    targets_.push_back({tws::arrayFromRuv({range, u, v}),
                        {-200.0 + tws::uniform(generator_, -5.0, 5.0), tws::uniform(generator_, -5.0, 5.0), 0.0},
                        100.0});
  }

  static double separateU(std::size_t i) { return -0.4 + 0.25 * static_cast<double>(i); }

  void point(std::vector<Dwell>& dwells, double start, double u, double v, bool is_track_dwell) {
    Dwell dwell;
    dwell.number = number_++;
    dwell.time = start + 0.01 * (static_cast<double>(dwells.size()) + 0.5);
    dwell.u = u;
    dwell.v = v;
    dwell.is_track_dwell = is_track_dwell;
    dwell.beamwidth_u = dwell.beamwidth_v = kBeamwidth;
    dwell.range_max = 150e3;
    for (std::size_t i = 0; i < targets_.size(); ++i) look(dwell, i);
    dwells.push_back(std::move(dwell));
  }

  // Swerling 1 with a false-alarm probability of 1e-6; the threshold is -ln of that. Indices of the targets stand in
  // for the numbers of the tracks that a resource manager expects in the dwell.
  void look(Dwell& dwell, std::size_t i) {
    const tws::Ruv place = tws::ruvFromArray(targets_[i].at(dwell.time));
    const double loss = beamLoss(dwell, {true, place.range, place.u, place.v, Eigen::Matrix2d::Zero()});
    if (dwell.is_track_dwell && loss >= 0.25) dwell.group_indices.push_back(static_cast<std::uint32_t>(i + 1));
    const double power = (1.0 + targets_[i].snr * loss) * std::exponential_distribution<double>()(generator_);
    if (power < std::log(1e6)) return;
    const double range_sigma = 30.0 / std::sqrt(2.0 * power), angle_sigma = 0.6 * kBeamwidth / std::sqrt(2.0 * power);
    Measurement measurement;
    measurement.range = place.range + noise(range_sigma);
    measurement.u = place.u + noise(angle_sigma);
    measurement.v = place.v + noise(angle_sigma);
    measurement.covariance.diagonal() << range_sigma * range_sigma, angle_sigma * angle_sigma,
        angle_sigma * angle_sigma;
    measurement.snr = power;
    dwell.measurements.push_back(measurement);
  }

  double noise(double sigma) { return std::normal_distribution<double>(0.0, sigma)(generator_); }

  std::mt19937_64 generator_;
  std::vector<Target> targets_;
  std::uint32_t number_ = 0;
  int turn_ = 0, raster_ = 0;
};

}  // namespace esa_frame_builder
