#pragma once

#include <utility>
#include <vector>

#include <tws_core/antenna.h>

namespace tws {

/// When the beam was where: the time [s] and measured azimuth [rad], clockwise, of one plot.
struct TimedAzimuth {
  double time;
  double azimuth;
};

using TimedAzimuths = std::vector<TimedAzimuth>;

/// How a radar's beam turned: its unwrapped azimuth [rad] (each turn adds 2π) against time [s], piecewise linear and
/// strictly increasing. Beyond the plots it turns on as it did in the last (first) ten turns.
class Rotation {
 public:
  /// A beam that turns evenly. The period is in 0.01..100000 s, the azimuth [rad] is the beam's at t = 0, which is also
  /// its unwrapped azimuth. Throws std::invalid_argument when the period is outside or the azimuth not finite.
  static Rotation uniform(double period, double azimuth_at_zero);

  /// Finds period (0.2..120 s) and phase from the plots of one radar alone, in any order, then follows the slow drift
  /// of the real rotation, and its breaks. At least 20 plots over three turns are needed, and most must lie where the
  /// beam was. The unwrapped azimuth is in [0, 2π) at the first plot. Plots that do not tell a period from its
  /// fractions (all at one azimuth) get the longest. Throws std::invalid_argument that says why when the plots show no
  /// rotation, or one has a time beyond ±1e10 s or an azimuth that is not finite.
  static Rotation fromPlots(TimedAzimuths plots);
  /// The same with a known nominal period in 0.01..100000 s, right to about 2 %: five plots are enough, and less than
  /// three turns of them give the phase alone.
  static Rotation fromPlots(TimedAzimuths plots, double period);

  /// The mean [s] over the time seen.
  double period() const;
  /// The beam did not go on as before: another speed or phase, or the radar's clock was set. There the unwrapped
  /// azimuth leaps within a millisecond.
  struct Break {
    double time;  // [s]
    SteadyBeam before, after;
  };
  /// In order of time.
  const std::vector<Break>& breaks() const { return breaks_; }
  /// The beam's unwrapped azimuth [rad] at a time [s].
  double unwrappedAt(double time) const;
  /// The time [s] at which the beam stood there: the inverse of unwrappedAt.
  double timeAt(double unwrapped) const;

 private:
  struct Knot {
    double time;
    double unwrapped;
  };

  explicit Rotation(std::vector<Knot> knots) : knots_(std::move(knots)) {}
  static Rotation follow(const TimedAzimuths& plots, double frequency, double start);

  std::vector<Break> breaks_;
  std::vector<Knot> knots_;  // two or more, both members strictly increasing
};

}  // namespace tws
