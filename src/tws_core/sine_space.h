#pragma once

#include <Eigen/Core>

namespace tws {

/// A place as an electronically scanned array sees it: slant range and sine-space direction. In the array's frame (x
/// along boresight, y left, z up) u = -y/range counts to the right of boresight, v = z/range above it. A beam keeps its
/// shape in sine space wherever it points.
struct Ruv {
  double range = 0.0;  // slant range [m], not negative
  double u = 0.0;      // [-1, 1]
  double v = 0.0;      // [-1, 1]
};

/// Whether (u, v) is a direction in front of the array: u² + v² <= 1. False for NaN.
bool isVisible(double u, double v);

/// Place in the array's frame [m]. Outside the visible region x is NaN.
Eigen::Vector3d arrayFromRuv(const Ruv& ruv);
/// A place behind the array has the same u and v as its mirror image before it; at the array itself all three are 0.
Ruv ruvFromArray(const Eigen::Vector3d& place);

/// Derivatives of arrayFromRuv() by (range, u, v), row by row x, y, z; infinite or NaN at the edge of the visible
/// region.
Eigen::Matrix3d arrayFromRuvJacobian(const Ruv& ruv);
/// Derivatives of ruvFromArray() by (x, y, z), row by row range, u, v; NaN at the array itself.
Eigen::Matrix3d ruvFromArrayJacobian(const Eigen::Vector3d& place);

/// Rotation from the frame of an array to the east, north, up at its centre. Boresight points at `azimuth` (clockwise
/// from true north [rad]), `tilt` above the horizontal [rad]; the array's y axis stays horizontal.
Eigen::Matrix3d enuFromArrayRotation(double azimuth, double tilt);

}  // namespace tws
