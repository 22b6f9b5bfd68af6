// What becomes of tracks where radars see nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/adit.h"
#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// Two radars that see to 100 km and have a blind sector behind a mast; aircraft, one after another.
class CoverTest : public testing::Test {
 protected:
  static constexpr double kCover = 100e3, kSpeed = 250.0;

  void fly(const std::vector<TestTarget>& targets, double to, const AditParams& params) {
    RadarSectors radars;
    for (const double period : {6.0, 8.0}) {
      const TestRadar radar(period);
      radars.push_back(radar.sectors(0.0, to));
      for (const TestTarget& target : targets) radar.see(target, radars.back());
      for (tws::RadarSector& sector : radars.back()) hide(sector);
    }
    auto generator = tws::seededGenerator();
    for (auto& sectors : radars) disturb(sectors, 50.0, 0.002, 0.95, 0.0, generator);
    listener_ = std::make_unique<Listener>(params);
    feedInOrder(listener_->adit, radars);
    listener_->adit.finish();
  }

  void hide(tws::RadarSector& sector) const {
    auto& plots = sector.plots;
    const auto hidden = [&](const tws::Plot& plot) {
      const bool behind_mast = plot.azimuth > mast_ && plot.azimuth < mast_ + width_ && plot.range > 10e3;
      return plot.range > kCover || behind_mast;
    };
    plots.erase(std::remove_if(plots.begin(), plots.end(), hidden), plots.end());
  }

  /// How long each confirmed track was told after its last detection [s].
  std::vector<double> coasted() const {
    std::map<std::uint32_t, std::pair<double, double>> last;  // detection, update
    for (const RecordedUpdate& w : listener_->updates) {
      if (w.confirmed && w.event == TrackEvent::kUpdated) last[w.uid] = {w.kinematics.time, w.kinematics.time};
      if (last.count(w.uid) > 0) last[w.uid].second = w.kinematics.time;
    }
    std::vector<double> times;
    for (const auto& [uid, when] : last) times.push_back(when.second - when.first);
    return times;
  }

  double mast_ = 0.0, width_ = 0.0;
  std::unique_ptr<Listener> listener_;
};

AditParams withoutCover() {
  AditParams params = paramsFor("default", {6.0, 8.0});
  params.coverage.longest_gap = 0.0;
  return params;
}

// Forty aircraft fly out, one every 15 s. If this fails, those that have left are shown for half a minute.
TEST_F(CoverTest, ATrackThatLeavesCoverEndsAtItsFirstMisses) {
  std::vector<TestTarget> targets;
  for (int i = 0; i < 40; ++i) {
    const double azimuth = 2.4 * i, from = 15.0 * i, range = 80e3 - kSpeed * from;
    targets.push_back({range * std::sin(azimuth), range * std::cos(azimuth), kSpeed * std::sin(azimuth),
                       kSpeed * std::cos(azimuth), from});
  }
  const auto meanOfLast = [&] {
    const std::vector<double> times = coasted();
    EXPECT_GE(times.size(), 40U);
    double sum = 0.0;
    for (std::size_t i = std::max<std::size_t>(times.size(), 15) - 15; i < times.size(); ++i) sum += times[i] / 15.0;
    return sum;
  };
  fly(targets, 760.0, paramsFor("default", {6.0, 8.0}));
  const double learned = meanOfLast();
  fly(targets, 760.0, withoutCover());
  EXPECT_LT(learned, 8.0);
  EXPECT_GT(meanOfLast(), 1.8 * learned);
}

// A radar that sees to 60 km, and one that sees to 200 km and is switched off. If this fails, what only the second one
// saw stays on the picture for minutes, because the first one cannot miss it.
TEST_F(CoverTest, WhatASilentRadarCoversIsNotCovered) {
  constexpr double kOff = 700.0;
  std::vector<TestTarget> targets;
  for (int i = 0; i < 60; ++i) {
    const double azimuth = 2.4 * i, from = 12.0 * i, range = 30e3 - kSpeed * from;
    targets.push_back({range * std::sin(azimuth), range * std::cos(azimuth), kSpeed * std::sin(azimuth),
                       kSpeed * std::cos(azimuth), from});
  }
  const TestRadar near(6.0), far(8.0);
  RadarSectors radars = {near.sectors(0.0, 900.0), far.sectors(0.0, kOff)};
  for (const TestTarget& target : targets) {
    near.see(target, radars[0]);
    far.see(target, radars[1]);
  }
  for (tws::RadarSector& sector : radars[0]) {
    auto& plots = sector.plots;
    plots.erase(std::remove_if(plots.begin(), plots.end(), [](const tws::Plot& p) { return p.range > 60e3; }),
                plots.end());
  }
  Listener listener(paramsFor("default", {6.0, 8.0}));
  feedInOrder(listener.adit, radars);
  std::set<std::uint32_t> before, after;
  for (const RecordedUpdate& w : listener.updates) {
    if (!w.confirmed || w.event == TrackEvent::kDropped || w.kinematics.range < 100e3) continue;
    if (w.sector_time > kOff - 10.0 && w.sector_time < kOff) before.insert(w.uid);
    if (w.sector_time > kOff + 60.0) after.insert(w.uid);
  }
  EXPECT_GT(before.size(), 15U);
  EXPECT_EQ(after.size(), 0U);
}

// Aircraft pass behind a mast at 40 km, one every 20 s: there, no radar sees them for 25 s. If this fails, most of them
// come out as others.
TEST_F(CoverTest, ATrackThatWillBeSeenAgainLivesOn) {
  width_ = tws::radians(9.0);
  constexpr int kAircraft = 80;
  std::vector<TestTarget> targets;
  for (int i = 0; i < kAircraft; ++i) {
    const double from = 20.0 * i;
    targets.push_back({-30e3 - kSpeed * from, 40e3, kSpeed, 0.0, from, from + 240.0});
  }
  const auto breaks = [&](const AditParams& params) {
    fly(targets, 20.0 * kAircraft + 240.0, params);
    std::set<std::uint32_t> uids;
    for (const RecordedUpdate& w : listener_->updates) {
      if (w.confirmed && w.event == TrackEvent::kUpdated) uids.insert(w.uid);
    }
    return static_cast<double>(uids.size()) - kAircraft;
  };
  const double unknown = breaks(withoutCover());
  EXPECT_GT(unknown, 0.4 * kAircraft);
  const double learned = breaks(paramsFor("default", {6.0, 8.0}));
  EXPECT_GE(learned, 0.0) << "all are tracked";
  EXPECT_LT(learned, 0.6 * unknown);
}

}  // namespace
}  // namespace adit_tracker
