#include "beam.h"

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace range_gate_tracker {

void Beam::hear(const tws::RadarSector& sector) {
  turn_.push_back({sector.running, sector.enter_time});
  leave_time_ = sector.leave_time;
  while (turn_.back().running - turn_.front().running > tws::kSectors) turn_.pop_front();
  const auto sectors = static_cast<double>(turn_.back().running - turn_.front().running);
  // Less than half a turn says little, and a radar that stood still says nothing.
  if (2.0 * sectors < tws::kSectors || turn_.back().time <= turn_.front().time) return;
  period_ = (turn_.back().time - turn_.front().time) * tws::kSectors / sectors;
}

double Beam::azimuthAt(double time) const {
  const Crossing& last = turn_.back();
  const double turns = (time - last.time) / period_;
  return tws::wrapTwoPi(static_cast<double>(last.running % tws::kSectors) * tws::kSectorWidth + turns * tws::kTwoPi);
}

std::int64_t Beam::runningAt(double time) const {
  const Crossing& last = turn_.back();
  return last.running + static_cast<std::int64_t>(std::floor((time - last.time) / period_ * tws::kSectors));
}

}  // namespace range_gate_tracker
