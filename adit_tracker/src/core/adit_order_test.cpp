// Order of arrival, bad input, limits: what must hold whatever the targets do.
#include "core/adit.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

// adit_test.cpp says with which sets.

// If this fails, one radar that is switched off takes the tracks with it.
TEST_P(BothSets, TheOtherRadarGoesOnWhenOneFallsSilentAndTakesItInAgain) {
  RadarSectors radars = {first_.sectors(0.0, 360.0), second_.sectors(0.0, 360.0)};
  auto& off = radars[0];
  off.erase(
      std::remove_if(off.begin(), off.end(), [](const auto& s) { return s.leave_time > 100 && s.enter_time < 220; }),
      off.end());
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  first_.see(aircraft, radars[0]);
  second_.see(aircraft, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_EQ(listener.confirmed().size(), 1U);
  EXPECT_EQ(listener.adit.counts().late_sectors, 0U);
  EXPECT_EQ(listener.sectors, static_cast<int>(radars[0].size() + radars[1].size()));
  int during = 0, after = 0;
  for (const RecordedUpdate& w : listener.of(TrackEvent::kUpdated)) {
    if (w.sector_time > 105.0 && w.sector_time < 215.0) during += w.radar == 1 ? 1 : 100;
    if (w.sector_time > 230.0 && w.radar == 0) ++after;
  }
  EXPECT_GE(during, 12);
  EXPECT_LE(during, 14);
  EXPECT_GE(after, 20);
}

// If this fails, reports of the same recording differ between a live run and a replay.
TEST_P(BothSets, SaysTheSameBitForBitInWhateverOrderTheRadarsArrive) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(150.0, {});
  // The first radar misses some scans and comes again, as radars do.
  radars[0].erase(std::remove_if(radars[0].begin(), radars[0].end(),
                                 [](const auto& s) { return s.leave_time > 60.0 && s.enter_time < 75.0; }),
                  radars[0].end());
  for (int i = 0; i < 40; ++i) {
    const double r = tws::uniform(generator, 20e3, 90e3), a = tws::uniform(generator, 0.0, 6.28);
    const double speed = i < 25 ? tws::uniform(generator, 50.0, 300.0) : 0.0, c = tws::uniform(generator, 0.0, 6.28);
    const TestTarget target{r * std::sin(a), r * std::cos(a), speed * std::sin(c), speed * std::cos(c)};
    first_.see(target, radars[0]);
    second_.see(target, radars[1]);
  }
  for (auto& sectors : radars) {
    disturb(sectors, 80.0, 0.004, 0.85, 0.3, generator);
    // A clock of 8 ms ticks: the turns look uneven.
    for (auto& sector : sectors) {
      sector.enter_time = tws::quantise(sector.enter_time, 0.008);
      sector.leave_time = tws::quantise(sector.leave_time, 0.008);
    }
  }
  std::string expected;
  for (int run = 0; run < 8; ++run) {
    Listener listener(params());
    feed(listener.adit, radars, run == 0 ? 0.0 : 0.7, generator);
    listener.adit.finish();
    EXPECT_EQ(listener.adit.counts().late_sectors, 0U);
    const std::string bytes = listener.bytes();
    ASSERT_GT(listener.updates.size(), 1000U);
    if (run == 0) expected = bytes;
    const auto differs = std::mismatch(expected.begin(), expected.end(), bytes.begin(), bytes.end());
    ASSERT_TRUE(bytes == expected) << "run " << run << " differs first in line "
                                   << std::count(expected.begin(), differs.first, '\n') + 1 << " of "
                                   << std::count(expected.begin(), expected.end(), '\n');
  }
}

// If this fails, a track's one missed illumination counts twice: it is dropped too early, and drawn twice.
TEST_P(BothSets, SaysOfATrackAtMostOneThingForEachScanOfARadar) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(200.0, {});
  for (int i = 0; i < 40; ++i) {
    const double r = tws::uniform(generator, 10e3, 60e3), a = tws::uniform(generator, 0.0, 6.28);
    // Clockwise or anticlockwise about the site, at 200 m/s.
    const double speed = i % 2 == 0 ? 200.0 : -200.0;
    const TestTarget target{r * std::sin(a), r * std::cos(a), speed * std::cos(a), -speed * std::sin(a)};
    first_.see(target, radars[0]);
    second_.see(target, radars[1]);
  }
  for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 0.7, 0.0, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::map<std::pair<std::uint32_t, std::size_t>, std::int64_t> last;
  int close = 0;
  for (const RecordedUpdate& w : listener.updates) {
    if (w.event != TrackEvent::kUpdated && w.event != TrackEvent::kCoasted) continue;
    const auto [previous, is_new] = last.try_emplace({w.uid, w.radar}, w.running);
    if (!is_new && w.running - previous->second < 32) ++close;
    previous->second = w.running;
  }
  EXPECT_EQ(close, 0) << "of " << listener.updates.size();
}

// If this fails, a full tracker throws away tracks that it has, or the user is not told that new ones are refused.
TEST_P(BothSets, AtFullCapacityNewTracksAreRefusedAndCountedAndTheOldOnesGoOn) {
  AditParams p = params();
  p.capacity = 4;  // Three tracks.
  p.clutter.capacity = 10;
  std::vector<TestTarget> aircraft;
  for (int i = 0; i < 3; ++i) aircraft.push_back({30e3 + 10e3 * i, 20e3, 150.0, 150.0});
  for (int i = 0; i < 5; ++i) aircraft.push_back({-30e3 - 10e3 * i, -20e3, -150.0, 150.0, 100.0});
  Listener listener(p);
  feedInOrder(listener.adit, twoRadars(250.0, aircraft));
  listener.adit.finish();
  EXPECT_EQ(listener.adit.tracks().size(), 3U);
  EXPECT_GT(listener.adit.counts().refused_tracks, 100U);
  EXPECT_GT(listener.adit.counts().refused_clutter, 0U);
  EXPECT_EQ(listener.confirmed().size(), 3U);
  for (const auto slot : listener.adit.tracks().living()) {
    EXPECT_GT(listener.adit.tracks().extrapolate(slot, 250.0).kinematics.x, 0.0);
    EXPECT_GT(listener.adit.tracks().at(slot).last_update, 240.0);
  }
}

TEST_P(BothSets, NumbersOfDroppedTracksServeAgain) {
  AditParams p = params();
  p.capacity = 3;
  std::vector<TestTarget> aircraft;
  for (int i = 0; i < 4; ++i) aircraft.push_back({30e3, 20e3, 150.0, 150.0, 200.0 * i, 200.0 * i + 60.0});
  Listener listener(p);
  feedInOrder(listener.adit, twoRadars(800.0, aircraft));
  listener.adit.finish();
  EXPECT_EQ(listener.confirmed().size(), 4U);
  for (const RecordedUpdate& w : listener.updates) EXPECT_LT(w.number, 3U);
}

// If this fails, a consumer sees a track after its final update, or an update of a track that never started.
TEST_P(BothSets, EachTrackHasOneFirstAndOneLastWord) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(200.0, {{60e3, 20e3, -150.0, 120.0, 0.0, 100.0}, {-60e3, 20e3, 150.0, 120.0}});
  for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 0.8, 0.3, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::map<std::uint32_t, TrackEvent> last;
  for (const RecordedUpdate& w : listener.updates) {
    const bool is_first = last.count(w.uid) == 0;
    EXPECT_EQ(w.event == TrackEvent::kStarted, is_first) << w.uid;
    if (!is_first) {
      EXPECT_NE(last[w.uid], TrackEvent::kDropped) << w.uid;
    }
    last[w.uid] = w.event;
  }
  EXPECT_GT(last.size(), 100U);
  EXPECT_EQ(listener.adit.counts().tracks_started, last.size());
  EXPECT_EQ(listener.adit.counts().tracks_started - listener.adit.counts().tracks_dropped,
            listener.adit.tracks().size());
}

// If this fails, one bad plot spoils good ones or stops the tracker.
TEST_P(BothSets, PlotsThatAreNoNumbersAreLeftOutAndCounted) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const RadarSectors good = twoRadars(150.0, {{60e3, 20e3, -150.0, 120.0}});
  RadarSectors spoilt = good;
  std::uint64_t bad = 0;
  for (auto& sectors : spoilt) {
    for (std::size_t i = 0; i < sectors.size(); i += 5) {
      tws::Plot plot;
      plot.time = i % 4 == 0 ? kNaN : sectors[i].enter_time;
      plot.range = i % 4 == 1 ? kInfinity : (i % 4 == 2 ? -5.0 : 1000.0);
      plot.azimuth = i % 4 == 3 ? kNaN : 1.0;
      sectors[i].plots.insert(sectors[i].plots.begin(), plot);
      ++bad;
    }
  }
  Listener expected(params()), listener(params());
  feedInOrder(expected.adit, good);
  feedInOrder(listener.adit, spoilt);
  EXPECT_EQ(listener.adit.counts().rejected_plots, bad);
  EXPECT_TRUE(listener.bytes() == expected.bytes());
}

// If this fails, one plot in wrong units takes every detection of a sector, or makes false tracks firm ever after.
TEST_P(BothSets, APlotBeyondAllReasonDoesNoHarmToTheOthers) {
  const RadarSectors good = twoRadars(150.0, {{60e3, 20e3, -150.0, 120.0}});
  for (const double range : {1e9, 1e160, 1e300}) {
    RadarSectors spoilt = good;
    tws::Plot plot;
    plot.time = spoilt[0][80].enter_time;
    plot.range = range;
    plot.azimuth = spoilt[0][80].sector * tws::kSectorWidth;
    spoilt[0][80].plots.push_back(plot);
    Listener expected(params()), listener(params());
    feedInOrder(expected.adit, good);
    ASSERT_NO_THROW(feedInOrder(listener.adit, spoilt)) << range;
    EXPECT_EQ(listener.adit.counts().rejected_plots, 1U) << range;
    EXPECT_TRUE(listener.bytes() == expected.bytes()) << range;
  }
}

TEST_P(BothSets, ASectorThatComesAfterAYoungerOneOfItsRadarIsRefusedAndNamed) {
  Adit adit(params(), {});
  const auto sectors = first_.sectors(0.0, 2.0);
  addAndProcess(adit, 0, sectors[5]);
  for (const std::size_t i : {5U, 4U}) {
    try {
      addAndProcess(adit, 0, sectors[i]);
      FAIL() << "taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("radar r0: sector " + std::to_string(i)), std::string::npos)
          << error.what();
    }
  }
  EXPECT_NO_THROW(addAndProcess(adit, 0, sectors[6]));
}

TEST_P(BothSets, DataThatComeTooLateAreUsedAndCounted) {
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  const RadarSectors radars = twoRadars(100.0, {aircraft});
  Listener listener(params());
  for (const auto& sector : radars[0]) addAndProcess(listener.adit, 0, sector);
  for (const auto& sector : radars[1]) addAndProcess(listener.adit, 1, sector);  // 100 s late
  listener.adit.finish();
  EXPECT_GT(listener.adit.counts().late_sectors, 500U);
  EXPECT_EQ(listener.sectors, static_cast<int>(radars[0].size() + radars[1].size()));
}

// If this fails, an overloaded tracker deletes tracks of which it has not looked at the detections, starts false ones,
// or its heartbeat stops. Half a turn is skipped; afterwards each track is seen again on the next turn.
TEST_P(BothSets, SkippedSectorsCostNoTrackAndTheirDetectionsStartNone) {
  const RadarSectors radars = twoRadars(140.0, {{60e3, 20e3, -240.0, 180.0}, {-50e3, 40e3, 200.0, 220.0}});
  Listener listener(params());
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t r = 0; r < radars.size(); ++r) {
    for (std::size_t i = 0; i < radars[r].size(); ++i) order.emplace_back(radars[r][i].leave_time, r, i);
  }
  std::sort(order.begin(), order.end());
  std::set<std::uint32_t> before;
  std::size_t started = 0, ready = 0, updates = 0;
  for (const auto& [time, r, i] : order) {
    listener.adit.add(r, radars[r][i]);
    if (time > 80.0 && time <= 84.0) continue;
    if (time > 84.0 && before.empty()) {
      before = listener.confirmed();
      started = listener.of(TrackEvent::kStarted).size();
      updates = listener.updates.size();
      for (const std::size_t sectors : listener.adit.order().ready()) ready += sectors;
      listener.adit.skip();
      EXPECT_EQ(listener.adit.counts().skipped_sectors, ready);
      EXPECT_EQ(listener.updates.size(), updates);
    }
    while (listener.adit.step()) continue;
  }
  EXPECT_EQ(before.size(), 2U);
  // 4 s are 42 sectors of the one radar and 32 of the other.
  EXPECT_NEAR(static_cast<double>(ready), 74.0, 3.0);
  EXPECT_EQ(listener.sectors, static_cast<int>(listener.adit.counts().sectors));
  EXPECT_EQ(listener.of(TrackEvent::kStarted).size(), started);
  for (const RecordedUpdate& w : listener.of(TrackEvent::kDropped)) EXPECT_EQ(before.count(w.uid), 0U);
  std::map<std::uint32_t, double> seen_again;
  for (const RecordedUpdate& w : listener.of(TrackEvent::kUpdated)) {
    if (w.sector_time > 84.0) seen_again.emplace(w.uid, w.sector_time);
  }
  for (const std::uint32_t uid : before) {
    ASSERT_EQ(seen_again.count(uid), 1U);
    EXPECT_LT(seen_again[uid], 92.5);
  }
}

TEST_P(BothSets, WithoutAListenerItWorksTheSame) {
  const RadarSectors radars = twoRadars(100.0, {{60e3, 20e3, -150.0, 120.0}});
  Adit deaf(params(), {});
  Listener listener(params());
  feedInOrder(deaf, radars);
  feedInOrder(listener.adit, radars);
  EXPECT_EQ(deaf.counts().sectors, listener.adit.counts().sectors);
  EXPECT_EQ(deaf.tracks().size(), listener.adit.tracks().size());
}

TEST(Adit, RefusesParametersThatMakeNoSense) {
  EXPECT_THROW(Adit(AditParams::named("default"), {}), std::invalid_argument);  // No radar.
  AditParams params = paramsFor("default", {6.0});
  params.reference_radar = "other";
  EXPECT_THROW(Adit(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace adit_tracker
