#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beam.h"
#include "reports.h"

namespace asterix_bridge {

struct TimedReport {
  double time = 0.0;  // the beam was on the target, since 1970 [s]
  TargetReport report;
};

/// What one radar reported while its beam crossed one of 64 sectors.
struct CutSector {
  int sector = 0;            // 0 .. 63
  std::int64_t running = 0;  // since the radar's start; modulo 64 it is `sector`
  double enter_time = 0.0;   // since 1970 [s]
  double leave_time = 0.0;
  double period = kUnknown;          // of a turn [s]
  std::vector<TimedReport> reports;  // in order of time
};

/// Cuts the reports of one radar into sectors as they come. Marks say where the beam is if there are any, plots always.
///
/// Nothing comes out until the beam is known: then all that was kept does, from the first report on. A sector is closed
/// once the radar has been heard for `settle` beyond it. Reports that come later still go into the next sector.
class SectorCutter {
 public:
  struct Options {
    double settle = 1.0;    // how much out of order a radar's reports may be [s], >= 0
    double latency = 2.0;   // the feed's time leads the radar's by at most this [s], >= settle
    double silence = 15.0;  // a radar that was not heard for so long or for two and a half turns, is silent [s]
    bool steady = false;    // close sectors by the feed's time alone, `latency` behind it: one by one, not in bursts
    double restart = 10.0;  // time that goes back by more begins a new run [s]
  };
  struct Events {
    std::function<void(CutSector&& sector)> sector;
    /// `counter`: "late reports", "reports at impossible times", "silences", "new runs", "reports before the
    /// beam was known", "reports of an unknown beam", "unknown beams", "beam breaks", "beams lost".
    std::function<void(const std::string& counter, const std::string& reason)> fault;
  };

  SectorCutter(Options options, Events events) : options_(options), events_(std::move(events)) {}

  /// A report with measured azimuth and a time.
  void add(const TargetReport& report, double time);
  /// The beam enters the sector that begins at this azimuth [rad]; 0 is the north mark.
  void mark(double time, double azimuth);
  /// As the radar says it [s].
  void setNominalPeriod(double period) { beam_.setNominalPeriod(period); }
  void setLatency(double latency) { options_.latency = latency; }
  /// The feed has come to this time [s]: the sectors that are then complete come out.
  void advance(double feed_time);
  /// There will be no more: all that is left comes out, up to the sector of the last report.
  void finish();

 private:
  bool isPossible(double time);
  double placed(const TargetReport& report, double time) const;
  void followBreak();
  void sayThatUnknown();
  void turnAlong(const tws::SteadyBeam& line);
  void placeAll();
  void beginAnew();
  double silence() const;
  void release(double until);
  void start();
  void close();

  Options options_;
  Events events_;
  Beam beam_;
  std::vector<TimedReport> reports_;  // not in a closed sector, in order of time
  std::optional<double> newest_;      // own time [s]
  std::optional<double> earliest_;
  std::optional<double> feed_time_;      // of a live feed [s]
  std::optional<std::int64_t> running_;  // the open sector
  double followed_ = 0.0;                // the beam was drawn to what is known of it [s]
  std::int64_t next_ = 0;                // behind the last one closed
  double enter_time_ = 0.0;
  int impossible_ = 0;         // in a row
  bool said_unknown_ = false;  // since the beam was known last
};

}  // namespace asterix_bridge
