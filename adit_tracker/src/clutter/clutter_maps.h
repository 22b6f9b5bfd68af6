#pragma once

#include <vector>

#include "clutter/clutter_map.h"
#include "core/adit_counts.h"
#include "core/radars.h"

namespace adit_tracker {

/// The tracker's clutter maps: one for all radars, or one for each.
class ClutterMaps {
 public:
  /// `radars` and `counts` are to outlive it.
  ClutterMaps(const AditParams& params, Radars& radars, AditCounts& counts);

  /// A sector against the map (figure 4 of the report). The points that were found to move, which are no clutter.
  std::vector<ClutterPoint> process(const tws::SectorRef& sector);
  /// A detection that neither clutter nor tracks have used may be clutter.
  void initiate(const tws::Plot& plot, std::size_t radar);
  /// A track has become slow. False: there is no number for the point, which is counted.
  bool adopt(double range, double azimuth, double time, std::size_t radar);
  /// A track that surely moves has used the detection that this point of the radar's map was after.
  void disclaim(std::uint32_t number, std::size_t radar) { mapOf(radar).disclaim(number); }

  /// The origin of ranges and azimuths moves [m], the clutter does not. Needs a map for each radar.
  void moveOrigin(double dx, double dy);

  /// Clutter is known to stand there, as of `time` [s] (see ClutterMap::load). The map of a radar without a sector yet
  /// gets its points with the radar's first one. Places of all radars go into every map, and a common map takes those
  /// of each radar; what two radars say of one point there is one point. Returns for how many points there was no
  /// number, which is counted. Throws std::invalid_argument when ClutterLimits refuses a place.
  std::size_t load(const std::vector<ClutterPlace>& places, double time);
  /// A radar's first sector is at hand: loads what waited for it. False: nothing did.
  bool loadAwaited(std::size_t radar, double time);

  const std::vector<ClutterMap>& maps() const { return maps_; }
  /// Detections that points of any map have taken out of the file.
  std::uint64_t absorbed() const;
  /// The points that are surely clutter (ClutterMap::known), by radar and azimuth: what load() takes.
  std::vector<ClutterPlace> places() const;

 private:
  std::size_t indexOf(std::size_t radar) const { return maps_.size() == 1 ? 0 : radar; }
  ClutterMap& mapOf(std::size_t radar) { return maps_[indexOf(radar)]; }
  std::size_t loadInto(std::size_t map, double time);

  AditParams params_;
  Radars& radars_;
  AditCounts& counts_;
  std::vector<ClutterMap> maps_;
  std::vector<std::vector<ClutterPlace>> awaited_;  // of each map: loaded with the first sector
};

}  // namespace adit_tracker
