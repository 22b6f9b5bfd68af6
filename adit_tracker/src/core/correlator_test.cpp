#include "core/correlator.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <algorithm>
#include <map>

namespace adit_tracker {
namespace {

constexpr double kSector = tws::kSectorWidth;

/// Tracks whose predictions stand where a test puts them, and one radar's detections. Pairs are told by place.
class CorrelatorTest : public testing::Test {
 protected:
  TrackFile::Slot track(double range, double azimuth, bool firm = true) {
    const auto slot = *tracks_.start();
    Track& t = tracks_.at(slot);
    t.firm = firm;
    t.predicted.range = range;
    t.predicted.azimuth = tws::wrapTwoPi(azimuth);
    tracks_.place(slot, tws::sectorOf(azimuth));
    return slot;
  }

  /// Detections (range, azimuth), into the sector of their azimuth on turn `turn_`.
  void detections(const std::vector<std::pair<double, double>>& places) {
    std::map<std::int64_t, tws::RadarSector> sectors;
    for (const auto& [range, azimuth] : places) {
      const auto running = static_cast<std::int64_t>(std::floor(azimuth / kSector)) + 64 * turn_;
      tws::Plot plot;
      plot.range = range;
      plot.azimuth = tws::wrapTwoPi(azimuth);
      sectors[running].running = running;
      sectors[running].plots.push_back(plot);
    }
    for (const auto& [running, sector] : sectors) radar_.detections.add(sector);
  }

  /// The range of the detection that each track in `sector` got. Sectors +1 and +2 are the secondary ones.
  std::map<TrackFile::Slot, double> correlate(int sector) {
    std::vector<TrackFile::Slot> primary, secondary;
    tracks_.list(tws::wrapSector(sector), primary);
    tracks_.list(tws::wrapSector(sector + 1), secondary);
    tracks_.list(tws::wrapSector(sector + 2), secondary);
    std::map<TrackFile::Slot, double> result;
    for (const Correlation& c : correlator_.correlate(tracks_, primary, secondary, radar_, 64 * turn_ + sector)) {
      result[c.slot] = c.detection->plot.range;
    }
    return result;
  }

  bool used(std::int64_t sector, double range) {
    const auto& detections = radar_.detections.at(64 * turn_ + sector).detections;
    return std::any_of(detections.begin(), detections.end(),
                       [&](const Detection& d) { return d.plot.range == range && d.used; });
  }

  using Result = std::map<TrackFile::Slot, double>;

  AditParams params_ = AditParams::named("nrl7952");
  TrackFile tracks_{100};
  RadarState radar_{RadarParams{}, false};
  Correlator correlator_{params_};
  std::int64_t turn_ = 10;
};

// The regions: 609.6 m × 1.4°, 1524 × 2.45, 2438.4 × 3.5, 3352.8 × 4.55, 4267.2 × 5.6.
TEST_F(CorrelatorTest, TakesWhatIsInTheLargestRegionAndNothingBeyond) {
  const auto a = track(50e3, 20.5 * kSector);
  detections({{54.267e3, 20.5 * kSector}});
  EXPECT_EQ(correlate(20), (Result{{a, 54.267e3}}));
  ++turn_;
  detections({{54.268e3, 20.5 * kSector}, {50e3, 20.5 * kSector + tws::radians(5.61)}});
  EXPECT_TRUE(correlate(20).empty());
  ++turn_;
  detections({{50e3, 20.5 * kSector - tws::radians(5.59)}});
  EXPECT_EQ(correlate(20).size(), 1U);
}

// The other track is asked first and would take the detection, which is 700 m from it; b has it in its smallest region.
// If this fails, a track that was not detected steals its neighbour's detection.
TEST_F(CorrelatorTest, MakesTheClosestPairFirstWhateverTheOrderOfTheTracks) {
  const auto b = track(51.2e3, 20.5 * kSector);
  track(50.0e3, 20.5 * kSector);  // Firm tracks go on top: it comes first.
  detections({{50.7e3, 20.5 * kSector}});
  EXPECT_EQ(correlate(20), (Result{{b, 50.7e3}}));
}

TEST_F(CorrelatorTest, GivesEachTrackItsOwnWhenBothAreDetected) {
  const auto b = track(51.2e3, 20.5 * kSector), a = track(50.0e3, 20.5 * kSector);
  detections({{50.1e3, 20.5 * kSector}, {50.7e3, 20.5 * kSector}});
  EXPECT_EQ(correlate(20), (Result{{a, 50.1e3}, {b, 50.7e3}}));
}

// DI = 4·DELR/19.05 m + DELA/0.010986°: 300 m are 63.0; 0.5° are 45.5.
TEST_F(CorrelatorTest, ATrackTakesTheDetectionOfLeastEffectiveDistance) {
  const auto a = track(50e3, 20.5 * kSector);
  detections({{50.3e3, 20.5 * kSector}, {50e3 + 1.0, 20.5 * kSector + tws::radians(0.5)}});
  EXPECT_EQ(correlate(20), (Result{{a, 50e3 + 1.0}}));
}

// If this fails, a noise plot that has started a track takes a real target's detection.
TEST_F(CorrelatorTest, AFirmTrackChoosesBeforeATentativeOneInTheSameRegion) {
  track(50.1e3, 20.5 * kSector, false);
  const auto firm = track(50.0e3, 20.5 * kSector, true);
  detections({{50.15e3, 20.5 * kSector}});  // Nearer to the tentative one, but within the first region of both.
  EXPECT_EQ(correlate(20), (Result{{firm, 50.15e3}}));
}

// If this fails, detections of aircraft in the next sector are taken by tracks in this one: tracks swap.
TEST_F(CorrelatorTest, ATrackInASecondarySectorKeepsItsDetection) {
  const auto here = track(50e3, 20.9 * kSector);
  const auto next = track(50e3, 21.1 * kSector);
  detections({{50.1e3, 21.12 * kSector}});
  // It is in the smallest region of `next` (0.1°); for `here` it is 1.24° away: in its smallest region too, but
  // `here` comes first as it is in the primary sector.
  EXPECT_EQ(correlate(20), (Result{{here, 50.1e3}}));
  ++turn_;
  detections({{50.1e3, 21.3 * kSector}});  // 1.12° from `next`, 2.25° from `here`: the second region.
  EXPECT_TRUE(correlate(20).empty());
  EXPECT_FALSE(used(21, 50.1e3));  // Flagged, not taken: its own track is updated when its sector comes.
  EXPECT_EQ(correlate(21), (Result{{next, 50.1e3}}));
  EXPECT_TRUE(used(21, 50.1e3));
}

// If this fails, a plot that such a track wanted and then did not take starts no track.
TEST_F(CorrelatorTest, WhatIsPromisedToASecondaryTrackIsNotTakenYet) {
  track(50000.0, 5.5 * kSector);
  detections({{50000.0, 5.5 * kSector}});
  track(50000.0, 4.9 * kSector);  // so that there is something to correlate
  correlate(4);
  const Detection& detection = radar_.detections.at(64 * turn_ + 5).detections[0];
  EXPECT_NE(detection.taker, Detection::kNoTaker);
  EXPECT_FALSE(detection.isTaken());
  correlate(5);
  EXPECT_TRUE(detection.isTaken());
}

TEST_F(CorrelatorTest, TakesPartWithTracksTwoSectorsAhead) {
  track(50e3, 20.99 * kSector);
  track(50e3, 22.01 * kSector);
  detections({{50.0e3, 21.9 * kSector}});  // 5.1° from the first one, 0.6° from the second.
  EXPECT_TRUE(correlate(20).empty());
}

// If this fails, an aircraft loses its track at every crossing of north.
TEST_F(CorrelatorTest, WorksAcrossNorth) {
  const auto last = track(50e3, 63.95 * kSector);
  const auto first = track(80e3, 0.05 * kSector);
  detections({{50.1e3, 64.05 * kSector}, {80.1e3, 63.97 * kSector}});
  EXPECT_EQ(correlate(63), (Result{{last, 50.1e3}}));
  EXPECT_EQ(correlate(64), (Result{{first, 80.1e3}}));
}

TEST_F(CorrelatorTest, LooksIntoBothNeighbouringSectors) {
  const auto low = track(50e3, 20.02 * kSector), high = track(80e3, 20.98 * kSector);
  detections({{50e3, 19.9 * kSector}, {80e3, 21.1 * kSector}});
  EXPECT_EQ(correlate(20), (Result{{low, 50e3}, {high, 80e3}}));
}

TEST_F(CorrelatorTest, LeavesDetectionsThatAreInUseAlone) {
  track(50e3, 20.5 * kSector);
  detections({{50e3, 20.5 * kSector}});
  radar_.detections.at(64 * turn_ + 20).detections[0].used = true;
  EXPECT_TRUE(correlate(20).empty());
}

/// The report's text, step by step, for small cases: all passes over all tracks over all detections.
std::map<TrackFile::Slot, double> byTheBook(const TrackFile& tracks, const AditParams& params, int sector,
                                            const std::vector<std::pair<double, double>>& places) {
  std::vector<TrackFile::Slot> order;
  for (int s = sector; s <= sector + 2; ++s) tracks.list(tws::wrapSector(s), order);
  std::vector<bool> gone(places.size()), flagged(places.size());
  std::map<TrackFile::Slot, bool> correlated;
  std::map<TrackFile::Slot, double> result;
  for (const Gate& gate : params.track_gates) {
    for (const auto slot : order) {
      if (correlated[slot]) continue;
      const Prediction& p = tracks.at(slot).predicted;
      std::size_t best = places.size();
      double least = 1e300;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double delr = std::abs(places[i].first - p.range);
        const double dela = std::abs(tws::angularDifference(places[i].second, p.azimuth));
        const int away = tws::sectorDifference(tws::sectorOf(places[i].second), tracks.sector(slot));
        if (gone[i] || flagged[i] || std::abs(away) > 1 || delr > gate.range || dela > gate.azimuth) continue;
        const double distance = 4.0 * delr / 19.05 + dela / (2.0 * tws::kPi / 32768.0);
        if (distance >= least) continue;
        least = distance;
        best = i;
      }
      if (best == places.size()) continue;
      correlated[slot] = true;
      if (tracks.sector(slot) == tws::wrapSector(sector)) {
        gone[best] = true;
        result[slot] = places[best].first;
      } else {
        flagged[best] = true;
      }
    }
  }
  return result;
}

// If this fails, the quick correlator does not do what the report says.
TEST_F(CorrelatorTest, DoesWhatTheReportSaysInCrowdedSectors) {
  auto generator = tws::seededGenerator();
  for (int run = 0; run < 500; ++run) {
    tracks_ = TrackFile(100);
    turn_ += 2;  // Beyond the detections of the run before.
    const int sector = tws::uniformInt(generator, 0, 63);
    for (int i = tws::uniformInt(generator, 1, 10 + 30 * (run % 2)); i > 0; --i) {
      track(tws::uniform(generator, 50e3, 56e3), tws::uniform(generator, sector, sector + 3.0) * kSector,
            tws::uniformInt(generator, 0, 1) == 0);
    }
    std::vector<std::pair<double, double>> places;
    for (int i = tws::uniformInt(generator, 1, 10 + 30 * (run % 2)); i > 0; --i) {
      places.emplace_back(tws::uniform(generator, 50e3, 56e3),
                          tws::uniform(generator, sector - 1.0, sector + 4.0) * kSector);
    }
    detections(places);
    ASSERT_EQ(correlate(sector), byTheBook(tracks_, params_, sector, places)) << "run " << run;
  }
}

class StatisticalCorrelatorTest : public CorrelatorTest {
 protected:
  StatisticalCorrelatorTest() {
    params_ = AditParams::named("default");
    params_.association = Association::kPasses;
    correlator_ = Correlator(params_);
  }

  TrackFile::Slot trackWith(double range, double azimuth, double range_sigma, double cross_sigma) {
    const auto slot = track(range, azimuth);
    Prediction& p = tracks_.at(slot).predicted;
    p.innovation = {range_sigma * range_sigma, 0.0, cross_sigma * cross_sigma};
    p.log_volume = std::log(range_sigma * range_sigma * cross_sigma * cross_sigma / (100.0 * 100.0 * 200.0 * 200.0));
    return slot;
  }
};

// If this fails, a track is updated by plots where its target cannot be, or misses those where it can.
TEST_F(StatisticalCorrelatorTest, TakesWhatIsWithinFiveStandardDeviations) {
  const auto a = trackWith(50e3, 20.5 * kSector, 100.0, 400.0);
  for (const bool inside : {true, false}) {
    ++turn_;
    detections({{50e3 + (inside ? 499.0 : 501.0), 20.5 * kSector}});
    EXPECT_EQ(correlate(20), inside ? (Result{{a, 50.499e3}}) : Result{});
    ++turn_;
    detections({{50e3, 20.5 * kSector + (inside ? 1999.0 : 2001.0) / 50e3}});
    EXPECT_EQ(correlate(20).size(), inside ? 1U : 0U);
  }
}

// Distances: the sure track 1.5² = 2.25; the vague one 0.3² + ln(25·25) = 6.53, though it is fewer sigmas away.
// If this fails, new tracks, which know little, take the detections of good ones.
TEST_F(StatisticalCorrelatorTest, OfTwoTracksTheOneThatKnowsBetterWins) {
  const auto sure = trackWith(50.15e3, 20.5 * kSector, 100.0, 200.0);
  trackWith(50.15e3, 20.5 * kSector, 500.0, 1000.0);  // On top of the sector file: it is asked first.
  detections({{50.0e3, 20.5 * kSector}});
  EXPECT_EQ(correlate(20), (Result{{sure, 50.0e3}}));
}

// A tentative track asks for what is at least 1/50 as likely its own as a false plot, where these are few and where
// they are so many that the distance alone decides. Its likelihood falls with the distance like a Gaussian's. If this
// fails, aircraft in rain are not followed, or rain costs minutes.
TEST_F(StatisticalCorrelatorTest, ATentativeTrackLeavesWhatIsSurelyFalseAlone) {
  params_.association = Association::kChances;
  correlator_ = Correlator(params_);
  const auto tentative = trackWith(50e3, 20.5 * kSector, 300.0, 300.0);
  tracks_.at(tentative).firm = false;
  tracks_.at(tentative).existence = 0.5;
  FalsePlotMap& map = radar_.quality.falsePlotMap();
  map.addRange(64e3);
  for (const double a_scan : {0.02, 1.0, 10.0}) {
    for (int scan = 0; scan < 30; ++scan) {
      map.add(20, 50e3, a_scan);
      map.close(20);
    }
    const double density = map.density(50e3, 20.5 * kSector);
    EXPECT_EQ(map.areMany(density), a_scan >= 1.0);
    const double farthest = 300.0 * std::sqrt(-2.0 * std::log(0.02 * density * 2.0 * tws::kPi * 300.0 * 300.0));
    for (const bool near_enough : {true, false}) {
      ++turn_;
      detections({{50e3, 20.5 * kSector + (farthest + (near_enough ? -1.0 : 1.0)) / 50e3}});
      const auto& asked = correlator_.correlate(tracks_, {tentative}, {}, radar_, 64 * turn_ + 20);
      EXPECT_EQ(asked.size(), near_enough ? 1U : 0U) << a_scan << " a scan, " << farthest << " m";
    }
  }
}

}  // namespace
}  // namespace adit_tracker
