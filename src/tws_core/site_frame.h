#pragma once

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace tws {

/// A direction and distance on the plane, as seen from a site.
struct PlanarView {
  double east, north;  // of the plane, from the site [m]
  double distance;     // [m], at least 1: at the site itself rates have no meaning
  double azimuth;      // from the site's own north [rad], [0, 2π)
};

/// Where a radar stands on the plane that a tracker of several sites works on; the plane's origin is the first site.
struct SiteFrame {
  double x = 0.0, y = 0.0;  // x along the first site's east, y along its north [m]
  double turn = 0.0;        // of the site's own axes against these, anticlockwise [rad]: meridians converge
  double z = 0.0;           // above the plane [m]

  PlanarView view(double plane_x, double plane_y) const {
    const double east = plane_x - x, north = plane_y - y;
    return {east, north, std::max(std::sqrt(east * east + north * north), 1.0),
            wrapTwoPi(std::atan2(east, north) + turn)};
  }
  /// An azimuth measured at the site, against the plane's y axis [rad].
  double onPlane(double azimuth) const { return azimuth - turn; }
};

/// Radars no further apart see a target in the same polar coordinates.
inline bool sameSite(const SiteFrame& a, const SiteFrame& b) {
  constexpr double kSameSite = 100.0;  // [m]
  return std::hypot(a.x - b.x, a.y - b.y) <= kSameSite;
}

}  // namespace tws
