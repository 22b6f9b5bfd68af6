#pragma once

#include <deque>
#include <optional>

#include <tws_core/antenna.h>
#include <tws_core/rotation.h>

namespace asterix_bridge {

/// Watches whether a beam still turns as it did, and finds how it turns instead: another speed, another phase (the
/// radar was restarted, or its clock was set). Single false plots are no matter: most of what came last must
/// contradict.
class BeamBreak {
 public:
  /// The radar reported this azimuth [rad] at a time [s], while the beam was thought to turn along `line`.
  void add(const tws::TimedAzimuth& point, const tws::SteadyBeam& line);
  /// The time [s] from which on most reports contradict; nothing: all is well.
  std::optional<double> since() const;
  /// Those reports.
  const std::deque<tws::TimedAzimuth>& reports() const { return suspects_; }
  /// The beam along which they lie, in place of `line`: its time is that of the first of them. Nothing: they show none
  /// yet; it takes six of them over a revolution, twelve when it turns at another speed. `nominal`: the period that the
  /// radar itself says [s], or 0.
  std::optional<tws::SteadyBeam> find(const tws::SteadyBeam& line, double nominal);
  void clear();
  /// The median of how far off its beam the radar's reports are [rad]: the coarser they are, the more is no
  /// contradiction.
  void setScatter(double median) { scatter_ = median; }

 private:
  double tolerance(double rate) const;
  std::deque<tws::TimedAzimuth> suspects_;  // in the order in which they came; the first one contradicted
  std::size_t contradicting_ = 0;
  double scatter_ = 0.0;
  std::size_t tried_ = 0;  // how many there were at the last attempt
};

}  // namespace asterix_bridge
