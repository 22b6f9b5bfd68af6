#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clutter/clutter_places.h"
#include "core/radar_counts.h"

namespace adit_tracker {

/// What the tracker has learned of the radars' surroundings, as it is kept from run to run.
struct SavedMaps {
  std::vector<ClutterPlace> clutter;
  std::vector<RadarCounts> radars;

  bool empty() const { return clutter.empty() && radars.empty(); }
};

/// "13 points", or "13 points and the maps of 2 radars": what `maps` hold, of which so many points.
inline std::string inWords(const SavedMaps& maps, std::size_t points) {
  const std::string radars = std::to_string(maps.radars.size()) + (maps.radars.size() == 1 ? " radar" : " radars");
  return std::to_string(points) + " points" + (maps.radars.empty() ? "" : " and the maps of " + radars);
}

}  // namespace adit_tracker
