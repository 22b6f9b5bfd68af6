#pragma once

#include <tws_core/planar_gaussian.h>
#include <tws_core/plot.h>
#include <tws_core/site_frame.h>

namespace adit_tracker {

/// A plot's place where all radars stand together, with these errors [m, rad]: of one site heights are alike, and slant
/// range lies on the plane.
inline tws::PlanarPosition flatPlace(const tws::SiteFrame& site, const tws::Plot& plot, double range_sigma,
                                     double azimuth_sigma) {
  tws::PlanarPosition place =
      tws::planarMeasurement(plot.range, site.onPlane(plot.azimuth), range_sigma, azimuth_sigma);
  place.x += site.x;
  place.y += site.y;
  return place;
}

}  // namespace adit_tracker
