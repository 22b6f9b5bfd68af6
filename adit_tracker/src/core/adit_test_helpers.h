#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/plot.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/sectors.h>

#include "core/adit.h"

namespace adit_tracker {

/// Straight flight on the plane: position at t = 0 [m], velocity [m/s], seen between two times [s].
struct TestTarget {
  double x, y, vx, vy;
  double from = 0.0, to = std::numeric_limits<double>::infinity();

  double range(double t) const { return std::hypot(x + vx * t, y + vy * t); }
  double azimuth(double t) const { return tws::wrapTwoPi(std::atan2(x + vx * t, y + vy * t)); }
};

/// A radar whose beam points to north at t = 0 and turns evenly. Its sectors hold what it sees of the targets.
class TestRadar {
 public:
  explicit TestRadar(double period, double offset = 0.0) : period_(period), offset_(offset) {}

  double time(std::int64_t running) const { return offset_ + period_ / tws::kSectors * static_cast<double>(running); }

  /// The sectors from `from` to `to` [s], numbered from the radar's first.
  std::vector<tws::RadarSector> sectors(double from, double to) const {
    std::vector<tws::RadarSector> all;
    for (std::int64_t i = 0; time(i + 1) <= to; ++i) {
      if (time(i) < from - 1e-9) continue;
      tws::RadarSector sector;
      sector.running = i;
      sector.sector = static_cast<int>(i % tws::kSectors);
      sector.enter_time = time(i);
      sector.leave_time = time(i + 1);
      all.push_back(sector);
    }
    return all;
  }

  /// One plot whenever the beam meets the target.
  void see(const TestTarget& target, std::vector<tws::RadarSector>& sectors) const {
    for (tws::RadarSector& sector : sectors) {
      const double t = meeting(target, sector);
      if (t < target.from || t > target.to) continue;
      tws::Plot plot;
      plot.time = t;
      plot.range = target.range(t);
      plot.azimuth = target.azimuth(t);
      sector.plots.push_back(plot);
    }
  }

 private:
  /// When the beam meets the target within the sector; NaN: it does not.
  double meeting(const TestTarget& target, const tws::RadarSector& sector) const {
    double low = sector.enter_time, high = sector.leave_time;
    const auto ahead = [&](double t) { return tws::wrapPi(target.azimuth(t) - tws::kTwoPi / period_ * (t - offset_)); };
    if (!(ahead(low) >= 0.0 && ahead(low) < 1.0 && ahead(high) < 0.0)) return kNotMet;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (ahead(middle) >= 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  static constexpr double kNotMet = -std::numeric_limits<double>::infinity();
  double period_, offset_;
};

/// Errors of range [m] and azimuth [rad], the same chance of detection for all, false plots a sector within 100 km.
inline void disturb(std::vector<tws::RadarSector>& sectors, double range_sigma, double azimuth_sigma, double detected,
                    double false_plots, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  for (tws::RadarSector& sector : sectors) {
    std::vector<tws::Plot> kept;
    for (tws::Plot plot : sector.plots) {
      if (tws::uniform(generator, 0.0, 1.0) >= detected) continue;
      plot.range += range_sigma * normal(generator);
      plot.azimuth = tws::wrapTwoPi(plot.azimuth + azimuth_sigma * normal(generator));
      kept.push_back(plot);
    }
    for (int i = std::poisson_distribution<int>(false_plots)(generator); i > 0; --i) {
      tws::Plot plot;
      plot.time = tws::uniform(generator, sector.enter_time, sector.leave_time);
      plot.range = 100e3 * std::sqrt(tws::uniform(generator, 1e-4, 1.0));
      plot.azimuth = tws::wrapTwoPi(tws::sectorStart(sector.sector) + tws::uniform(generator, 0.0, tws::kSectorWidth));
      kept.push_back(plot);
    }
    std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    sector.plots = kept;
  }
}

using RadarSectors = std::vector<std::vector<tws::RadarSector>>;

/// The radar and index of each sector, in the order in which they arrive: each radar's own is kept, none comes after
/// one that closed by more than `skew` later. Skew 0: by closing time.
inline std::vector<std::pair<std::size_t, std::size_t>> arrivalOf(const RadarSectors& radars, double skew,
                                                                  std::mt19937_64& generator) {
  std::vector<std::pair<std::size_t, std::size_t>> arrival;
  std::vector<std::size_t> next(radars.size(), 0);
  for (;;) {
    double oldest = std::numeric_limits<double>::infinity();
    const auto leave = [&](std::size_t r) { return radars[r][next[r]].leave_time; };
    for (std::size_t r = 0; r < radars.size(); ++r) {
      if (next[r] < radars[r].size()) oldest = std::min(oldest, leave(r));
    }
    std::vector<std::size_t> may;
    for (std::size_t r = 0; r < radars.size(); ++r) {
      if (next[r] < radars[r].size() && leave(r) <= oldest + skew) may.push_back(r);
    }
    if (may.empty()) return arrival;
    const auto i = static_cast<std::size_t>(tws::uniformInt(generator, 0, static_cast<int>(may.size()) - 1));
    arrival.emplace_back(may[i], next[may[i]]++);
  }
}

/// A named set with radars r0, r1, … of these periods.
inline AditParams paramsFor(const std::string& set, const std::vector<double>& periods) {
  AditParams params = AditParams::named(set);
  for (const double period : periods) {
    RadarParams radar;
    radar.name = "r" + std::to_string(params.radars.size());
    radar.period = period;
    params.radars.push_back(radar);
  }
  return params;
}

/// What the tracker said of one track in one sector.
struct RecordedUpdate {
  double sector_time;
  std::size_t radar;
  std::int64_t running;
  std::uint32_t uid, number;
  TrackEvent event;
  bool confirmed;
  Kinematics kinematics;
};

/// The tracker with all that it says.
class Listener {
 public:
  explicit Listener(const AditParams& params) : adit(params, [this](const SectorReport& r) { hear(r); }) {}

  void hear(const SectorReport& report) {
    ++sectors;
    for (const TrackUpdate& w : report.updates) {
      const Track& track = adit.tracks().at(w.slot);
      updates.push_back({report.enter_time, report.radar, report.running, track.uid, track.number, w.event,
                         adit.tracks().confirmed(track), adit.tracks().extrapolate(w.slot, w.time).kinematics});
    }
  }

  std::vector<RecordedUpdate> of(TrackEvent event) const {
    std::vector<RecordedUpdate> result;
    std::copy_if(updates.begin(), updates.end(), std::back_inserter(result),
                 [&](const RecordedUpdate& w) { return w.event == event; });
    return result;
  }

  /// Identities of tracks that were believed at any time.
  std::set<std::uint32_t> confirmed() const {
    std::set<std::uint32_t> uids;
    for (const RecordedUpdate& w : updates) {
      if (w.confirmed) uids.insert(w.uid);
    }
    return uids;
  }

  /// Every bit of all that was said.
  std::string bytes() const {
    std::ostringstream out;
    out << std::hexfloat;
    for (const RecordedUpdate& w : updates) {
      const Kinematics& k = w.kinematics;
      out << w.sector_time << ' ' << w.radar << ' ' << w.running << ' ' << w.uid << ' ' << w.number << ' '
          << static_cast<int>(w.event) << ' ' << w.confirmed << ' ' << k.time << ' ' << k.range << ' ' << k.azimuth
          << ' ' << k.range_rate << ' ' << k.azimuth_rate << ' ' << k.x << ' ' << k.y << ' ' << k.vx << ' ' << k.vy
          << '\n';
    }
    return out.str();
  }

  std::vector<RecordedUpdate> updates;
  int sectors = 0;
  Adit adit;
};

inline void feed(Adit& adit, const RadarSectors& radars, double skew, std::mt19937_64& generator) {
  for (const auto& [radar, index] : arrivalOf(radars, skew, generator))
    addAndProcess(adit, radar, radars[radar][index]);
}

inline void feedInOrder(Adit& adit, const RadarSectors& radars) {
  std::mt19937_64 generator(1);
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t r = 0; r < radars.size(); ++r) {
    for (std::size_t i = 0; i < radars[r].size(); ++i) order.emplace_back(radars[r][i].leave_time, r, i);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [time, r, i] : order) addAndProcess(adit, r, radars[r][i]);
}

/// Both sets on radars of 6 and 8 s.
class BothSets : public testing::TestWithParam<std::string> {
 protected:
  AditParams params() const { return paramsFor(GetParam(), {6.0, 8.0}); }

  RadarSectors twoRadars(double to, const std::vector<TestTarget>& targets) const {
    RadarSectors radars = {first_.sectors(0.0, to), second_.sectors(0.0, to)};
    for (const TestTarget& target : targets) {
      first_.see(target, radars[0]);
      second_.see(target, radars[1]);
    }
    return radars;
  }

  TestRadar first_{6.0}, second_{8.0, 0.5};
};
inline std::size_t plotsIn(const RadarSectors& radars) {
  std::size_t count = 0;
  for (const auto& sectors : radars) {
    for (const auto& sector : sectors) count += sector.plots.size();
  }
  return count;
}

}  // namespace adit_tracker
