#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <tws_core/antenna.h>

namespace radar_sim {

/// An antenna that turns clockwise at a constant rate: what makes the marks from which a tws::Antenna learns. Sectors
/// are counted on from the start: the running number modulo 64 is the sector, and the first one may be cut short by the
/// start azimuth.
class Antenna {
 public:
  /// `period` > 0 [s]; `start_azimuth` in [0, 2π) is where the beam points at `start_time` [s of data time].
  Antenna(double period, double start_azimuth, double start_time);

  /// Unwrapped: grows from start_azimuth by 2π a revolution [rad].
  double angleAt(double time) const { return beam_.azimuthAt(time); }
  /// In [0, 2π).
  double azimuthAt(double time) const;
  double timeAt(double unwrapped) const { return beam_.timeAt(unwrapped); }
  double rate() const { return beam_.rate; }  ///< [rad/s]

  std::int64_t firstSector() const { return first_sector_; }
  /// When the beam enters the sector of that running number; the start for the first one.
  double entryTime(std::int64_t running_sector) const;

  /// The first time after `after` at which the beam points at a target that moves: the root of beam(t) = azimuth(t), to
  /// 1 ns. Asked for azimuths near `after` and up to about a revolution later only. Nothing when the target keeps pace
  /// with the beam (it flies overhead), so that the search does not settle.
  std::optional<double> crossing(double after, const std::function<double(double)>& azimuth) const;

 private:
  tws::SteadyBeam beam_;  // points at the start azimuth at the start
  std::int64_t first_sector_;
};

}  // namespace radar_sim
