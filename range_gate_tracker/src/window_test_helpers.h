#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include <tws_core/geometry.h>
#include <tws_core/plot.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

namespace range_gate_tracker {

/// Where a target is at a time [s]: east and north of the radar [m].
using Flight = std::function<Eigen::Vector2d(double)>;

inline Flight straight(double x, double y, double vx, double vy) {
  return [=](double t) { return Eigen::Vector2d(x + vx * t, y + vy * t); };
}

/// A radar of 6 s a turn without errors, which starts at north at time 0.
struct TestRadar {
  static constexpr double kPeriod = 6.0;

  /// When the beam meets a target that is at most one turn of the search away, after `from`.
  static double meets(const Flight& flight, double from) {
    double t = from;
    const double beam = std::fmod(from / kPeriod, 1.0) * tws::kTwoPi;
    t += tws::wrapTwoPi(tws::azimuthOf(flight(t)) - beam) / tws::kTwoPi * kPeriod;
    for (int i = 0; i < 20; ++i)
      t += tws::wrapPi(tws::azimuthOf(flight(t)) - t / kPeriod * tws::kTwoPi) / tws::kTwoPi * kPeriod;
    return t;
  }

  static tws::Plot plotAt(const Flight& flight, double time) {
    tws::Plot plot;
    plot.time = time;
    plot.range = flight(time).norm();
    plot.azimuth = tws::azimuthOf(flight(time));
    plot.range_sigma = 100.0;
    plot.azimuth_sigma = tws::radians(0.3);
    return plot;
  }

  /// Sectors of so many turns with all that is seen of the targets; `seen` may deny a target its detection.
  static std::vector<tws::RadarSector> sectors(
      const std::vector<Flight>& flights, int turns,
      const std::function<bool(std::size_t, double)>& seen = [](std::size_t, double) { return true; }) {
    std::vector<tws::RadarSector> all(static_cast<std::size_t>(turns) * tws::kSectors);
    for (std::size_t n = 0; n < all.size(); ++n) {
      all[n].sector = static_cast<int>(n % tws::kSectors);
      all[n].running = static_cast<std::int64_t>(n);
      all[n].enter_time = static_cast<double>(n) * kPeriod / tws::kSectors;
      all[n].leave_time = static_cast<double>(n + 1) * kPeriod / tws::kSectors;
    }
    for (std::size_t i = 0; i < flights.size(); ++i) {
      for (double t = meets(flights[i], 0.0); t < turns * kPeriod; t = meets(flights[i], t + 0.5 * kPeriod)) {
        const auto n = static_cast<std::size_t>(t / kPeriod * tws::kSectors);
        if (n < all.size() && seen(i, t)) all[n].plots.push_back(plotAt(flights[i], t));
      }
    }
    for (auto& sector : all)
      std::sort(sector.plots.begin(), sector.plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return all;
  }
};

}  // namespace range_gate_tracker
