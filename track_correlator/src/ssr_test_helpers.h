#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "secondary_tracker.h"

namespace track_correlator {

/// An aircraft that flies straight on; a secondary radar sees it.
struct TestAircraft {
  double x, y, vx, vy;  // [m], [m/s] at time 0; east, north
  std::uint16_t mode_3a = kNoCode;
  double height = std::numeric_limits<double>::quiet_NaN();

  double xAt(double t) const { return x + vx * t; }
  double yAt(double t) const { return y + vy * t; }
};

/// A secondary radar without errors: 8 s a turn.
struct TestSsr {
  double period = 8.0;
  std::int64_t first_sector = 0;

  double sectorTime() const { return period / tws::kSectors; }

  /// When the beam meets the aircraft in this turn, and the plot. North of the radar turns count from the south, so
  /// that no turn is left out when an aircraft crosses the north.
  SecondaryPlot plotOf(const TestAircraft& aircraft, int turn) const {
    double t = turn * period;
    for (int i = 0; i < 20; ++i) {
      const double azimuth = std::atan2(aircraft.xAt(t), aircraft.yAt(t));
      t = (turn + (aircraft.y > 0.0 ? azimuth : tws::wrapTwoPi(azimuth)) / tws::kTwoPi) * period;
    }
    SecondaryPlot plot;
    plot.time = t;
    plot.range = std::hypot(aircraft.xAt(t), aircraft.yAt(t));
    plot.azimuth = tws::wrapTwoPi(std::atan2(aircraft.xAt(t), aircraft.yAt(t)));
    plot.mode_3a.code = aircraft.mode_3a;
    plot.height = aircraft.height;
    return plot;
  }

  std::vector<SecondarySector> emptySectors(int turns) const {
    std::vector<SecondarySector> sectors;
    for (std::int64_t n = first_sector; n < turns * tws::kSectors; ++n)
      sectors.push_back({n, static_cast<double>(n + 1) * sectorTime(), {}});
    return sectors;
  }

  /// Puts the plot where its time belongs.
  void put(const SecondaryPlot& plot, std::vector<SecondarySector>& sectors) const {
    const auto at = static_cast<std::int64_t>(std::floor(plot.time / sectorTime())) - first_sector;
    if (at >= 0 && at < static_cast<std::int64_t>(sectors.size()))
      sectors[static_cast<std::size_t>(at)].plots.push_back(plot);
  }
};

/// The tracker and all that it has said.
struct SsrListener {
  std::vector<SecondaryReport> reports;
  SecondaryTracker tracker;

  explicit SsrListener(const SecondaryParams& params = {})
      : tracker(params, [this](const SecondaryReport& report) { reports.push_back(report); }) {}

  void add(const std::vector<SecondarySector>& sectors) {
    for (const SecondarySector& sector : sectors) tracker.add(sector);
  }
  std::vector<SecondaryUpdate> updates() const {
    std::vector<SecondaryUpdate> all;
    for (const SecondaryReport& report : reports) all.insert(all.end(), report.updates.begin(), report.updates.end());
    return all;
  }
  /// How many updates each track has.
  std::map<std::uint32_t, int> tracks() const {
    std::map<std::uint32_t, int> tracks;
    for (const SecondaryUpdate& update : updates()) ++tracks[update.track.uid];
    return tracks;
  }
};

}  // namespace track_correlator
