#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <tws_core/range_rate.h>
#include <tws_core/turning_motion.h>
#include <tws_core/units.h>

namespace tws {

/// What the filter assumes. One set serves all tracks.
struct MultipleModelParams {
  // Of a turn that begins, one model each way [rad/s], (0, 0.5]; its standard deviation, 0: all turns are alike. In the
  // turn the rate is estimated.
  double turn_rate = radians(2.2);
  double turn_rate_sigma = radians(0.9);
  double straight_acceleration = 0.07;  // White acceleration density of the straight model [m²/s³].
  double turning_acceleration = 2.0;    // The same of the turning models,
  double free_acceleration = 60.0;      // and of the model of any other motion: changes of speed, hard turns.
  double straight_time = 200.0;         // Mean time between manoeuvres [s].
  double turning_time = 30.0;           // Mean time of a turn [s],
  double free_time = 20.0;              // and of any other motion.
  double free_share = 0.05;             // Of manoeuvres, those that are no turns [0, 1); 0: without that model.
  // A 2-D radar sees slant range: close to it, straight flight at a height looks accelerated on the plane. The height
  // [m] that is assumed for that, 0: the plane is all there is.
  double assumed_height = 10000.0;
  // A measurement that no model explains is taken for a hard manoeuvre of this acceleration (standard deviation, each
  // axis) [m/s²]; 0: never.
  double manoeuvre_acceleration = 20.0;
  double speed_sigma = 150.0;  // Of each velocity component before it is known [m/s].
  // The same of what is much faster, in the model of any other motion; 0: nothing is. And the share of new targets
  // that may be so.
  double fast_speed_sigma = 500.0;
  double fast_share = 0.03;
  // Where slant ranges are measured from [m]; empty: from the origin alone.
  struct Place {
    double x, y;
  };
  std::vector<Place> sites;
};

/// Interacting multiple models (Blom & Bar-Shalom 1988) on the plane: straight flight, turn to the left, turn to the
/// right, both with a rate that is estimated, and any other motion, each a Kalman filter. It removes the pass-course
/// effect of filters in polar coordinates and follows turns without being noisy in between.
class MultipleModelFilter {
 public:
  static constexpr std::size_t kModels = 4;

  /// A track from its first measurement, at rest, with velocity unknown.
  void start(const PlanarPosition& measurement, const MultipleModelParams& params);

  /// Gives all models this velocity [m/s] with this covariance [m²/s²].
  void setVelocity(double vx, double vy, const Symmetric2& covariance);

  /// Moves on by dt [s] ≥ 0, corrects by the measurement. Returns the natural logarithm of the measurement's likelihood
  /// [1/m²].
  double update(const PlanarPosition& measurement, double dt, const MultipleModelParams& params) {
    return update(measurement, {}, dt, params);
  }
  /// The same with the range rate that was measured there and then; the likelihood is that of both [s/m³], of a rate
  /// that is not known that of the position.
  double update(const PlanarPosition& measurement, const RangeRate& rate, double dt, const MultipleModelParams& params);

  /// Corrects by a range rate that was measured now. Returns the logarithm of its likelihood [s/m].
  double correctBy(const RangeRate& rate);

  /// A measurement, and the chance that it is the target's.
  struct Weighed {
    PlanarPosition position;
    double chance;
    RangeRate rate = {};
  };

  /// Moves on by dt [s] ≥ 0 and corrects by one of several measurements or none, nobody knows which: `missed` is the
  /// chance of none, and all chances add up to 1. Each model becomes one Gaussian with the mean and covariance of all
  /// these cases.
  void update(const std::vector<Weighed>& measurements, double missed, double dt, const MultipleModelParams& params);

  /// Moves the target, as it is known, by so much [m].
  void shift(double dx, double dy);

  /// The mixture moved on by dt [s], by one Gaussian of the same mean and covariance.
  PlanarMotion predict(double dt, const MultipleModelParams& params) const;

  /// The position of that alone, at less cost.
  PlanarPosition predictPosition(double dt, const MultipleModelParams& params) const;

  /// Standard deviation of the displacement that a hard manoeuvre adds in dt [s], in each axis [m].
  static double manoeuvreSigma(double dt, const MultipleModelParams& params) {
    return 0.5 * params.manoeuvre_acceleration * dt * dt;
  }

  /// The mean of the mixture now; its covariances are left at 0.
  PlanarMotion mean() const;

  /// Chance that the target flies straight now, 0..1.
  double straightProbability() const { return probability_[0]; }
  /// The same of straight flight, a turn to the left (anticlockwise), one to the right, and any other motion.
  const std::array<double, kModels>& probabilities() const { return probability_; }

 private:
  void mix(double dt, const MultipleModelParams& params);
  double correctBy(const PlanarPosition& measurement, const RangeRate& rate, double dt,
                   const MultipleModelParams& params);
  double weigh(const std::array<MeasurementFit, kModels>& fit);
  void merge(const std::vector<MultipleModelFilter>& cases, std::size_t model);

  std::array<TurningMotion, kModels> state_;
  std::array<double, kModels> probability_{};
};

}  // namespace tws
