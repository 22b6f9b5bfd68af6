#pragma once

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/plot.h>

namespace adit_tracker {

/// Where a radar on own ship is in the fixed frame (x east, y north [m]), and whither its azimuth 0 points: clockwise
/// from the frame's y axis [rad], 0 when its azimuths are told against north.
struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

/// The pose between two poses, `fraction` of the way, which may lie beyond them. Headings turn the shorter way.
inline Pose between(const Pose& a, const Pose& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y),
          a.heading + fraction * tws::angularDifference(b.heading, a.heading)};
}

/// A place and direction told against `parent`, in the frame of that.
inline Pose compose(const Pose& parent, const Pose& own) {
  const double s = std::sin(parent.heading), c = std::cos(parent.heading);
  return {parent.x + c * own.x + s * own.y, parent.y - s * own.x + c * own.y, parent.heading + own.heading};
}

/// Where the radar was while its beam crossed a sector.
struct Passage {
  double begin = 0.0, end = 0.0;  // [s], end >= begin
  Pose from, to;                  // then

  Pose at(double time) const {
    if (end <= begin) return from;
    return between(from, to, std::clamp((time - begin) / (end - begin), -1.0, 2.0));
  }
};

/// What the tracker's polar coordinates are counted from, in the fixed frame [m]: radars that stand are there already.
struct PlaneOrigin {
  double x = 0.0, y = 0.0;
};

/// Range and azimuth of a place that stands still while their origin moves by (dx, dy) [m].
inline void moveOrigin(double& range, double& azimuth, double dx, double dy) {
  const double x = range * std::sin(azimuth) - dx, y = range * std::cos(azimuth) - dy;
  range = std::max(std::hypot(x, y), 1.0);  // at the origin itself there is no direction
  azimuth = tws::wrapTwoPi(std::atan2(x, y));
}

/// A plot that a radar on own ship has measured, against north and as seen from `origin`; its range rate as if the ship
/// stood.
inline tws::Plot seenFrom(const PlaneOrigin& origin, const Passage& ship, tws::Plot plot) {
  const Pose pose = ship.at(plot.time);
  plot.azimuth += pose.heading;
  const double ahead =
      (ship.to.x - ship.from.x) * std::sin(plot.azimuth) + (ship.to.y - ship.from.y) * std::cos(plot.azimuth);
  plot.range_rate += ship.end > ship.begin ? ahead / (ship.end - ship.begin) : tws::Plot::kUnknown;
  moveOrigin(plot.range, plot.azimuth, origin.x - pose.x, origin.y - pose.y);
  return plot;
}

/// The way back: sets range and azimuth, as seen from `origin`, to what the radar has measured at `time`.
inline void asMeasured(const PlaneOrigin& origin, const Passage& ship, double time, double& range, double& azimuth) {
  const Pose pose = ship.at(time);
  moveOrigin(range, azimuth, pose.x - origin.x, pose.y - origin.y);
  azimuth = tws::wrapTwoPi(azimuth - pose.heading);
}

}  // namespace adit_tracker
