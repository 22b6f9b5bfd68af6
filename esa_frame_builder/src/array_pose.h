#pragma once

#include <tws_core/kalman.h>

#include <Eigen/Geometry>

#include "frame.h"

namespace esa_frame_builder {

/// Where an array stands in the frame of positions and how it looks: x along boresight, y left, z up.
struct ArrayPose {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();     // [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // turns the array's frame into the frame of positions
};

/// A measurement as a place in the frame of positions, with the covariance of the linearised conversion.
tws::SpatialMeasurement spatialMeasurement(const Measurement& measurement, const ArrayPose& pose);

/// A predicted track as the array sees it.
struct ArrayView {
  bool is_ahead = false;  // before the array, not behind it
  double range = 0.0;     // [m]
  double u = 0.0, v = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (u, v)
};
ArrayView arrayView(const tws::SpatialState& state, const ArrayPose& pose);

}  // namespace esa_frame_builder
