#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <tws_core/antenna.h>

#include "registration_errors.h"

namespace radar_sim {

/// An antenna that turns clockwise at a constant rate: what makes the marks from which a tws::Antenna learns. Sectors
/// are counted on from the start: the running number modulo 64 is the sector, and the first one may be cut short by the
/// start azimuth. They are those of the azimuth that the turning gear measures, errors and all.
class Antenna {
 public:
  /// `period` > 0 [s]; `start_azimuth` in [0, 2π) is where the beam points at `start_time` [s of data time].
  Antenna(double period, double start_azimuth, double start_time, const AzimuthErrors& errors = {});

  /// Unwrapped: grows from start_azimuth by 2π a revolution [rad].
  double angleAt(double time) const { return beam_.azimuthAt(time); }
  /// In [0, 2π).
  double azimuthAt(double time) const;
  double timeAt(double unwrapped) const { return beam_.timeAt(unwrapped); }
  double rate() const { return beam_.rate; }  ///< [rad/s]

  /// What the turning gear measures for a true azimuth, wrapped or not, at a time [rad].
  double measured(double azimuth, double time) const { return azimuth + errors_.at(azimuth, time - beam_.time); }
  /// Where it measures the beam to be: unwrapped, so that running sectors are multiples of the sectors' width [rad].
  double measuredAngleAt(double time) const { return measured(angleAt(time), time) + before_start_; }

  std::int64_t firstSector() const { return first_sector_; }
  /// When the beam, as measured, enters the sector of that running number; the start for the first one.
  double entryTime(std::int64_t running_sector) const;

  /// The first time after `after` at which the beam points at a target that moves: the root of beam(t) = azimuth(t), to
  /// 1 ns. Asked for azimuths near `after` and up to about a revolution later only. Nothing when the target keeps pace
  /// with the beam (it flies overhead), so that the search does not settle.
  std::optional<double> crossing(double after, const std::function<double(double)>& azimuth) const;

 private:
  tws::SteadyBeam beam_;  // points at the start azimuth at the start
  AzimuthErrors errors_;
  double before_start_;  // whole revolutions, so that the first sector is none below 0
  std::int64_t first_sector_;
};

}  // namespace radar_sim
