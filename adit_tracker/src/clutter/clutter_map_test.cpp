#include "clutter/clutter_map.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kSector = tws::kSectorWidth;

RadarState radarWithPeriod(double period) {
  RadarParams params;
  params.name = "sps12";
  params.period = period;
  return RadarState(params, false);
}

/// A map with radars of 6.4 s a turn, so that a sector takes 0.1 s and turn n starts at 6.4 n.
class ClutterMapTest : public testing::Test {
 protected:
  explicit ClutterMapTest(const std::string& set = "nrl7952") : params_(AditParams::named(set)), map_(params_) {}

  static double enter(std::int64_t running) { return 0.1 * static_cast<double>(running); }

  /// The beam of a radar has crossed this sector with these plots.
  void see(std::int64_t running, const std::vector<tws::Plot>& plots, std::size_t radar = 0) {
    tws::RadarSector sector;
    sector.running = running;
    sector.plots = plots;
    radars_[radar].detections.add(sector);
  }

  std::vector<ClutterPoint> process(std::int64_t running, std::size_t radar = 0,
                                    std::optional<double> judge_after = std::nullopt) {
    return map_.process(radar, radars_[radar], running, enter(running + 1), judge_after);
  }

  const Detection& detection(std::int64_t running, std::size_t i = 0, std::size_t radar = 0) {
    return radars_[radar].detections.at(running).detections.at(i);
  }

  AditParams params_;
  ClutterMap map_;
  std::vector<RadarState> radars_{radarWithPeriod(6.4), radarWithPeriod(6.4)};
};

// If this fails, clutter becomes tracks.
TEST_F(ClutterMapTest, TheLetterTakesADetectionOutOnTheNextScanAndTakesOverItsPosition) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  see(64 + 10, {plotAt(7.45, 50.3e3, 10.4 * kSector)});
  process(64 + 10);
  EXPECT_TRUE(detection(64 + 10).used);
  ASSERT_EQ(map_.points().size(), 1U);
  EXPECT_DOUBLE_EQ(map_.points()[0].range, 50.3e3);
  EXPECT_NEAR(map_.points()[0].azimuth, 10.4 * kSector, 1e-12);
  EXPECT_EQ(map_.absorbed(), 1U);
}

// 2000 ft = 609.6 m; 1.4° = 0.2489 sectors.
TEST_F(ClutterMapTest, TheLettersRegionIs2000FeetBy1Point4Degrees) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  see(64 + 10, {plotAt(7.45, 50e3 + 610.0, 10.5 * kSector), plotAt(7.45, 50e3, 10.5 * kSector + tws::radians(1.41))});
  process(64 + 10);
  EXPECT_FALSE(detection(64 + 10, 0).used);
  EXPECT_FALSE(detection(64 + 10, 1).used);
  see(128 + 10, {plotAt(13.85, 50e3 - 609.0, 10.5 * kSector - tws::radians(1.39))});
  process(128 + 10);
  EXPECT_TRUE(detection(128 + 10).used);
}

// DI = 4·DELR/62.5 ft + DELA/0.010986°: 100 m are 21.0, 0.5° are 45.5, 200 m and 0.02° are 43.8.
TEST_F(ClutterMapTest, TakesTheDetectionWithTheLeastEffectiveDistance) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  see(64 + 10, {plotAt(7.45, 50e3, 10.5 * kSector + tws::radians(0.5)),
                plotAt(7.45, 50.2e3, 10.5 * kSector + tws::radians(0.02)), plotAt(7.45, 50.1e3, 10.5 * kSector)});
  process(64 + 10);  // The file is in order of range.
  EXPECT_FALSE(detection(64 + 10, 0).used);
  EXPECT_TRUE(detection(64 + 10, 1).used);
  EXPECT_FALSE(detection(64 + 10, 2).used);
}

// If this fails, clutter at a sector border is tracked whenever its detection falls on the other side.
TEST_F(ClutterMapTest, LooksIntoBothNeighbouringSectorsAlsoAcrossNorth) {
  ASSERT_TRUE(map_.initiate(plotAt(6.39, 50e3, 63.9 * kSector), 0));
  ASSERT_TRUE(map_.initiate(plotAt(6.45, 80e3, 0.1 * kSector), 0));
  see(127, {plotAt(12.79, 80e3, -0.05 * kSector)});  // Of the point in sector 0.
  see(128, {plotAt(12.81, 50e3, 0.05 * kSector)});   // Of the point in sector 63.
  process(127);
  process(128);
  EXPECT_TRUE(detection(127).used);
  EXPECT_TRUE(detection(128).used);
  EXPECT_EQ(map_.absorbed(), 2U);
}

TEST_F(ClutterMapTest, LooksNoFurtherThanTheNeighbouringSectors) {
  params_.clutter.gate.azimuth = kSector;
  ClutterMap wide(params_);
  ASSERT_TRUE(wide.initiate(plotAt(1.05, 50e3, 10.95 * kSector), 0));
  see(64 + 12, {plotAt(7.6, 50e3, 11.9 * kSector)});  // Within the region, but the beam was two sectors on.
  wide.process(0, radars_[0], 64 + 10, enter(64 + 11), std::nullopt);
  EXPECT_FALSE(detection(64 + 12).used);
}

// TCMAX = 40 s.
TEST_F(ClutterMapTest, DropsAPointThatNoRadarHasSeenFor40Seconds) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  process(6 * 64 + 10);  // At 39.5 s.
  EXPECT_EQ(map_.size(), 1U);
  process(6 * 64 + 10 + 64);
  EXPECT_EQ(map_.size(), 0U);
}

TEST_F(ClutterMapTest, KeepsAPointThatTheOtherRadarStillSees) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  for (int turn = 1; turn < 9; ++turn) {
    see(64 * turn + 10, {plotAt(6.4 * turn + 1.05, 50e3, 10.5 * kSector)}, 1);
    process(64 * turn + 10, 1);
    process(64 * turn + 10, 0);
  }
  ASSERT_EQ(map_.size(), 1U);
  EXPECT_EQ(map_.absorbed(), 8U);
  EXPECT_NEAR(map_.points()[0].updated[0], 1.05, 1e-9);
  EXPECT_NEAR(map_.points()[0].updated[1], 6.4 * 8 + 1.05, 1e-9);
}

// If this fails, a point that moves into the next sector takes two detections on one scan, the second an aircraft's.
TEST_F(ClutterMapTest, UpdatesAPointOnlyOnceAScanWhenItChangesSectors) {
  ASSERT_TRUE(map_.initiate(plotAt(1.09, 50e3, 10.95 * kSector), 0));
  see(64 + 10, {});
  see(64 + 11, {plotAt(7.51, 50e3, 11.05 * kSector), plotAt(7.51, 50.3e3, 11.05 * kSector)});
  process(64 + 10);
  process(64 + 11);
  EXPECT_EQ(map_.absorbed(), 1U);
  EXPECT_FALSE(detection(64 + 11, 1).used);
  see(128 + 11, {plotAt(13.91, 50e3, 11.05 * kSector)});
  process(128 + 11);
  EXPECT_EQ(map_.absorbed(), 2U);
}

// If this fails, the clutter of a radar that turns faster than once a second leaks through on most scans.
TEST_F(ClutterMapTest, UpdatesAPointOnEveryScanOfAFastRadar) {
  radars_[0] = radarWithPeriod(0.64);
  ASSERT_TRUE(map_.initiate(plotAt(0.105, 50e3, 10.5 * kSector), 0));
  for (int turn = 1; turn < 6; ++turn) {
    const std::int64_t running = 64 * turn + 10;
    see(running, {plotAt(0.01 * static_cast<double>(running) + 0.005, 50e3, 10.5 * kSector)});
    map_.process(0, radars_[0], running, 0.01 * static_cast<double>(running + 1), std::nullopt);
  }
  EXPECT_EQ(map_.absorbed(), 5U);
}

// If this fails, the radar operator loses all clutter beyond the map's capacity to tracks, and is not told.
TEST_F(ClutterMapTest, RefusesAPointWhenItIsFull) {
  for (int i = 0; i < 255; ++i) ASSERT_TRUE(map_.initiate(plotAt(0.0, 10e3 + i, 1.0), 0));
  EXPECT_FALSE(map_.initiate(plotAt(0.0, 10e3, 1.0), 0));
  EXPECT_EQ(map_.size(), 255U);
}

// 45 kn are 23.15 m/s: over 51.2 s 1185 m. The range moves by 8 · 150 m = 1200 m, and by 8 · 145 m = 1160 m.
TEST_F(ClutterMapTest, GivesBackAPointThatMovesFasterThan45KnotsInRange) {
  for (const double step : {145.0, 150.0}) {
    ClutterMap map(params_);
    ASSERT_TRUE(map.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
    std::size_t moving = 0;
    for (int turn = 1; turn <= 16; ++turn) {
      see(64 * turn + 10, {plotAt(6.4 * turn + 1.05, 50e3 + step * turn, 10.5 * kSector)});
      const auto judge = turn % 8 == 0 ? std::optional<double>(25.6) : std::nullopt;
      moving += map.process(0, radars_[0], 64 * turn + 10, enter(64 * turn + 11), judge).size();
    }
    EXPECT_EQ(moving, step > 147.0 ? 1U : 0U) << step;
    EXPECT_EQ(map.size(), step > 147.0 ? 0U : 1U) << step;
  }
}

// If this fails, an aircraft that passes abeam stays in the clutter map (VAMIN).
TEST_F(ClutterMapTest, GivesBackAPointThatMovesInAzimuthOnly) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.1 * kSector), 0));
  std::size_t moving = 0;
  for (int turn = 1; turn <= 16; ++turn) {
    // 0.2° a scan of 6.4 s: 0.031 °/s, more than 100 LSB = 0.0244 °/s. It enters sector 11 on the way.
    const double azimuth = 10.1 * kSector + tws::radians(0.2) * turn;
    const std::int64_t running = 64 * turn + tws::sectorOf(azimuth);
    see(running, {plotAt(enter(running) + 0.05, 50e3, azimuth)});
    for (const std::int64_t sector : {64 * turn + 10, 64 * turn + 11}) {
      moving += process(sector, 0, turn % 8 == 0 ? std::optional<double>(25.6) : std::nullopt).size();
    }
  }
  EXPECT_EQ(moving, 1U);
}

TEST_F(ClutterMapTest, AdoptsASlowTrackAsAPointThatAbsorbsAtOnce) {
  ASSERT_TRUE(map_.adopt(50e3, 10.5 * kSector, 1.05, 0));
  see(64 + 10, {plotAt(7.45, 50e3, 10.5 * kSector)});
  process(64 + 10);
  EXPECT_TRUE(detection(64 + 10).used);
}

// If this fails, what was known of the clutter is of no use for the first turns.
TEST_F(ClutterMapTest, WhatIsLoadedAbsorbsAtOnceWhereverTheBeamIs) {
  EXPECT_EQ(map_.load({{"", 50e3, 10.5 * kSector}}, 7.0, radars_[0].quality), 0U);
  see(64 + 10, {plotAt(7.45, 50e3, 10.5 * kSector)});
  process(64 + 10);
  EXPECT_TRUE(detection(64 + 10).used);
}

TEST_F(ClutterMapTest, WhatIsLoadedIsForgottenAfterFortySecondsFromThen) {
  EXPECT_EQ(map_.load({{"", 50e3, 10.5 * kSector}}, 7.0, radars_[0].quality), 0U);
  process(64 * 7 + 10);  // 45.9 s
  EXPECT_EQ(map_.size(), 1U);
  process(64 * 7 + 20);
  EXPECT_EQ(map_.size(), 1U);
  process(64 * 8 + 10);  // 52.3 s
  EXPECT_EQ(map_.size(), 0U);
}

// If this fails, each loading adds the same points once more, until all numbers are in use.
TEST_F(ClutterMapTest, WhatIsLoadedTwiceIsThereOnceAndNeighboursStayTwo) {
  const std::vector<ClutterPlace> places = {{"", 50e3, 10.999 * kSector}, {"", 50.3e3, 11.001 * kSector}};
  for (int time = 1; time <= 3; ++time) EXPECT_EQ(map_.load(places, time, radars_[0].quality), 0U);
  ASSERT_EQ(map_.size(), 2U);
  EXPECT_DOUBLE_EQ(map_.points()[0].range, 50e3);
  EXPECT_DOUBLE_EQ(map_.points()[1].range, 50.3e3);
  EXPECT_DOUBLE_EQ(map_.points()[0].last_update, 3.0);
}

TEST_F(ClutterMapTest, APlaceNamesTheNearestPointWithinTheRegionAndNoOther) {
  for (const double range : {50e3, 50.4e3, 51.1e3}) ASSERT_TRUE(map_.initiate(plotAt(1.05, range, 10.5 * kSector), 0));
  EXPECT_EQ(map_.load({{"", 50.5e3, 10.5 * kSector}}, 2.0, radars_[0].quality), 0U);
  EXPECT_EQ(map_.size(), 3U);
  for (const ClutterPoint& point : map_.points()) EXPECT_EQ(map_.known(point), point.range == 50.4e3);
  EXPECT_EQ(map_.load({{"", 52e3, 10.5 * kSector}}, 2.0, radars_[0].quality), 0U);  // 900 m away is another one
  EXPECT_EQ(map_.size(), 4U);
}

// By brute force: as many points as a one-to-one matching by the same rule leaves.
TEST_F(ClutterMapTest, LoadingMatchesAsASearchThroughAllPointsDoes) {
  auto generator = tws::seededGenerator();
  const auto somewhere = [&] {
    return ClutterPlace{"", tws::uniform(generator, 20e3, 24e3), tws::wrapTwoPi(tws::uniform(generator, -0.2, 0.2))};
  };
  std::vector<ClutterPlace> there(150), places(100);
  for (ClutterPlace& place : there) {
    place = somewhere();
    ASSERT_TRUE(map_.initiate(plotAt(1.0, place.range, place.azimuth), 0));
  }
  std::size_t matched = 0;
  for (ClutterPlace& place : places) {
    place = somewhere();
    std::size_t best = there.size();
    double least = 0.0;
    for (std::size_t i = 0; i < there.size(); ++i) {
      const double range = std::abs(there[i].range - place.range);
      const double azimuth = std::abs(tws::angularDifference(there[i].azimuth, place.azimuth));
      const double distance = effectiveDistance(params_.clutter.gate, range, azimuth);
      if (range > 609.6 || azimuth > tws::radians(1.4) || (best < there.size() && distance >= least)) continue;
      best = i;
      least = distance;
    }
    if (best == there.size()) continue;
    there.erase(there.begin() + static_cast<std::ptrdiff_t>(best));
    ++matched;
  }
  EXPECT_EQ(map_.load(places, 2.0, radars_[0].quality), 0U);
  EXPECT_EQ(map_.size(), 150U + places.size() - matched);
  EXPECT_GT(matched, 10U);
  EXPECT_LT(matched, places.size());
}

TEST_F(ClutterMapTest, SaysHowManyPlacesGotNoNumber) {
  std::vector<ClutterPlace> places;
  for (int i = 0; i < 260; ++i) places.push_back({"", 2000.0 * (i + 1), 1.0});
  EXPECT_EQ(map_.load(places, 2.0, radars_[0].quality), 5U);
  EXPECT_EQ(map_.size(), 255U);
}

// The letter's points absorb from the start: an aircraft's first plot among them.
TEST_F(ClutterMapTest, APointOfOneDetectionIsNotKnownToBeClutter) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  EXPECT_TRUE(map_.absorbing(map_.points()[0]));
  EXPECT_FALSE(map_.known(map_.points()[0]));
  see(64 + 10, {plotAt(7.45, 50e3, 10.5 * kSector)});
  process(64 + 10);
  EXPECT_TRUE(map_.known(map_.points()[0]));
}

class DefaultClutterMapTest : public ClutterMapTest {
 protected:
  DefaultClutterMapTest() : ClutterMapTest("default") {}

  /// The same plot on each of the turns `from` to `to`.
  void seeTurns(int from, int to, double range = 50e3) {
    for (int turn = from; turn <= to; ++turn) {
      see(64 * turn + 10, {plotAt(6.4 * turn + 1.05, range, 10.5 * kSector)});
      process(64 * turn + 10);
    }
  }
};

// If this fails, an aircraft that happens to pass where a false plot was is taken out of the file.
TEST_F(DefaultClutterMapTest, APointTakesNothingOutBeforeFourDetections) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  seeTurns(1, 3);
  EXPECT_EQ(map_.absorbed(), 0U);
  EXPECT_FALSE(detection(3 * 64 + 10).used);
  EXPECT_EQ(detection(3 * 64 + 10).claim, map_.points()[0].number);
  seeTurns(4, 4);
  EXPECT_EQ(map_.absorbed(), 1U);
  EXPECT_TRUE(detection(4 * 64 + 10).used);
}

TEST_F(DefaultClutterMapTest, AFirmTrackEndsAPointOnProbationButNotAnEstablishedOne) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  seeTurns(1, 1);
  map_.disclaim(detection(64 + 10).claim);
  EXPECT_EQ(map_.size(), 0U);
  map_.disclaim(12345);  // Unknown numbers are ignored.
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  const std::uint32_t number = map_.points()[0].number;
  seeTurns(1, 4);
  map_.disclaim(number);
  EXPECT_EQ(map_.size(), 1U);
}

// Weights 1/2, 1/3, 1/4, 1/5, then always 0.2: the mean of the first five, then exponential.
TEST_F(DefaultClutterMapTest, APointsPositionIsTheMeanAtFirstAndSmoothedThen) {
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
  seeTurns(1, 1, 50.1e3);
  EXPECT_NEAR(map_.points()[0].range, 50.05e3, 1e-6);
  seeTurns(2, 2, 50.2e3);
  EXPECT_NEAR(map_.points()[0].range, 50.1e3, 1e-6);
  seeTurns(3, 4, 50.1e3);
  EXPECT_NEAR(map_.points()[0].range, 50.1e3, 1e-6);
  seeTurns(5, 5, 50.2e3);
  EXPECT_NEAR(map_.points()[0].range, 50.12e3, 1e-6);
  seeTurns(6, 6, 50.32e3);
  EXPECT_NEAR(map_.points()[0].range, 50.16e3, 1e-6);
}

// Three standard deviations of 100 m and 0.3°.
TEST_F(DefaultClutterMapTest, TheRegionIsNoWiderThanThreeStandardDeviations) {
  for (const bool inside : {true, false}) {
    ClutterMap map(params_);
    ASSERT_TRUE(map.initiate(plotAt(1.05, 50e3, 10.5 * kSector), 0));
    see(64 + 10, {plotAt(7.45, 50e3 + (inside ? 299.0 : 301.0), 10.5 * kSector + tws::radians(0.89))});
    map.process(0, radars_[0], 64 + 10, enter(64 + 11), std::nullopt);
    EXPECT_EQ(map.points()[0].hits, inside ? 2 : 1);
  }
}

// If this fails, clutter within a volume is judged by what was meant for elsewhere.
TEST_F(DefaultClutterMapTest, APointGoesByTheParametersOfItsVolume) {
  Volume near{"near", {}, params_};
  near.region.greatest_range = 60e3;
  near.params.clutter.hits = 2;
  params_.volumes.push_back(near);
  ClutterMap map(params_);
  for (const double range : {50e3, 80e3}) ASSERT_TRUE(map.initiate(plotAt(1.05, range, 10.5 * kSector), 0));
  for (int turn = 1; turn <= 2; ++turn) {
    const double time = 6.4 * turn + 1.05;
    see(64 * turn + 10, {plotAt(time, 50e3, 10.5 * kSector), plotAt(time, 80e3, 10.5 * kSector)});
    map.process(0, radars_[0], 64 * turn + 10, enter(64 * turn + 11), std::nullopt);
  }
  EXPECT_TRUE(detection(128 + 10, 0).absorbed);
  EXPECT_FALSE(detection(128 + 10, 1).absorbed);
}

// If this fails, what moves slowly enough to be absorbed but faster than 56 kn never becomes a track again.
TEST_F(DefaultClutterMapTest, GivesBackWhatMovesOverGround) {
  // 31 m/s = 60 kn, all across: 200 m a scan. The smoothed point is 200 / 0.2 = 1000 m behind when the detection comes,
  // within three times 0.3° of 100 km.
  ASSERT_TRUE(map_.initiate(plotAt(1.05, 100e3, 10.2 * kSector), 0));
  std::size_t moving = 0;
  for (int turn = 1; turn <= 24 && moving == 0; ++turn) {
    const double azimuth = 10.2 * kSector + 200.0 / 100e3 * turn;
    see(64 * turn + 10, {plotAt(6.4 * turn + 1.05, 100e3, azimuth)});
    moving += process(64 * turn + 10, 0, turn % 8 == 0 ? std::optional<double>(25.6) : std::nullopt).size();
  }
  EXPECT_EQ(moving, 1U);
}

}  // namespace
}  // namespace adit_tracker
