#pragma once

#include <iosfwd>
#include <map>
#include <optional>

#include "reports.h"

namespace asterix_bridge {

/// The name of a radar in topics and files: "radar_20_130" for SAC 20, SIC 130.
std::string radarName(SourceId source);

/// Writes plots, codes and levels only where they are validated and not garbled, as
/// `t_s,radar,scan,range_m,az_deg,mode3a,fl,address,callsign,track`; times from the first plot on.
class PlotCsv {
 public:
  /// `periods`: of the radars' turns [s], as far as they are known.
  explicit PlotCsv(std::ostream& out, std::map<SourceId, double> periods = {});
  /// A report without measured position or time is left out.
  void add(const TargetReport& report, double time);
  std::uint64_t leftOut() const { return left_out_; }
  /// Plots written.
  std::uint64_t count() const { return count_; }

 private:
  // Counts turns by the azimuth from plot to plot, and by the time if the period is known: else a turn without plots
  // over half of it is not seen.
  struct Turns {
    double time = 0.0;
    double azimuth = 0.0;
    double unwrapped = 0.0;
    bool started = false;
  };
  long scanOf(const TargetReport& report, double time);

  std::ostream& out_;
  std::optional<double> start_;
  std::map<SourceId, double> periods_;
  std::map<SourceId, Turns> turns_;
  std::uint64_t left_out_ = 0;
  std::uint64_t count_ = 0;
};

/// Writes all fields of every record, one line each, in the units of the radar; what was not sent is empty.
class RecordCsv {
 public:
  explicit RecordCsv(std::ostream& out);
  void add(const TargetReport& report, double time);
  void add(const ServiceMessage& message, double time);

 private:
  std::ostream& out_;
};

}  // namespace asterix_bridge
