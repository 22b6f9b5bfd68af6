#pragma once

#include <cstdint>

#include "antenna.h"

namespace radar_sim {

/// A sector that the beam has left, in times of the radar's clock.
struct SectorSpan {
  std::int64_t running;  ///< Sectors since the start; modulo 64 it is the sector.
  double enter_time;     ///< [s of data time]
  double leave_time;     ///< Time of the mark that closes it [s of data time].
};

/// A turning antenna, the clock beside it, and its sectors in their order. Radars on one mast have equal ones.
class Mast {
 public:
  /// As Antenna; `time_lsb` >= 0 is the clock's tick [s], 0: it does not tick.
  Mast(double period, double start_azimuth, double time_lsb, double start_time, const RegistrationErrors& errors = {});

  const Antenna& antenna() const { return antenna_; }
  /// Of the sector that closeSector() returns next.
  std::int64_t nextSector() const { return next_sector_; }
  /// When that one's mark comes, to the tick [s of data time].
  double nextMark() const { return ticked(antenna_.entryTime(next_sector_ + 1)); }
  /// The same as the clock tells it.
  double nextStamp() const { return markTime(next_sector_ + 1); }
  SectorSpan closeSector();

  /// What the clock tells at `time`, kept within the sector and before its mark.
  double stampWithin(const SectorSpan& sector, double time) const;
  /// Duration of the revolution that ended with the mark of that running sector; NaN before the first full one [s].
  double rotationPeriod(std::int64_t running_sector) const;

 private:
  double ticked(double time) const;
  double clockTime(double time) const { return ticked(time + clock_.at(time - start_time_)); }
  double markTime(std::int64_t running_sector) const { return clockTime(antenna_.entryTime(running_sector)); }

  Antenna antenna_;
  double time_lsb_, start_time_;
  ClockErrors clock_;
  std::int64_t next_sector_;
};

}  // namespace radar_sim
