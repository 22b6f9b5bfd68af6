#include "secondary_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <tws_core/random_test_helpers.h>

#include "ssr_test_helpers.h"

namespace track_correlator {
namespace {

const TestSsr kSsr;
const TestAircraft kEastbound{20e3, 60e3, 200.0, 0.0, 04321, 3000.0};

std::vector<SecondarySector> seen(const std::vector<TestAircraft>& fleet, int turns) {
  std::vector<SecondarySector> sectors = kSsr.emptySectors(turns);
  for (const TestAircraft& aircraft : fleet)
    for (int turn = 0; turn <= turns; ++turn) kSsr.put(kSsr.plotOf(aircraft, turn), sectors);
  return sectors;
}

// If this fails, there is no secondary picture.
TEST(SecondaryTracker, MakesOneFirmTrackOfAnAircraftWithItsCodeAndHeight) {
  SsrListener ssr;
  ssr.add(seen({kEastbound}, 10));
  ASSERT_EQ(ssr.tracker.tracks().size(), 1U);
  const SecondaryTrack& track = ssr.tracker.tracks()[0];
  EXPECT_TRUE(track.firm);
  EXPECT_EQ(track.plots, 10);
  EXPECT_EQ(track.mode_3a.value(), 04321);
  EXPECT_EQ(track.height.value(), 3000.0);
  // The plots have no errors, the filter allows for 50 m and 0.1 degrees of 65 km.
  EXPECT_NEAR(track.state.mean(0), kEastbound.xAt(track.time), 50.0);
  EXPECT_NEAR(track.state.mean(1), kEastbound.yAt(track.time), 50.0);
  EXPECT_NEAR(track.state.mean(2), 200.0, 10.0);
  EXPECT_NEAR(track.state.mean(3), 0.0, 10.0);
  const auto updates = ssr.updates();
  EXPECT_FALSE(updates[1].track.firm);
  EXPECT_TRUE(updates[2].track.firm);
}

// If this fails, the correlator waits for sectors that come earlier or later than the paper says (figure 2).
TEST(SecondaryTracker, SaysEverySectorOnceAndTheFixedDelayBehindTheAntenna) {
  for (const int delay : {2, 5}) {
    SecondaryParams params;
    params.delay_sectors = delay;
    SsrListener ssr(params);
    const auto sectors = seen({kEastbound}, 2);
    for (std::size_t n = 0; n < sectors.size(); ++n) {
      ssr.tracker.add(sectors[n]);
      ASSERT_EQ(ssr.reports.size(), n >= static_cast<std::size_t>(delay) ? n + 1 - delay : 0U);
      if (!ssr.reports.empty()) {
        ASSERT_EQ(ssr.reports.back().running, sectors[n].running - delay);
      }
    }
    EXPECT_DOUBLE_EQ(ssr.reports[5].enter_time, sectors[4].leave_time);
  }
}

// If this fails, crossing aircraft swap their codes and with them their identity.
TEST(SecondaryTracker, KeepsTheCodesOfAircraftThatCross) {
  // They meet after 80 s, in the middle.
  const TestAircraft a{-16e3, 40e3 - 800.0, 200.0, 10.0, 01111}, b{16e3, 40e3 - 800.0, -200.0, 10.0, 02222};
  SsrListener ssr;
  ssr.add(seen({a, b}, 20));
  ASSERT_EQ(ssr.tracker.tracks().size(), 2U);
  for (const SecondaryTrack& track : ssr.tracker.tracks()) {
    EXPECT_GE(track.plots, 19);
    EXPECT_NEAR(track.state.mean(2), track.mode_3a.value() == 01111 ? 200.0 : -200.0, 10.0);
  }
}

// If this fails, garbled replies lose the aircraft's identity just where the correlator needs it.
TEST(SecondaryTracker, MendsGarbledCodesSilently) {
  const TestAircraft a{10e3, 50e3, 200.0, 0.0, 00421}, b{10e3, 50.6e3, 200.0, 0.0, 01310};
  std::vector<SecondarySector> sectors = seen({a, b}, 12);
  for (std::size_t n = 4 * 64; n < 9 * 64; ++n)
    for (SecondaryPlot& plot : sectors[n].plots) plot.mode_3a.code = 00421 | 01310;
  SsrListener ssr;
  ssr.add(sectors);
  ASSERT_EQ(ssr.tracker.tracks().size(), 2U);
  EXPECT_EQ(ssr.tracker.counts().mended_codes, 10U);  // Two aircraft in five turns.
  for (const SecondaryTrack& track : ssr.tracker.tracks())
    EXPECT_EQ(track.mode_3a.value(), track.state.mean(1) < 50.3e3 ? 00421 : 01310);
}

// If this fails, a track follows a code that the radar itself called bad.
TEST(SecondaryTracker, MendsCodesThatTheRadarCallsGarbled) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 10);
  for (std::size_t n = 3 * 64; n < 8 * 64; ++n)
    for (SecondaryPlot& plot : sectors[n].plots) plot.mode_3a = {01234, true};
  SsrListener ssr;
  ssr.add(sectors);
  ASSERT_EQ(ssr.tracker.tracks().size(), 1U);
  EXPECT_EQ(ssr.tracker.tracks()[0].mode_3a.value(), 04321);
  EXPECT_EQ(ssr.tracker.counts().mended_codes, 5U);
}

// If this fails, an aircraft whose pilot dials a new code shows as two.
TEST(SecondaryTracker, StaysWithAnAircraftThatChangesItsCode) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 12);
  for (std::size_t n = 6 * 64; n < sectors.size(); ++n)
    for (SecondaryPlot& plot : sectors[n].plots) plot.mode_3a.code = 07000;
  SsrListener ssr;
  ssr.add(sectors);
  ASSERT_EQ(ssr.tracks().size(), 1U);
  const auto updates = ssr.updates();
  EXPECT_EQ(updates[7].track.mode_3a.value(), 04321);
  EXPECT_EQ(updates[8].track.mode_3a.value(), 07000);
}

// If this fails, a fade costs the track, or an aircraft that has landed stays for ever.
TEST(SecondaryTracker, CoastsFourScansAndDropsAtTheFifth) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 20);
  for (std::size_t n = 5 * 64; n < sectors.size(); ++n) {
    if (n < 9 * 64 || n >= 12 * 64) sectors[n].plots.clear();  // Turns 5 to 8, and from 12 on.
  }
  SsrListener ssr;
  ssr.add(sectors);
  std::string story;
  for (const SecondaryUpdate& update : ssr.updates())
    story += update.event == SecondaryEvent::kUpdated ? 'u' : update.event == SecondaryEvent::kCoasted ? 'c' : 'd';
  EXPECT_EQ(story, "uuuuuccccuuuccccd");
  EXPECT_EQ(ssr.tracks().size(), 1U);
  EXPECT_EQ(ssr.tracker.counts().dropped_tracks, 1U);
}

// If this fails, every FRUIT reply leaves a track behind.
TEST(SecondaryTracker, DropsALoneReplyAfterTwoScans) {
  std::vector<SecondarySector> sectors = seen({}, 5);
  kSsr.put(kSsr.plotOf(kEastbound, 0), sectors);
  SsrListener ssr;
  ssr.add(sectors);
  const auto updates = ssr.updates();
  ASSERT_EQ(updates.size(), 3U);
  EXPECT_EQ(updates[2].event, SecondaryEvent::kDropped);
  EXPECT_FALSE(updates[2].track.firm);
}

// If this fails, an aircraft near north is updated twice in a turn, or not at all.
TEST(SecondaryTracker, UpdatesOnceATurnAlsoAcrossNorthInBothDirections) {
  for (const double speed : {250.0, -250.0}) {
    const TestAircraft aircraft{-100.0 * speed, 30e3, speed, 0.0, 01000};
    SsrListener ssr;
    ssr.add(seen({aircraft}, 30));
    EXPECT_EQ(ssr.tracks().size(), 1U);
    for (const SecondaryUpdate& update : ssr.updates()) EXPECT_EQ(update.event, SecondaryEvent::kUpdated);
  }
}

// If this fails, a reply that the radar has cut in two makes a second aircraft.
TEST(SecondaryTracker, MakesNoSecondTrackOfASplitPlot) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 10);
  for (auto& sector : sectors) {
    if (sector.plots.empty() || sector.running < 3 * 64) continue;
    SecondaryPlot twin = sector.plots[0];
    twin.range += 120.0;
    sector.plots.push_back(twin);
  }
  SsrListener ssr;
  ssr.add(sectors);
  EXPECT_EQ(ssr.tracks().size(), 1U);
  EXPECT_EQ(ssr.tracker.counts().split_plots, 7U);
}

// If this fails, sectors full of jamming take seconds each, for each plot starts a track.
TEST(SecondaryTracker, AFloodOfPlotsStartsNoTracksAndLosesNone) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 8);
  const auto full =
      std::find_if(sectors.begin() + 4 * 64, sectors.end(), [](const auto& s) { return !s.plots.empty(); });
  ASSERT_NE(full, sectors.end());
  const SecondaryPlot real = full->plots.front();
  for (int i = 0; i < 20000; ++i) {
    SecondaryPlot plot = real;
    plot.range = 20e3 + 5.0 * i;
    plot.mode_3a.code = static_cast<std::uint16_t>(i % 4096);
    full->plots.push_back(plot);
  }
  SsrListener ssr;
  ssr.add(sectors);
  EXPECT_EQ(ssr.tracks().size(), 1U);
  EXPECT_GE(ssr.tracker.counts().crowded_plots, 19990U);
}

// If this fails, a feed that stops for a while mixes up the turns.
TEST(SecondaryTracker, FillsAGapAndBeginsAnewBehindALongOne) {
  std::vector<SecondarySector> sectors = seen({kEastbound}, 30);
  std::vector<SecondarySector> gap = sectors;
  gap.erase(gap.begin() + 5 * 64, gap.begin() + 7 * 64);
  SsrListener ssr;
  ssr.add(gap);
  EXPECT_EQ(ssr.tracks().size(), 1U);
  EXPECT_EQ(ssr.tracker.counts().lost_sectors, 128U);
  EXPECT_EQ(ssr.reports.size(), 30U * 64 - 2);

  gap = sectors;
  gap.erase(gap.begin() + 5 * 64, gap.begin() + 14 * 64);
  SsrListener other;
  other.add(gap);
  EXPECT_EQ(other.tracks().size(), 2U);
  EXPECT_EQ(other.tracker.counts().lost_sectors, 0U);
  int dropped = 0;
  for (const SecondaryUpdate& update : other.updates()) dropped += update.event == SecondaryEvent::kDropped;
  EXPECT_EQ(dropped, 1);
}

// If this fails, all tracks end when a radar comes back at another phase, or its clock is set.
TEST(SecondaryTracker, KeepsItsTracksWhereTheBeamBreaks) {
  for (const double pause : {0.0, 10.0}) {
    std::vector<SecondarySector> sectors = kSsr.emptySectors(20);
    for (int turn = 0; turn < 10; ++turn) kSsr.put(kSsr.plotOf(kEastbound, turn), sectors);
    SsrListener ssr;
    ssr.add({sectors.begin(), sectors.begin() + 10 * 64});
    // From then on the beam is 23 sectors further than it would have been, and the count a turn.
    const double later = pause - 23 * kSsr.sectorTime();
    for (int turn = 10; turn < 20; ++turn) {
      TestAircraft moved = kEastbound;
      moved.x += later * moved.vx;
      SecondaryPlot plot = kSsr.plotOf(moved, turn);
      kSsr.put(plot, sectors);
    }
    for (std::size_t n = 10 * 64 + 23; n < sectors.size(); ++n) {
      SecondarySector sector = sectors[n];
      sector.running += 2 * 64;
      sector.leave_time += later;
      for (SecondaryPlot& plot : sector.plots) plot.time += later;
      ssr.tracker.add(sector);
    }
    EXPECT_EQ(ssr.tracks().size(), 1U) << pause;
    EXPECT_EQ(ssr.tracker.counts().lost_sectors, 0U) << pause;
    for (const SecondaryUpdate& update : ssr.updates()) EXPECT_EQ(update.event, SecondaryEvent::kUpdated) << pause;
  }
}

TEST(SecondaryTracker, LeavesOutASectorThatComesTwice) {
  SsrListener ssr;
  for (const auto& sector : seen({kEastbound}, 10)) {
    ssr.tracker.add(sector);
    ssr.tracker.add(sector);
  }
  EXPECT_EQ(ssr.tracker.counts().late_sectors, 640U);
  ASSERT_EQ(ssr.tracker.tracks().size(), 1U);
  EXPECT_EQ(ssr.tracker.tracks()[0].plots, 10);
}

// If this fails, two runs on the same recording differ.
TEST(SecondaryTracker, SaysTheSameWhateverTheOrderOfThePlotsOfASector) {
  auto generator = tws::seededGenerator();
  std::vector<TestAircraft> fleet;
  for (int i = 0; i < 150; ++i) {  // Dense, and few codes: much is ambiguous.
    fleet.push_back({tws::uniform(generator, -20e3, 20e3), tws::uniform(generator, -20e3, 20e3),
                     tws::uniform(generator, -250.0, 250.0), tws::uniform(generator, -250.0, 250.0),
                     static_cast<std::uint16_t>(tws::uniformInt(generator, 0, 40)), 3000.0});
  }
  const std::vector<SecondarySector> sectors = seen(fleet, 12);
  SsrListener first, second;
  first.add(sectors);
  auto shuffled = sectors;
  for (auto& sector : shuffled) std::shuffle(sector.plots.begin(), sector.plots.end(), generator);
  second.add(shuffled);
  const auto a = first.updates(), b = second.updates();
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 150U * 10);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].track.uid, b[i].track.uid);
    ASSERT_EQ(a[i].event, b[i].event);
    ASSERT_EQ(a[i].track.state.mean, b[i].track.state.mean);
    ASSERT_EQ(a[i].track.mode_3a.value(), b[i].track.mode_3a.value());
  }
}

TEST(SecondaryTracker, RefusesParametersThatMakeNoSense) {
  SecondaryParams params;
  params.delay_sectors = 1;
  EXPECT_THROW(SecondaryTracker(params, [](const SecondaryReport&) {}), std::invalid_argument);
  params = {};
  params.range_sigma = 0.0;
  EXPECT_THROW(SecondaryTracker(params, [](const SecondaryReport&) {}), std::invalid_argument);
}

}  // namespace
}  // namespace track_correlator
