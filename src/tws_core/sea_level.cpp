#include <tws_core/sea_level.h>

#include <cmath>

namespace tws {

double SeaLevel::heightOf(const Eigen::Vector3d& point) const {
  return frame_ ? frame_->toGeodetic(point).altitude : altitudeOverSphere(point);
}

/// z and height differ by what the plane sinks away, which hardly changes with z: each round leaves about z/R of the
/// error, and four are enough for micrometres.
std::optional<double> SeaLevel::upAtRange(const Eigen::Vector3d& from, const Eigen::Vector2d& direction, double range,
                                          double height) const {
  constexpr int kRounds = 5;
  double up = height - heightOf(from);  // relative to `from`
  for (int round = 0; round < kRounds; ++round) {
    if (!(std::abs(up) < range)) return std::nullopt;
    const double ground = std::sqrt(range * range - up * up);
    up += height - heightOf(from + Eigen::Vector3d(ground * direction.x(), ground * direction.y(), up));
  }
  if (!(std::abs(up) < range)) return std::nullopt;
  return from.z() + up;
}

}  // namespace tws
