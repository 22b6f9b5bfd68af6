#include "mast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tws_core/sectors.h>

namespace radar_sim {

Mast::Mast(double period, double start_azimuth, double time_lsb, double start_time, const RegistrationErrors& errors)
    : antenna_(period, start_azimuth, start_time, errors.azimuth),
      time_lsb_(time_lsb),
      start_time_(start_time),
      clock_(errors.clock),
      next_sector_(antenna_.firstSector()) {}

SectorSpan Mast::closeSector() {
  const std::int64_t running = next_sector_++;
  return {running, markTime(running), markTime(next_sector_)};
}

double Mast::stampWithin(const SectorSpan& sector, double time) const {
  return std::clamp(clockTime(time), sector.enter_time, std::max(sector.enter_time, sector.leave_time - time_lsb_));
}

double Mast::rotationPeriod(std::int64_t running_sector) const {
  const std::int64_t revolution_ago = running_sector - tws::kSectors;
  if (revolution_ago <= antenna_.firstSector()) return std::numeric_limits<double>::quiet_NaN();
  return markTime(running_sector) - markTime(revolution_ago);
}

// The clock is a counter: it tells the last tick gone by. A millionth of a tick keeps ticks themselves from rounding
// down.
double Mast::ticked(double time) const {
  return time_lsb_ > 0.0 ? std::floor(time / time_lsb_ + 1e-6) * time_lsb_ : time;
}

}  // namespace radar_sim
