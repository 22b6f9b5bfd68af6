#pragma once

#include <Eigen/Core>

#include <tws_core/axis_filter.h>
#include <tws_core/plot.h>

#include "window_params.h"

namespace range_gate_tracker {

/// Where a track is and how it moves, as the radar sees it and on the plane of slant range.
struct WindowKinematics {
  double time = 0.0;                                   // [s]
  double range = 0.0, azimuth = 0.0;                   // [m], [rad] in [0, 2π)
  double range_rate = 0.0, azimuth_rate = 0.0;         // [m/s], [rad/s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // x east, y north [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
};

/// A detection's standard deviations along and across the line of sight, with the parameters in place of unknown ones.
struct PlotSigmas {
  double range;    // [m]
  double azimuth;  // [rad]
};
PlotSigmas sigmasOf(const tws::Plot& plot, const WindowParams& params);

/// The chosen filter on two coordinates: x and y, or range and azimuth. It holds constants only; one serves all tracks.
class WindowMotion {
 public:
  struct State {
    double time = 0.0;              // of the latest measurement [s]
    tws::AxisFilter::State first;   // x [m], or range [m]
    tws::AxisFilter::State second;  // y [m], or azimuth [rad], not wrapped
  };

  /// Throws as tws::AxisFilter. The parameters must outlive it.
  explicit WindowMotion(const WindowParams& params) : params_(params), filter_(params.filter) {}

  State start(const tws::Plot& plot) const;
  /// plot.time must not lie before the state's.
  void update(State& state, const tws::Plot& plot) const;
  WindowKinematics at(const State& state, double time) const;

 private:
  struct Axes {
    double first, second;  // measured
    tws::AxisNoise first_noise, second_noise;
  };
  Axes axesOf(const tws::Plot& plot) const;

  const WindowParams& params_;
  tws::AxisFilter filter_;
};

}  // namespace range_gate_tracker
