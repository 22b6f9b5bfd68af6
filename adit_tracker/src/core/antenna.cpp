#include "core/antenna.h"

#include <cmath>

namespace adit_tracker {

Antenna::Antenna(double period) : marks_(kMask + 1), period_(period) {}

void Antenna::mark(std::int64_t running, double time) {
  marks_[static_cast<std::size_t>(running & kMask)] = {running, time};
  newest_ = running;
  // A whole turn is the best measure; before there is one, the given period stands.
  const Mark& turn_ago = at(running - tws::kSectors);
  if (turn_ago.running == running - tws::kSectors && time > turn_ago.time) period_ = time - turn_ago.time;
}

double Antenna::timeAt(double unwrapped_azimuth) const {
  const double place = unwrapped_azimuth / tws::kSectorWidth;
  const std::int64_t running = static_cast<std::int64_t>(std::floor(place));
  const double fraction = place - static_cast<double>(running);
  if (running >= 0 && running < newest_) {
    const Mark &from = at(running), &to = at(running + 1);
    if (from.running == running && to.running == running + 1) return from.time + fraction * (to.time - from.time);
  }
  return at(newest_).time + (place - static_cast<double>(newest_)) * sectorDuration();
}

}  // namespace adit_tracker
