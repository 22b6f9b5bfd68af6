#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clutter/area.h"
#include "clutter/clutter.h"
#include "clutter/texture.h"
#include "random_stream.h"
#include "range_rates.h"

namespace radar_sim {

/// The middle of a resolution cell while the beam is on it.
struct Cell {
  double range;           ///< [m]
  double azimuth;         ///< [rad]
  Eigen::Vector2d place;  ///< East, north in the map frame [m].
  double time;            ///< [s of data time]
};

/// Clutter that fills resolution cells. The mean clutter-to-noise ratio of a cell, behind integration and suppression,
/// is profile × factor.
struct CellModel {
  /// Of the range [m]: all that the radar equation says. Asked once for each range cell.
  std::function<double(double range)> profile;
  /// Of place and time.
  std::function<double(const Cell&)> factor;
  /// The factor is almost never greater: cells that could not be seen then are left out at once.
  double greatest_factor = 1.0;
  /// Share of a cell's power that does not fluctuate from scan to scan, 0 .. 1: amplitudes are Rician (0: Rayleigh),
  /// and plots stay at the cell's own place by the same share.
  double steady_share = 0.0;
  /// What range rates show; nothing: it is noise.
  std::optional<Motion> motion = Motion{};
};

/// Cells whose clutter is below this part of the noise have none: what crosses there are the false alarms of noise.
constexpr double kLeastCnr = 0.1;

class CellClutter : public Clutter {
 public:
  /// `stream`: key of the random numbers beside the radar's name.
  CellClutter(const ClutterView& view, const std::string& stream, CellModel model);

  void raise(const Spoke& spoke, std::vector<Echo>& echoes) override;
  /// Number of cells that cross the threshold in that spoke, in the mean.
  double expectedCrossings(const Spoke& spoke) const;

 private:
  Cell cellOf(const Spoke& spoke, std::size_t bin) const;
  double meanCnr(const Cell& cell, std::size_t bin) const;
  Echo echoIn(const Spoke& spoke, std::size_t bin, double power, RandomStream& random) const;

  double rangeRateOf(const Echo& echo, RandomStream& random) const;

  RadarParams radar_;
  std::string stream_;
  std::uint64_t seed_;
  Eigen::Isometry3d map_to_site_, site_to_map_;
  CellModel model_;
  double range_cell_, threshold_;
  std::size_t first_bin_ = 0;
  std::vector<double> profile_;  ///< By range cell, from the first one with clutter on.
};

/// Clutter that fills an area, its level that of a field; its profile is still to be told.
CellModel fieldWithin(const Area& area, const Texture& field, double steady_share);

/// How many range cells a radar has.
double rangeCells(const RadarParams& radar);

/// Area of the surface in one cell, R θ cτ/2 [m²].
double surfaceCell(const RadarParams& radar, double range);
/// Of the grazing angle at which a radar looks at the surface there.
double sineOfGrazing(const RadarParams& radar, double range);
/// The radar without the sea's mirror, which clutter models have in their reflectivities.
RadarParams withoutMirror(RadarParams radar);

}  // namespace radar_sim
