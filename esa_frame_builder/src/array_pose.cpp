#include "array_pose.h"

#include <tws_core/sine_space.h>

namespace esa_frame_builder {

tws::SpatialMeasurement spatialMeasurement(const Measurement& measurement, const ArrayPose& pose) {
  const tws::Ruv ruv{measurement.range, measurement.u, measurement.v};
  const Eigen::Matrix3d jacobian = pose.axes * tws::arrayFromRuvJacobian(ruv);
  const Eigen::Matrix3d covariance = jacobian * measurement.covariance * jacobian.transpose();
  return {pose.place + pose.axes * tws::arrayFromRuv(ruv), 0.5 * (covariance + covariance.transpose())};
}

ArrayView arrayView(const tws::SpatialState& state, const ArrayPose& pose) {
  const Eigen::Vector3d place = pose.axes.transpose() * (state.mean.head<3>() - pose.place);
  const tws::Ruv ruv = tws::ruvFromArray(place);
  const Eigen::Matrix<double, 2, 3> jacobian = tws::ruvFromArrayJacobian(place).bottomRows<2>() * pose.axes.transpose();
  return {place.x() > 0.0, ruv.range, ruv.u, ruv.v,
          jacobian * state.covariance.topLeftCorner<3, 3>() * jacobian.transpose()};
}

}  // namespace esa_frame_builder
