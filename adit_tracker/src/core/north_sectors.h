#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/plot.h>

#include "core/passage.h"

namespace adit_tracker {

/// The sectors of a radar that tells azimuths from own ship's bow, cut anew against north: a ship that turns brings
/// other sectors before the beam. Plots stay as they were measured; they go with the sector that the beam was in at
/// their time.
class NorthSectors {
 public:
  /// The next sector of the radar, and own ship meanwhile. Returns those against north that the beam has left by its
  /// end: mostly one, none or two while the ship turns. After a gap in the radar's sectors, the sector that was open
  /// comes as far as it is known.
  std::vector<tws::RadarSector> add(const tws::RadarSector& sector, const Passage& ship);
  /// No more will come: the sector that is open, if one is.
  std::optional<tws::RadarSector> finish();

 private:
  double unwrap(double heading);
  void open(std::int64_t running, double time);
  tws::RadarSector close(double time);

  std::optional<tws::RadarSector> open_;
  std::int64_t next_ = 0;     // the least running number that is free
  std::int64_t before_ = -1;  // running number of the radar's latest sector
  double heading_ = 0.0, end_ = 0.0;
  bool has_heading_ = false;
};

}  // namespace adit_tracker
