#include "accuracy.h"

#include <Eigen/Cholesky>

namespace track_evaluation {
namespace {

/// NaN when the covariance is not positive definite.
template <int N>
double normalisedSquare(const Eigen::Matrix<double, N, 1>& error, const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::LLT<Eigen::Matrix<double, N, N>> factor(covariance);
  return factor.info() == Eigen::Success ? error.dot(factor.solve(error)) : kUnknown;
}

}  // namespace

void Accuracy::add(const TruthState& truth, const TrackState& track) {
  const PlanarState& real = comparable(truth, track);
  Eigen::Vector4d error;
  error << track.state.position - real.position, track.state.velocity - real.velocity;
  position_.add(error.head<2>().norm());
  velocity_.add(error.tail<2>().norm());
  const double speed = real.velocity.norm();
  if (speed > 0.0) {
    const Eigen::Vector2d course = real.velocity / speed;
    along_.add(course.dot(error.head<2>()));
    across_.add(course.x() * error.y() - course.y() * error.x());
  }
  if (!track.covariance || track.age > nees_age_) return;
  const double of_position =
      normalisedSquare<2>(Eigen::Vector2d(error.head<2>()), Eigen::Matrix2d(track.covariance->topLeftCorner<2, 2>()));
  const double of_state = normalisedSquare<4>(error, *track.covariance);
  if (of_position >= 0.0) nees_position_.add(of_position);
  if (of_state >= 0.0) nees_state_.add(of_state);
}

void Accuracy::report(MetricList& metrics) const {
  metrics.insert(metrics.end(), {{"rms_pos_m", position_.rootMeanSquare()},
                                 {"p95_pos_m", position_.percentile(95.0)},
                                 {"rms_vel_mps", velocity_.rootMeanSquare()},
                                 {"rms_along_m", along_.rootMeanSquare()},
                                 {"rms_across_m", across_.rootMeanSquare()},
                                 {"nees_position", nees_position_.mean()},
                                 {"nees_state", nees_state_.mean()}});
}

}  // namespace track_evaluation
