#pragma once

#include <cstdint>
#include <deque>

#include <tws_core/plot.h>

namespace range_gate_tracker {

/// Where a radar's beam is and will be, from its latest turn. (ADIT's antenna, for one radar without faults.)
class Beam {
 public:
  /// `period` of a turn [s], until a whole one was heard.
  explicit Beam(double period) : period_(period) {}

  /// The radar's sectors in order.
  void hear(const tws::RadarSector& sector);
  bool heard() const { return !turn_.empty(); }

  double period() const { return period_; }
  /// The beam left the latest sector [s].
  double now() const { return leave_time_; }
  /// Where the beam points at a time [rad], [0, 2π).
  double azimuthAt(double time) const;
  /// Running number of the sector in which the beam is at a time.
  std::int64_t runningAt(double time) const;

 private:
  struct Crossing {
    std::int64_t running;
    double time;  // the beam entered the sector [s]
  };
  std::deque<Crossing> turn_;
  double leave_time_ = 0.0;
  double period_;
};

}  // namespace range_gate_tracker
