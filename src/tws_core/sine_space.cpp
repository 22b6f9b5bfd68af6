#include <tws_core/sine_space.h>

#include <Eigen/Geometry>
#include <cmath>

namespace tws {
namespace {

/// Direction cosine along boresight.
double boresightCosine(double u, double v) { return std::sqrt(1.0 - u * u - v * v); }

}  // namespace

bool isVisible(double u, double v) { return u * u + v * v <= 1.0; }

Eigen::Vector3d arrayFromRuv(const Ruv& ruv) {
  return ruv.range * Eigen::Vector3d(boresightCosine(ruv.u, ruv.v), -ruv.u, ruv.v);
}

Ruv ruvFromArray(const Eigen::Vector3d& place) {
  const double range = place.norm();
  if (range == 0.0) return {};
  return {range, -place.y() / range, place.z() / range};
}

Eigen::Matrix3d arrayFromRuvJacobian(const Ruv& ruv) {
  const double w = boresightCosine(ruv.u, ruv.v);
  Eigen::Matrix3d jacobian;
  jacobian << w, -ruv.range * ruv.u / w, -ruv.range * ruv.v / w,  //
      -ruv.u, -ruv.range, 0.0,                                    //
      ruv.v, 0.0, ruv.range;
  return jacobian;
}

Eigen::Matrix3d ruvFromArrayJacobian(const Eigen::Vector3d& place) {
  const double range = place.norm();
  const Eigen::RowVector3d outward = place.transpose() / range;
  Eigen::Matrix3d jacobian;
  jacobian.row(0) = outward;
  jacobian.row(1) = (-Eigen::RowVector3d::UnitY() + outward.y() * outward) / range;
  jacobian.row(2) = (Eigen::RowVector3d::UnitZ() - outward.z() * outward) / range;
  return jacobian;
}

Eigen::Matrix3d enuFromArrayRotation(double azimuth, double tilt) {
  const double sin_azimuth = std::sin(azimuth), cos_azimuth = std::cos(azimuth);
  Eigen::Matrix3d rotation;
  rotation.col(0) << sin_azimuth * std::cos(tilt), cos_azimuth * std::cos(tilt), std::sin(tilt);
  rotation.col(1) << -cos_azimuth, sin_azimuth, 0.0;
  rotation.col(2) = rotation.col(0).cross(rotation.col(1));
  return rotation;
}

}  // namespace tws
