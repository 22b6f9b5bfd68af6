#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "detection_probability.h"
#include "radar_params.h"

namespace radar_sim {

/// Where a radar is to search in elevation.
struct ElevationOrder {
  double azimuth;  ///< Where the search begins [rad], [0, 2π).
  double range;    ///< Centre of the range interval [m].
};

/// The searches of one radar under way or to come. Angles are those of its antenna, unwrapped [rad].
class ElevationSearches {
 public:
  /// A radar without them searches nowhere.
  explicit ElevationSearches(const RadarParams& radar);

  /// Takes the first ones of these, as many as the radar can make in one scan, for the scan that begins at `north`;
  /// what began before goes on to its end. Returns how many it takes.
  std::size_t set(const std::vector<ElevationOrder>& orders, double north);

  /// Power gain that the scans of a search have together when the beam has passed over a target there, two-way, against
  /// one scan right on it; 0: no search looks there.
  double gainAt(double angle, double range) const;

 private:
  struct Search {
    double begin, range;
  };
  double gainOf(const Search& search, double angle) const;

  std::optional<ElevationSearchParams> params_;
  double azimuth_beamwidth_;
  std::vector<Search> searches_;
};

/// What a search sees of one target.
struct ElevationLook {
  double power;      ///< In units of the mean noise power.
  double elevation;  ///< As measured [rad].
  double sigma;      ///< Of that [rad].
};

/// The radar with the scanned beam at that elevation [rad] in place of those of the search of the scan.
RadarParams scanningBeam(const RadarParams& radar, double elevation);

/// Nothing: the target lies outside of the scan, or it is not detected. `elevation` [rad] is where it appears.
std::optional<ElevationLook> look(const RadarParams& radar, Fluctuation fluctuation, double mean_snr, double elevation,
                                  RandomStream& random);

}  // namespace radar_sim
