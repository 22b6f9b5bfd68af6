#pragma once

#include <deque>
#include <optional>
#include <string>

#include <tws_core/antenna.h>
#include <tws_core/rotation.h>

#include "beam_break.h"

namespace asterix_bridge {

/// Follows the beam of one radar while its data come: where it points at any time, from north and sector marks, plots,
/// or both. Its unwrapped azimuth grows by 2π each turn, is in [2π, 4π) at the start, and never goes back: what new
/// data say otherwise is made up for within one turn, or a second.
class Beam {
 public:
  /// The beam pointed there at this time [s, rad]. Times may come a little out of order.
  void add(double time, double azimuth);
  /// The same for a mark as the beam enters a sector; several in a row show the period.
  void addMark(double time, double azimuth);
  /// The same for a north mark.
  void addNorth(double time);
  /// As the radar says it [s].
  void setNominalPeriod(double period);

  /// Learns from what was added, once a turn or a second; until the beam is known, more and more seldom. The line stays
  /// as it is up to `fixed` [s], the time up to which it was used. True: the beam is known.
  bool learn(double now, double fixed);
  /// The same at once: there will be no more.
  bool learnNow(double now, double fixed);
  bool isKnown() const { return line_.has_value(); }

  /// Sectors are used up to this time [s]: from there on the beam is drawn to what was learned last.
  void followFrom(double time);
  /// None is used yet: the beam is where what was learned last has it at this time [s].
  void startAt(double time);

  /// [rad], unwrapped, and its inverse [s]. The beam must be known.
  double azimuthAt(double time) const { return line_->azimuthAt(time); }
  double timeAt(double azimuth) const { return line_->timeAt(azimuth); }
  /// Of a turn [s]; NaN: not known.
  double period() const;

  /// The time [s] from which on the radar's reports contradict the beam; nothing: all is well.
  std::optional<double> doubtfulSince() const { return break_.since(); }
  /// How it turns instead, from its time on; nothing: it is not known yet.
  std::optional<tws::SteadyBeam> findBreak();
  /// It turns so from that time on.
  void turnAlong(const tws::SteadyBeam& line);
  /// Adds whole turns to the unwrapped azimuth, the fewest with which it is at least this one at a time [rad, s].
  void raise(double time, double least);
  /// Reports have contradicted for so long that the beam is not known any more.
  bool isLost() const;
  /// What came last shows an antenna that scans to and fro: no beam is learned from it.
  bool scansToAndFro() const;
  /// Why the beam is not known, for a person.
  std::string whyUnknown() const;

  /// After a silence: forgets where the beam was, but neither its period nor how many turns it has made.
  void interrupt();

 private:
  std::optional<tws::Rotation> fit() const;
  void begin();
  bool isAboutToBeTold() const;
  bool isBelievable(double period) const;
  void forgetBefore(double time);
  void watch();
  bool isDue(double now) const;

  std::deque<tws::TimedAzimuth> points_;
  std::deque<tws::TimedAzimuth> latest_points_;  // whatever was learned meanwhile
  std::deque<double> norths_;
  std::optional<tws::TimedAzimuth> mark_;  // the latest
  std::deque<double> periods_;             // as pairs of marks show them
  std::optional<double> period_;
  double nominal_ = 0.0;                   // as the radar says it
  std::optional<tws::Rotation> rotation_;  // as learned last
  std::optional<tws::SteadyBeam> line_;
  std::optional<tws::SteadyBeam> before_interruption_;
  std::optional<tws::SteadyBeam> latest_;  // as it turns where the data are by now; `line_` is where they are used
  std::optional<double> learned_;          // when
  BeamBreak break_;
};

}  // namespace asterix_bridge
