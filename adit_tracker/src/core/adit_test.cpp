// What becomes of targets.
#include "core/adit.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

INSTANTIATE_TEST_SUITE_P(Sets, BothSets, testing::Values("default", "nrl7952"),
                         [](const auto& info) { return info.param; });

// If this fails, one aircraft is no track, or several.
TEST_P(BothSets, OneAircraftSeenByTwoRadarsIsOneFirmTrackUpdatedByEveryPlot) {
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  const RadarSectors radars = twoRadars(240.0, {aircraft});
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  ASSERT_EQ(listener.confirmed().size(), 1U);
  const std::uint32_t uid = *listener.confirmed().begin();
  const auto updates = listener.of(TrackEvent::kUpdated);
  const auto own = static_cast<std::size_t>(
      std::count_if(updates.begin(), updates.end(), [&](const RecordedUpdate& w) { return w.uid == uid; }));
  const std::size_t absorbed = listener.adit.clutter().absorbed();
  // Every plot starts a track, updates one, or goes into the clutter map; the letter's map takes some of an aircraft's.
  // A point that is found to move then starts one more.
  const std::size_t started = listener.of(TrackEvent::kStarted).size() - listener.adit.counts().to_track;
  EXPECT_EQ(started + updates.size() + absorbed, plotsIn(radars));
  EXPECT_GE(own + absorbed, plotsIn(radars) - 3);
  if (GetParam() == "default") {
    EXPECT_EQ(absorbed, 0U);
  }
  const RecordedUpdate& last =
      *std::find_if(updates.rbegin(), updates.rend(), [&](const RecordedUpdate& w) { return w.uid == uid; });
  EXPECT_NEAR(last.kinematics.x, aircraft.x + aircraft.vx * last.kinematics.time, 300.0);
  EXPECT_NEAR(last.kinematics.y, aircraft.y + aircraft.vy * last.kinematics.time, 300.0);
  EXPECT_NEAR(last.kinematics.vx, aircraft.vx, 20.0);
  EXPECT_NEAR(last.kinematics.vy, aircraft.vy, 20.0);
  EXPECT_EQ(listener.adit.counts().plots, plotsIn(radars));
}

// If this fails, an aircraft is lost or doubled whenever it crosses north, either way round.
TEST_P(BothSets, AnAircraftAcrossNorthStaysOneTrack) {
  for (const double vx : {200.0, -200.0}) {
    Listener listener(params());
    feedInOrder(listener.adit, twoRadars(240.0, {{-120.0 * vx, 60e3, vx, 0.0}}));
    listener.adit.finish();
    EXPECT_EQ(listener.confirmed().size(), 1U);
    const auto coasted = listener.of(TrackEvent::kCoasted);
    EXPECT_EQ(std::count_if(coasted.begin(), coasted.end(), [](const RecordedUpdate& w) { return w.confirmed; }), 0);
  }
}

// The letter loses it by the pass-course effect: it filters in polar coordinates.
TEST(TheDefault, AnAircraftOverTheSiteStaysOneTrack) {
  const TestRadar first(6.0), second(8.0, 0.5);
  for (const double abeam : {20.0, 200.0, 2000.0}) {
    const TestTarget aircraft{-15e3, abeam, 200.0, 0.0};
    RadarSectors radars = {first.sectors(0.0, 160.0), second.sectors(0.0, 160.0)};
    first.see(aircraft, radars[0]);
    second.see(aircraft, radars[1]);
    Listener listener(paramsFor("default", {6.0, 8.0}));
    feedInOrder(listener.adit, radars);
    listener.adit.finish();
    EXPECT_EQ(listener.confirmed().size(), 1U) << abeam;
    EXPECT_LE(listener.adit.counts().tracks_started, 2U) << abeam;
  }
}

// If this fails, a target that only one of the radars sees has no track, or one that flickers.
TEST_P(BothSets, AnAircraftThatOneRadarSeesIsTrackedWhileTheOtherSeesNothing) {
  RadarSectors radars = twoRadars(240.0, {});
  second_.see({60e3, 20e3, -150.0, 120.0}, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_EQ(listener.confirmed().size(), 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 1U);
}

// If this fails, two aircraft that cross are taken for one another, or one track is lost.
TEST_P(BothSets, TwoAircraftThatCrossKeepTheirTracks) {
  // They meet at (40 km, 40 km) at 150 s, with 90° between their courses.
  const std::vector<TestTarget> aircraft = {{10e3, 40e3, 200.0, 0.0}, {40e3, 10e3, 0.0, 200.0}};
  Listener listener(params());
  feedInOrder(listener.adit, twoRadars(300.0, aircraft));
  listener.adit.finish();
  std::map<std::uint32_t, std::set<int>> followed;
  for (const RecordedUpdate& w : listener.of(TrackEvent::kUpdated)) {
    const double t = w.kinematics.time;
    if (!w.confirmed || std::abs(t - 150.0) < 30.0) continue;
    const bool first = std::abs(w.kinematics.y - 40e3) < 2e3;
    followed[w.uid].insert(first ? 0 : 1);
  }
  EXPECT_EQ(followed.size(), 2U);
  for (const auto& [uid, targets] : followed) EXPECT_EQ(targets.size(), 1U) << "track " << uid << " followed both";
}

// If this fails, clutter fills the picture.
TEST_P(BothSets, ThingsThatStandStillBecomeClutterAndNoFirmTracks) {
  auto generator = tws::seededGenerator();
  std::vector<TestTarget> rocks;
  for (int i = 0; i < 20; ++i) rocks.push_back({-20e3 + 2.3e3 * i, 15e3 + 1.7e3 * i, 0.0, 0.0});
  RadarSectors radars = twoRadars(300.0, rocks);
  for (auto& sectors : radars) disturb(sectors, 60.0, 0.003, 0.8, 0.0, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::set<std::uint32_t> late;
  for (const RecordedUpdate& w : listener.updates) {
    if (w.confirmed && w.sector_time > 150.0) late.insert(w.uid);
  }
  EXPECT_LE(late.size(), 1U);  // Of 20.
}

/// How many of 24 helicopters, 35 m/s and far away, became clutter points.
std::uint64_t helicoptersTakenForClutter(const AditParams& params) {
  auto generator = tws::seededGenerator();
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 600.0)};
  for (int i = 0; i < 24; ++i) {
    const double a = tws::kTwoPi * i / 24.0;
    radar.see({120e3 * std::sin(a), 120e3 * std::cos(a), 35.0 * std::cos(2.0 * a), 35.0 * std::sin(2.0 * a)},
              radars[0]);
  }
  disturb(radars[0], 75.0, 0.0035, 0.9, 0.0, generator);
  Adit adit(params, nullptr);
  feedInOrder(adit, radars);
  adit.finish();
  return adit.counts().to_clutter;
}

// If this fails, slow aircraft far away are lost to the clutter map again and again: by their places they seem to
// stand.
TEST(Adit, WhatIsSlowAndFarInAQuietPlaceBecomesNoClutterPoint) {
  AditParams params = paramsFor("default", {6.0});
  EXPECT_LE(helicoptersTakenForClutter(params), 4U);
  params.conversion.speed_sigmas = 0.0;
  EXPECT_GE(helicoptersTakenForClutter(params), 8U) << "then this test shows nothing";
}

// The letter has nothing against clutter that is detected only now and then; see README.md.
TEST_P(BothSets, ATrackThatStopsBecomesAClutterPoint) {
  RadarSectors radars = twoRadars(500.0, {{40e3, 30e3, 100.0, 0.0, 0.0, 150.0}});
  const TestTarget stopped{40e3 + 100.0 * 150.0, 30e3, 0.0, 0.0, 150.0};
  first_.see(stopped, radars[0]);
  second_.see(stopped, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_GE(listener.adit.counts().to_clutter, 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 0U);
  std::uint32_t points = 0;
  for (const ClutterMap& map : listener.adit.clutter().maps()) points += map.size();
  EXPECT_GE(points, 1U);
}

// If this fails, a helicopter that takes off from where it was clutter is never seen.
TEST_P(BothSets, AClutterPointThatBeginsToMoveBecomesATrack) {
  RadarSectors radars = twoRadars(600.0, {{20e3, 30e3, 0.0, 0.0, 0.0, 120.0}});
  // 60 kn outwards: 185 m a scan, so that the clutter map goes on following it.
  const double speed = 60.0 * 1852.0 / 3600.0;
  const TestTarget moving{20e3 - 120.0 * speed * 0.5547, 30e3 - 120.0 * speed * 0.83205, speed * 0.5547,
                          speed * 0.83205, 120.0};
  first_.see(moving, radars[0]);
  second_.see(moving, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  bool followed = false;
  for (const auto slot : listener.adit.tracks().living()) {
    const Kinematics k = listener.adit.tracks().extrapolate(slot, 590.0).kinematics;
    followed = followed || (listener.adit.tracks().confirmed(listener.adit.tracks().at(slot)) &&
                            std::abs(k.range - moving.range(590.0)) < 700.0);
  }
  EXPECT_TRUE(followed);
}

// With one map for all radars, the point is judged on the scans of a radar that may never have seen it.
// If this fails, the display says that a radar sees what only the other one does.
TEST_P(BothSets, ATrackKnowsWhichRadarSawItAlsoIfItWasAClutterPoint) {
  RadarSectors radars = twoRadars(400.0, {});
  const double speed = 60.0 * 1852.0 / 3600.0;
  first_.see({20e3, 30e3, speed * 0.5547, speed * 0.83205}, radars[0]);
  const Adit* tracker = nullptr;
  std::size_t updates = 0;
  Adit adit(params(), [&](const SectorReport& report) {
    for (const TrackUpdate& update : report.updates) EXPECT_EQ(tracker->tracks().at(update.slot).updated[1], kNever);
    updates += report.updates.size();
  });
  tracker = &adit;
  feedInOrder(adit, radars);
  adit.finish();
  EXPECT_GT(updates, 0U);
  EXPECT_TRUE(params().clutter.per_radar || adit.counts().to_track > 0U);
}

// TFIX: firm by the first update later than 20 s after the first detection. Radar of 6 s: at 24 s.
TEST(TheLetter, ATrackIsFirmByItsFirstUpdateAfter20Seconds) {
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 60.0)};
  radar.see({20e3, 20e3, 200.0, 200.0}, radars[0]);
  Listener listener(paramsFor("nrl7952", {6.0}));
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  const auto started = listener.of(TrackEvent::kStarted), updated = listener.of(TrackEvent::kUpdated);
  ASSERT_FALSE(started.empty());
  const auto first_firm =
      std::find_if(updated.begin(), updated.end(), [](const RecordedUpdate& w) { return w.confirmed; });
  ASSERT_NE(first_firm, updated.end());
  EXPECT_NEAR(first_firm->kinematics.time - started.front().kinematics.time, 24.0, 0.1);
}

// Initiation runs one sector behind and starts both a track and a clutter point from every unused detection.
TEST(TheLetter, AnUnusedDetectionStartsATrackAndAClutterPoint) {
  const TestRadar radar(6.4);
  RadarSectors radars = {radar.sectors(0.0, 6.0)};
  tws::Plot plot;
  plot.time = 1.05;
  plot.range = 50e3;
  plot.azimuth = 10.5 * tws::kSectorWidth;
  radars[0][10].plots.push_back(plot);
  Listener listener(paramsFor("nrl7952", {6.4}));
  feedInOrder(listener.adit, radars);
  ASSERT_EQ(listener.updates.size(), 1U);
  EXPECT_EQ(listener.updates[0].running, 11);
  EXPECT_EQ(listener.updates[0].event, TrackEvent::kStarted);
  EXPECT_FALSE(listener.updates[0].confirmed);
  ASSERT_EQ(listener.adit.clutter().maps().size(), 1U);
  EXPECT_EQ(listener.adit.clutter().maps()[0].size(), 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 1U);
}

// What this method costs in latency by design: five sectors (the clutter map needs sector +4).
TEST(TheLetter, ProcessesASectorWhenTheFourAheadOfItHaveClosed) {
  const TestRadar radar(6.4);
  const auto sectors = radar.sectors(0.0, 6.4);
  Listener listener(paramsFor("nrl7952", {6.4}));
  for (std::size_t i = 0; i < 10; ++i) {
    addAndProcess(listener.adit, 0, sectors[i]);
    EXPECT_EQ(listener.sectors, std::max(0, static_cast<int>(i) - 3));
  }
}

}  // namespace
}  // namespace adit_tracker
