#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include <tws_core/plot.h>

#include "elevation/elevation_params.h"

namespace adit_tracker {

/// Height of one track at one instant, from elevations.
struct Height {
  double height = 0.0, height_sigma = 0.0;  // above the antenna [m], over the curved earth
  double climb = 0.0, climb_sigma = 0.0;    // [m/s]
};

/// The heights of the tracks whose elevation has been measured (ES): a filter of height and climb rate for each. Few
/// tracks have one, so they stand beside the track file. Tracks are known by their uid.
class HeightFile {
 public:
  explicit HeightFile(const ElevationParams& params) : params_(params) {}

  /// A plot updates a track. Without an elevation nothing happens. An elevation that is far off begins the height anew:
  /// the track has changed its target, or the target does what no filter follows.
  void update(std::uint32_t track, const tws::Plot& plot) {
    if (!std::isnan(plot.elevation)) measure(track, plot);
  }
  void remove(std::uint32_t track) { filters_.erase(track); }

  /// Uncertainty grows from search to search. Nothing: never measured, or too uncertain by then.
  std::optional<Height> at(std::uint32_t track, double time) const;

 private:
  struct Filter {
    double time = 0.0;
    double height = 0.0, climb = 0.0;
    double hh = 0.0, hc = 0.0, cc = 0.0;  // covariance [m², m²/s, m²/s²]
  };
  void measure(std::uint32_t track, const tws::Plot& plot);
  Filter movedTo(const Filter& filter, double time) const;

  ElevationParams params_;
  std::unordered_map<std::uint32_t, Filter> filters_;
};

/// Where a height puts a target that is seen at a slant range: over the true earth, in the radar's own coordinates.
struct HeightGeometry {
  double elevation = 0.0;  // as the radar sees it, refraction included [rad]
  double ground = 0.0;     // distance on the radar's horizontal plane [m]
  double z = 0.0;          // above that plane [m]
};

/// Nothing: no target at that slant range [m] has that height above the antenna [m].
std::optional<HeightGeometry> placeAt(double slant_range, double height);

}  // namespace adit_tracker
