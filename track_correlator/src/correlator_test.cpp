#include "correlator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include <tws_core/random_test_helpers.h>

#include "correlator_test_helpers.h"

namespace track_correlator {
namespace {

constexpr std::uint32_t kP = 70, kS = 100, kNewS = 120;

/// Adds an aircraft at (x, y) whose tracks have these uids; kNoTrack: none.
void tell(CorrelatorListener& c, std::uint32_t primary, std::uint32_t secondary, double x = 20e3, double y = 30e3) {
  const double t = c.now();
  if (primary != kNoTrack) c.correlator.addPrimary(trackInput(primary, t, x, y, 100.0, 0.0));
  if (secondary != kNoTrack) c.correlator.addSecondary(trackInput(secondary, t, x + 40.0, y - 30.0, 98.0, 3.0));
}

TrackInput finalUpdate(std::uint32_t uid) {
  TrackInput track;
  track.uid = uid;
  track.dropped = true;
  return track;
}

/// One letter a turn: C correlated, c coasting, B both alone, P and S one of them alone, - nothing; e an identity ends.
std::string storyOf(CorrelatorListener& c, int turns, const std::function<void(int)>& before) {
  std::string story;
  for (int turn = 0; turn < turns; ++turn) {
    before(turn);
    c.turn();
    bool p = false, s = false, pair = false, coasting = false;
    for (const CorrelatedUpdate& w : c.lastTurn()) {
      if (w.ended) {
        story += 'e';
      } else {
        pair |= w.correlated;
        coasting |= w.coasting;
        p |= !w.correlated && w.primary != kNoTrack;
        s |= !w.correlated && w.secondary != kNoTrack;
      }
    }
    story += coasting ? 'c' : pair ? 'C' : p && s ? 'B' : p ? 'P' : s ? 'S' : '-';
  }
  return story;
}

CorrelatorParams with(Scheme scheme) {
  CorrelatorParams params;
  params.fusion.scheme = scheme;
  return params;
}

// If this fails, the two radars show one aircraft as two.
TEST(Correlator, MakesOneOfTwoInTheThirdScanAndEndsTheYoungerIdentity) {
  CorrelatorListener c;
  EXPECT_EQ(storyOf(c, 5, [&](int) { tell(c, kP, kS); }), "BBeCCC");
  std::set<std::uint32_t> identities;
  for (const auto& update : c.lastTurn()) identities.insert(update.identity);
  EXPECT_EQ(identities, (std::set<std::uint32_t>{1}));
  EXPECT_EQ(c.lastTurn().size(), 1U);
  EXPECT_EQ(c.lastTurn()[0].fusion_count, 5);
}

TEST(Correlator, LeavesApartWhatIsApart) {
  CorrelatorListener c;
  EXPECT_EQ(storyOf(c, 4,
                    [&](int) {
                      tell(c, kP, kNoTrack);
                      tell(c, kNoTrack, kS, 22e3);
                    }),
            "BBBB");
}

// Same place, other velocity: an overtaking or crossing aircraft.
TEST(Correlator, DistinguishesTracksByVelocity) {
  CorrelatorListener c;
  EXPECT_EQ(storyOf(c, 4,
                    [&](int) {
                      c.correlator.addPrimary(trackInput(kP, c.now(), 20e3, 30e3, 100.0, 0.0));
                      c.correlator.addSecondary(trackInput(kS, c.now(), 20e3, 30e3, -100.0, 0.0));
                    }),
            "BBBB");
}

// The paper: m1 + m2 = 7 scans when the secondary comes back under another number, 3 with the parallel counter.
TEST(Correlator, NeedsSevenScansForANewSecondaryInThePlainScheme) {
  CorrelatorListener c(with(Scheme::kPlain));
  const std::string story = storyOf(c, 20, [&](int turn) {
    if (turn == 10) c.correlator.addSecondary(finalUpdate(kS));
    tell(c, kP, turn < 10 ? kS : kNewS);
  });
  EXPECT_EQ(story,
            "BBeCCCCCCCCccccBBeCCCC");  // Scans 11 to 17 after ten.
}

TEST(Correlator, NeedsThreeScansForANewSecondaryWithTheParallelCounter) {
  CorrelatorListener c;
  const std::string story = storyOf(c, 16, [&](int turn) {
    if (turn == 10) c.correlator.addSecondary(finalUpdate(kS));
    tell(c, kP, turn < 10 ? kS : kNewS);
  });
  EXPECT_EQ(story, "BBeCCCCCCCCcceCCCC");
  for (const auto& update : c.lastTurn()) EXPECT_EQ(update.identity, 1U);
}

// If this fails, the label jumps when one of the radars loses the aircraft.
TEST(Correlator, KeepsTheIdentityWhileEitherRadarSeesTheAircraft) {
  for (const bool primary_first : {true, false}) {
    CorrelatorListener c;
    const auto story = storyOf(c, 34, [&](int turn) {
      const bool p = primary_first ? turn < 10 || turn >= 20 : turn < 20, s = primary_first ? turn < 20 : turn < 10;
      if (turn == 10 && primary_first) c.correlator.addPrimary(finalUpdate(kP));
      if (turn == 10 && !primary_first) c.correlator.addSecondary(finalUpdate(kS));
      tell(c,
           p || turn >= 20 ? (turn < 20       ? kP
                              : primary_first ? kP + 1
                                              : kP)
                           : kNoTrack,
           s || turn >= 20 ? (turn < 20       ? kS
                              : primary_first ? kS
                                              : kNewS)
                           : kNoTrack);
    });
    std::set<std::uint32_t> correlated;
    for (const auto& update : c.updates())
      if (update.correlated && !update.ended) correlated.insert(update.identity);
    EXPECT_EQ(correlated, (std::set<std::uint32_t>{1})) << story;
    EXPECT_EQ(story.substr(0, 15), std::string("BBeCCCCCCCC") + "cccc");
    EXPECT_EQ(story[15], primary_first ? 'S' : 'P');
    EXPECT_EQ(story.back(), 'C');
  }
}

TEST(Correlator, PublishesAFinalUpdateWhenBothAreDeleted) {
  CorrelatorListener c;
  EXPECT_EQ(storyOf(c, 8,
                    [&](int turn) {
                      if (turn < 5) tell(c, kP, kS);
                      if (turn == 5) c.correlator.addPrimary(finalUpdate(kP));
                      if (turn == 6) c.correlator.addSecondary(finalUpdate(kS));
                    }),
            "BBeCCCce--");
}

// Figure 8, the ambiguity: P1 is 28 m from S1 and 25 m from S2, and P2 is nearer to S1. History outranks distance;
// without it the pairs are swapped.
TEST(Correlator, HoldsThePairsOfTheTableWhereOthersAreNearer) {
  for (const Scheme scheme : {Scheme::kParallelCounter, Scheme::kPlain, Scheme::kDistance}) {
    CorrelatorListener c(with(scheme));
    for (int turn = 0; turn < 8; ++turn) {
      const auto at = [&](double x) { return 20e3 + x; };
      const bool apart = turn < 5;
      const double t = c.now();
      c.correlator.addPrimary(trackInput(1, t, at(0.0), 30e3, 0.0, 0.0, 8.0));
      c.correlator.addSecondary(trackInput(11, t, at(28.0), 30e3, 0.0, 0.0, 8.0));
      c.correlator.addPrimary(trackInput(2, t, at(apart ? 3000.0 : 20.0), 30e3, 0.0, 0.0, 8.0));
      c.correlator.addSecondary(trackInput(12, t, at(apart ? 3000.0 : -25.0), 30e3, 0.0, 0.0, 8.0));
      c.turn();
    }
    std::map<std::uint32_t, std::uint32_t> partner;
    for (const auto& update : c.lastTurn())
      if (update.correlated && !update.ended) partner[update.primary] = update.secondary;
    const bool history = scheme != Scheme::kDistance;
    EXPECT_EQ(partner[1], history ? 11U : 12U);
    EXPECT_EQ(partner[2], history ? 12U : 11U);
  }
}

TEST(Correlator, HoldsAPairBeyondTheGateAndReleasesItBeyondTheReleaseDistance) {
  for (const double limit : {3000.0, 0.0}) {
    CorrelatorParams params;
    params.release_distance = limit;
    CorrelatorListener c(params);
    const std::string story = storyOf(c, 12, [&](int turn) {
      tell(c, kP, turn < 5 ? kS : kNoTrack);
      if (turn >= 5) tell(c, kNoTrack, kS, turn < 8 ? 22e3 : 24e3);
    });
    EXPECT_EQ(story, limit > 0.0 ? "BBeCCCCCCCCBB" : "BBeCCCCCCCCCC");
  }
}

// If this fails, aircraft whose tracks lie on both sides of a sector's border, or of north, are never correlated.
TEST(Correlator, CorrelatesAcrossSectorBordersAndNorth) {
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    CorrelatorListener c;
    const double a = tws::sectorStart(sector);
    for (int turn = 0; turn < 4; ++turn) {
      const double t = c.now();
      c.correlator.addPrimary(trackInput(1, t, 20e3 * std::sin(a + 2e-3), 20e3 * std::cos(a + 2e-3), 0.0, 0.0));
      c.correlator.addSecondary(trackInput(2, t, 20e3 * std::sin(a - 2e-3), 20e3 * std::cos(a - 2e-3), 0.0, 0.0));
      c.turn();
    }
    c.turn();
    EXPECT_EQ(c.correlator.counts().initiated, 1U) << sector;
  }
}

// A secondary serves one primary a scan; two primaries in neighbouring sectors want it, and the nearer one gets it.
TEST(Correlator, GivesASecondaryToOnePrimaryAScanAcrossBorders) {
  CorrelatorListener c;
  const double a = tws::sectorStart(10);
  for (int turn = 0; turn < 5; ++turn) {
    const double t = c.now();
    const auto at = [&](double offset) {
      return std::make_pair(20e3 * std::sin(a + offset), 20e3 * std::cos(a + offset));
    };
    const auto [x1, y1] = at(-8e-3);
    const auto [x2, y2] = at(2e-3);
    const auto [xs, ys] = at(-1e-3);
    c.correlator.addPrimary(trackInput(1, t, x1, y1, 0.0, 0.0));
    c.correlator.addPrimary(trackInput(2, t, x2, y2, 0.0, 0.0));
    c.correlator.addSecondary(trackInput(9, t, xs, ys, 0.0, 0.0));
    c.turn();
  }
  for (const auto& update : c.lastTurn()) {
    if (update.ended) continue;
    EXPECT_EQ(update.secondary, update.primary == 2 ? 9U : kNoTrack);
  }
}

TEST(Correlator, SaysEveryTrackOnceATurnTheFixedDelayBehindTheClock) {
  CorrelatorListener c;
  for (int turn = 0; turn < 3; ++turn) {
    tell(c, kP, kS);
    tell(c, kP + 1, kNoTrack, -20e3, -10e3);
    c.turn();
  }
  ASSERT_EQ(c.reports.size(), 3U * 64 - 2);
  for (std::size_t i = 0; i < c.reports.size(); ++i) EXPECT_EQ(c.reports[i].running, static_cast<std::int64_t>(i));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> said;
  for (const auto& update : c.updates()) ++said[{update.primary, update.secondary}];
  EXPECT_EQ((said[{kP + 1, kNoTrack}]), 3);
}

// If this fails, a tracker that dies leaves its picture standing.
TEST(Correlator, LosesTracksWithoutUpdates) {
  CorrelatorParams params;
  params.track_timeout = 6.5;
  CorrelatorListener c(params);
  const std::string story = storyOf(c, 16, [&](int turn) {
    if (turn < 4) tell(c, kP, kS);
    if (turn >= 4) tell(c, kP, kNoTrack);
  });
  EXPECT_EQ(c.correlator.counts().silent_tracks, 1U);
  EXPECT_EQ(story.back(), 'P');
}

TEST(Correlator, FillsMissingMarksAndRefusesOneOutlier) {
  CorrelatorListener c;
  tell(c, kP, kS);
  c.turn();
  c.next_mark += 30;
  c.turn();
  EXPECT_EQ(c.correlator.counts().lost_marks, 30U);
  EXPECT_EQ(c.reports.size(), 158U - 2);
  c.correlator.addMark(1000000, c.now());
  EXPECT_EQ(c.correlator.counts().stray_marks, 1U);
  c.turn();
  EXPECT_EQ(c.reports.size(), 222U - 2);
}

// The paper's table 1 setting in small: a dense swarm; two runs with the tracks in another order give the same.
TEST(Correlator, GivesTheSameInWhateverOrderTheTracksOfAScanCome) {
  auto generator = tws::seededGenerator();
  std::vector<std::pair<bool, TrackInput>> tracks;
  for (std::uint32_t i = 0; i < 120; ++i) {
    const double x = tws::uniform(generator, -6e3, 6e3), y = tws::uniform(generator, -6e3, 6e3);
    const double vx = tws::uniform(generator, -60.0, 60.0), vy = tws::uniform(generator, -60.0, 60.0);
    tracks.emplace_back(true, trackInput(i, 0.0, x, y, vx, vy, 150.0, 30.0));
    tracks.emplace_back(false, trackInput(500 - i, 0.0, x + tws::uniform(generator, -300.0, 300.0), y, vx, vy, 150.0));
  }
  std::vector<std::vector<CorrelatedUpdate>> said;
  for (int run = 0; run < 2; ++run) {
    CorrelatorListener c;
    for (int turn = 0; turn < 12; ++turn) {
      auto shuffled = tracks;
      if (run == 1) std::shuffle(shuffled.begin(), shuffled.end(), generator);
      for (auto& [primary, track] : shuffled) {
        track.state.head<2>() += c.now() * track.state.tail<2>();
        track.time = c.now();
        primary ? c.correlator.addPrimary(track) : c.correlator.addSecondary(track);
      }
      c.turn();
    }
    EXPECT_GT(c.correlator.counts().clusters, 0U);
    EXPECT_GT(c.correlator.counts().initiated, 50U);
    said.push_back(c.updates());
  }
  ASSERT_EQ(said[0].size(), said[1].size());
  for (std::size_t i = 0; i < said[0].size(); ++i) {
    ASSERT_EQ(said[0][i].identity, said[1][i].identity);
    ASSERT_EQ(said[0][i].primary, said[1][i].primary);
    ASSERT_EQ(said[0][i].secondary, said[1][i].secondary);
    ASSERT_EQ(said[0][i].fusion_count, said[1][i].fusion_count);
  }
}

TEST(Correlator, RefusesParametersThatMakeNoSense) {
  CorrelatorParams params;
  params.delay_sectors = 1;
  EXPECT_THROW(Correlator(params, [](const CorrelatorReport&) {}), std::invalid_argument);
  params = {};
  params.fusion.clear_scans = 0;
  EXPECT_THROW(Correlator(params, [](const CorrelatorReport&) {}), std::invalid_argument);
}

}  // namespace
}  // namespace track_correlator
