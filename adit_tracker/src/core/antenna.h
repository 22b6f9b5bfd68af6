#pragma once

#include <cstdint>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {

/// How one radar's beam turns, learned from its sector marks. Angles are unwrapped: turn n of the antenna is
/// [64 n, 64 (n + 1)) sectors, and an unwrapped azimuth is counted from there [rad].
class Antenna {
 public:
  /// `period`: duration of a turn until marks tell [s], > 0.
  explicit Antenna(double period);

  /// The beam enters the sector of that running number (MRK). Numbers and times grow; a gap in them is allowed.
  void mark(std::int64_t running, double time);

  bool known() const { return newest_ >= 0; }
  /// Duration of the latest turn, from marks one turn apart (T12 or T39 in the report) [s].
  double period() const { return period_; }
  double sectorDuration() const { return period_ / tws::kSectors; }
  /// Rotational velocity (V12, V39) [rad/s].
  double rate() const { return tws::kTwoPi / period_; }

  static int sectorNumber(std::int64_t running) { return tws::wrapSector(static_cast<int>(running % tws::kSectors)); }
  /// The unwrapped azimuth of a direction, next to the beginning of a running sector.
  static double near(double azimuth, std::int64_t running) {
    return startOf(running) + tws::angularDifference(azimuth, tws::sectorStart(sectorNumber(running)));
  }
  /// The unwrapped azimuth at which the running sector begins.
  static double startOf(std::int64_t running) { return static_cast<double>(running) * tws::kSectorWidth; }
  /// When the beam is at an unwrapped azimuth: between marks by interpolation, beyond the newest by the period. Needs
  /// known().
  double timeAt(double unwrapped_azimuth) const;

 private:
  static constexpr std::int64_t kMask = 127;
  struct Mark {
    std::int64_t running = -kMask;  // none; never a turn before a real one
    double time = 0.0;
  };
  const Mark& at(std::int64_t running) const { return marks_[static_cast<std::size_t>(running & kMask)]; }

  std::vector<Mark> marks_;  // the latest two turns
  std::int64_t newest_ = -1;
  double period_;
};

}  // namespace adit_tracker
