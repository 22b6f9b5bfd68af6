#pragma once

#include <deque>
#include <optional>

#include <tws_core/antenna.h>
#include <tws_core/rotation.h>

namespace asterix_bridge {

/// Follows the beam of one radar while its data come: where it points at any time, from north and sector marks, plots,
/// or both. Its unwrapped azimuth grows by 2π each turn, is in [2π, 4π) at the start, and never goes back: what new
/// data say otherwise is made up for within one turn.
class Beam {
 public:
  /// The beam pointed there at this time [s, rad]. Times may come a little out of order.
  void add(double time, double azimuth);
  /// The same for a north mark.
  void addNorth(double time);
  /// As the radar says it [s].
  void setNominalPeriod(double period);

  /// Learns from what was added, once a turn; until the beam is known, once a second. The line stays as it is up to
  /// `fixed` [s], the time up to which it was used. True: the beam is known.
  bool learn(double now, double fixed);
  bool isKnown() const { return line_.has_value(); }

  /// [rad], unwrapped, and its inverse [s]. The beam must be known.
  double azimuthAt(double time) const { return line_->azimuthAt(time); }
  double timeAt(double azimuth) const { return line_->timeAt(azimuth); }
  /// Of a turn [s]; NaN: not known.
  double period() const;

  /// After a silence: forgets where the beam was, but neither its period nor how many turns it has made.
  void interrupt();

 private:
  std::optional<tws::Rotation> fit() const;
  void steer(const tws::Rotation& rotation, double fixed);
  void forgetBefore(double time);

  std::deque<tws::TimedAzimuth> points_;
  std::deque<double> norths_;
  std::optional<double> period_;
  std::optional<tws::SteadyBeam> line_;
  std::optional<tws::SteadyBeam> before_interruption_;
  std::optional<double> learned_;  // when
};

}  // namespace asterix_bridge
