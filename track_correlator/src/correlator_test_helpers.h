#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "correlator.h"

namespace track_correlator {

/// A correlator and all its reports. One scan takes 64 marks; all tracks are added once a scan, before its marks.
struct CorrelatorListener {
  std::vector<CorrelatorReport> reports;
  Correlator correlator;
  double period = 1.0;  // [s]
  std::int64_t next_mark = 0;

  explicit CorrelatorListener(const CorrelatorParams& params = {})
      : correlator(params, [this](const CorrelatorReport& report) { reports.push_back(report); }) {}

  double now() const { return static_cast<double>(next_mark) * period / tws::kSectors; }

  /// The marks of one turn; what it says of every track comes Δ₂ sectors later.
  void turn() {
    for (int i = 0; i < tws::kSectors; ++i, ++next_mark) correlator.addMark(next_mark, now());
  }

  /// The updates that the last turn said.
  std::vector<CorrelatedUpdate> lastTurn() const {
    std::vector<CorrelatedUpdate> updates;
    const std::size_t first = reports.size() - std::min<std::size_t>(reports.size(), tws::kSectors);
    for (std::size_t i = first; i < reports.size(); ++i)
      updates.insert(updates.end(), reports[i].updates.begin(), reports[i].updates.end());
    return updates;
  }
  std::vector<CorrelatedUpdate> updates() const {
    std::vector<CorrelatedUpdate> updates;
    for (const auto& report : reports) updates.insert(updates.end(), report.updates.begin(), report.updates.end());
    return updates;
  }
};

inline TrackInput trackInput(std::uint32_t uid, double time, double x, double y, double vx, double vy,
                             double position_sigma = 30.0, double velocity_sigma = 10.0) {
  TrackInput track;
  track.uid = uid;
  track.time = time;
  track.state << x, y, vx, vy;
  track.covariance.setZero();
  const double p = position_sigma * position_sigma, v = velocity_sigma * velocity_sigma;
  track.covariance.diagonal() << p, p, v, v;
  return track;
}

}  // namespace track_correlator
