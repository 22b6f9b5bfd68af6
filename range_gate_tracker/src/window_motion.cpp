#include "window_motion.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

namespace range_gate_tracker {
namespace {

// A target is taken to be no nearer than this where its speed is turned into an angular rate [m].
constexpr double kNearest = 1000.0;

WindowKinematics fromPolar(double time, const tws::AxisMotion& range, const tws::AxisMotion& azimuth) {
  WindowKinematics k;
  k.time = time;
  k.range = std::max(range.position, 0.0);
  k.azimuth = tws::wrapTwoPi(azimuth.position);
  k.range_rate = range.velocity;
  k.azimuth_rate = azimuth.velocity;
  k.position = tws::planarFromPolar(k.range, k.azimuth);
  k.velocity = tws::planarVelocity(k.range, k.azimuth, k.range_rate, k.azimuth_rate);
  return k;
}

WindowKinematics fromPlane(double time, const tws::AxisMotion& x, const tws::AxisMotion& y) {
  WindowKinematics k;
  k.time = time;
  k.position = {x.position, y.position};
  k.velocity = {x.velocity, y.velocity};
  k.range = k.position.norm();
  k.azimuth = tws::azimuthOf(k.position);
  if (k.range == 0.0) return k;
  k.range_rate = k.position.dot(k.velocity) / k.range;
  k.azimuth_rate = (k.velocity.x() * k.position.y() - k.velocity.y() * k.position.x()) / (k.range * k.range);
  return k;
}

}  // namespace

PlotSigmas sigmasOf(const tws::Plot& plot, const WindowParams& params) {
  const auto known = [](double sigma, double otherwise) { return sigma > 0.0 ? sigma : otherwise; };
  return {known(plot.range_sigma, params.range_sigma), known(plot.azimuth_sigma, params.azimuth_sigma)};
}

WindowMotion::Axes WindowMotion::axesOf(const tws::Plot& plot) const {
  const auto [along, angle] = sigmasOf(plot, params_);
  const double speed = 0.5 * params_.greatest_speed;
  if (!params_.cartesian) {
    const double range = std::max(plot.range, kNearest);
    return {
        plot.range, plot.azimuth, {along, params_.manoeuvre, speed}, {angle, params_.manoeuvre / range, speed / range}};
  }
  const Eigen::Vector2d place = tws::planarFromPolar(plot.range, plot.azimuth);
  const double across = plot.range * angle, s = std::sin(plot.azimuth), c = std::cos(plot.azimuth);
  return {place.x(),
          place.y(),
          {std::hypot(along * s, across * c), params_.manoeuvre, speed},
          {std::hypot(along * c, across * s), params_.manoeuvre, speed}};
}

WindowMotion::State WindowMotion::start(const tws::Plot& plot) const {
  const Axes axes = axesOf(plot);
  return {plot.time, filter_.start(axes.first, axes.first_noise), filter_.start(axes.second, axes.second_noise)};
}

void WindowMotion::update(State& state, const tws::Plot& plot) const {
  const Axes axes = axesOf(plot);
  const double dt = plot.time - state.time;
  const double first = axes.first - tws::moved(tws::AxisFilter::motion(state.first), dt).position;
  double second = axes.second - tws::moved(tws::AxisFilter::motion(state.second), dt).position;
  if (!params_.cartesian) second = tws::wrapPi(second);
  filter_.update(state.first, first, dt, axes.first_noise);
  filter_.update(state.second, second, dt, axes.second_noise);
  state.time = plot.time;
}

WindowKinematics WindowMotion::at(const State& state, double time) const {
  const double dt = time - state.time;
  const tws::AxisMotion first = tws::moved(tws::AxisFilter::motion(state.first), dt);
  const tws::AxisMotion second = tws::moved(tws::AxisFilter::motion(state.second), dt);
  return params_.cartesian ? fromPlane(time, first, second) : fromPolar(time, first, second);
}

}  // namespace range_gate_tracker
