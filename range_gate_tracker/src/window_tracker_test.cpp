#include "window_tracker.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "window_test_helpers.h"

namespace range_gate_tracker {
namespace {

/// A tracker that keeps all that it says.
struct Station {
  struct Said {
    std::int64_t running;
    WindowEvent event;
    TrackFile file;
  };

  explicit Station(const WindowParams& params = {})
      : tracker(params, [this](const WindowReport& report) {
          ++reports;
          for (const WindowUpdate& update : report.updates)
            said.push_back({report.running, update.event, *update.file});
        }) {}

  void run(const std::vector<tws::RadarSector>& sectors, std::size_t from = 0, std::size_t to = 1u << 30) {
    for (std::size_t n = from; n < std::min(to, sectors.size()); ++n) tracker.process(sectors[n]);
  }

  int count(WindowEvent event) const {
    return static_cast<int>(std::count_if(said.begin(), said.end(), [&](const Said& s) { return s.event == event; }));
  }

  std::vector<Said> said;
  std::size_t reports = 0;
  WindowTracker tracker;
};

const Flight kAircraft = straight(20000.0, 30000.0, -150.0, 100.0);

TEST(WindowTracker, StartsATrackByItselfAndMakesItFirm) {
  Station station;
  station.run(TestRadar::sectors({kAircraft}, 10));
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  const TrackFile& track = station.tracker.tracks().begin()->second;
  EXPECT_EQ(station.count(WindowEvent::kStarted), 1);
  EXPECT_EQ(station.count(WindowEvent::kDropped), 0);
  EXPECT_EQ(track.hits, 10);
  EXPECT_TRUE(station.tracker.isConfirmed(track));
  EXPECT_EQ(track.type, TargetType::kAircraft);
  EXPECT_EQ(station.reports, 640U);
  const WindowKinematics now = station.tracker.at(track, 60.0);
  EXPECT_NEAR((now.position - kAircraft(60.0)).norm(), 0.0, 1.0);
  EXPECT_NEAR((now.velocity - Eigen::Vector2d(-150.0, 100.0)).norm(), 0.0, 0.1);
}

// Section 2.4.2: first the acquisition window, after the second detection the tracking window, which then shrinks.
TEST(WindowTracker, ReducesTheAcquisitionWindowToTheTrackingWindowAndThatWithTheError) {
  Station station;
  station.run(TestRadar::sectors({kAircraft}, 12));
  ASSERT_GE(station.said.size(), 12U);
  const WindowParams params;
  EXPECT_FALSE(station.said[0].file.window.tracking);
  EXPECT_NEAR(station.said[0].file.window.half_range, 350.0 * 6.0 + 7.5 * 36.0 + 300.0, 30.0);  // 6 s, but for a little
  EXPECT_TRUE(station.said[1].file.window.tracking);
  for (std::size_t i = 1; i < 11; ++i)
    EXPECT_LE(station.said[i + 1].file.window.half_range, station.said[i].file.window.half_range) << i;
  EXPECT_NEAR(station.said[11].file.window.half_range, 3.0 * std::sqrt(2.0) * 100.0, 1.0);  // no errors: the floor
}

TEST(WindowTracker, AnswersSoonAfterTheBeamHasLeftTheWindow) {
  Station station;
  station.run(TestRadar::sectors({kAircraft}, 12));
  for (const auto& said : station.said) {
    if (said.event != WindowEvent::kUpdated || said.file.hits < 6) continue;
    const double sectors = said.file.measured.time / TestRadar::kPeriod * tws::kSectors;
    EXPECT_LE(static_cast<double>(said.running) - sectors, 3.0);
  }
}

TEST(WindowTracker, LetsMissedScansPassAndDropsTheTrackAfterTheLast) {
  Station station;
  // Not seen from 60 s to 75 s, twice or thrice in between; and never again from 120 s on.
  station.run(
      TestRadar::sectors({kAircraft}, 32, [](std::size_t, double t) { return t < 60.0 || (t > 75.0 && t < 120.0); }));
  EXPECT_EQ(station.count(WindowEvent::kStarted), 1);
  EXPECT_EQ(station.count(WindowEvent::kDropped), 1);
  EXPECT_EQ(station.tracker.tracks().size(), 0U);
  const auto& last = station.said.back();
  EXPECT_EQ(last.event, WindowEvent::kDropped);
  EXPECT_EQ(last.file.misses, 4);
}

TEST(WindowTracker, DropsATrackThatWasNeverConfirmedAfterTwoScans) {
  Station station;
  station.run(TestRadar::sectors({kAircraft}, 6, [](std::size_t, double t) { return t < 6.0; }));
  EXPECT_EQ(station.count(WindowEvent::kDropped), 1);
  EXPECT_EQ(station.said.back().file.misses, 2);
}

TEST(WindowTracker, DoesNotBelieveInWhatStandsStill) {
  Station station;
  station.run(TestRadar::sectors({straight(5000.0, 5000.0, 0.0, 0.0)}, 20));
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  const TrackFile& track = station.tracker.tracks().begin()->second;
  EXPECT_EQ(track.type, TargetType::kStationary);
  EXPECT_EQ(track.priority, 4);
  EXPECT_FALSE(station.tracker.isConfirmed(track));
}

// Manual detection: nothing happens until the operator sets the marker; 700 m beside the target is good enough.
TEST(WindowTracker, TracksOnlyWhatTheOperatorDesignatesWhenItIsNotAutomatic) {
  WindowParams params;
  params.automatic = false;
  Station station(params);
  const auto sectors = TestRadar::sectors({kAircraft, straight(-40000.0, 0.0, 200.0, 0.0)}, 20);
  station.run(sectors, 0, 128);
  EXPECT_TRUE(station.tracker.tracks().empty());
  const Eigen::Vector2d marker = kAircraft(12.0) + Eigen::Vector2d(500.0, 500.0);
  const auto number = station.tracker.designate(marker.norm(), tws::azimuthOf(marker));
  ASSERT_TRUE(number);
  station.run(sectors, 128);
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  const TrackFile& track = station.tracker.tracks().at(*number);
  EXPECT_TRUE(track.designated);
  EXPECT_TRUE(station.tracker.isConfirmed(track));
  EXPECT_NEAR((station.tracker.at(track, 120.0).position - kAircraft(120.0)).norm(), 0.0, 5.0);
}

TEST(WindowTracker, GivesUpAMarkerWhereNothingIs) {
  WindowParams params;
  params.automatic = false;
  Station station(params);
  const auto sectors = TestRadar::sectors({}, 6);
  station.run(sectors, 0, 64);
  ASSERT_TRUE(station.tracker.designate(50000.0, 1.0));
  station.run(sectors, 64);
  EXPECT_EQ(station.count(WindowEvent::kStarted), 1);
  EXPECT_EQ(station.count(WindowEvent::kDropped), 1);
  EXPECT_EQ(station.said.back().file.hits, 0);
}

TEST(WindowTracker, HasNoMarkerBeforeTheFirstSector) { EXPECT_FALSE(Station().tracker.designate(1000.0, 1.0)); }

TEST(WindowTracker, CancelsWhatTheOperatorCancels) {
  Station station;
  const auto sectors = TestRadar::sectors({kAircraft}, 10);
  station.run(sectors, 0, 400);
  const std::uint32_t number = station.tracker.tracks().begin()->first;
  EXPECT_TRUE(station.tracker.cancel(number));
  EXPECT_FALSE(station.tracker.cancel(number));
  EXPECT_TRUE(station.tracker.tracks().empty());
  station.run(sectors, 400, 401);
  EXPECT_EQ(station.said.back().event, WindowEvent::kDropped);
  EXPECT_EQ(station.said.back().file.number, number);
  station.run(sectors, 401);
  EXPECT_EQ(station.tracker.tracks().size(), 1U) << "it is still seen: a new track starts by itself";
  EXPECT_NE(station.tracker.tracks().begin()->second.uid, station.said.front().file.uid);
}

// Section 2.5.1: the filters carry two tracks on while their windows coincide.
TEST(WindowTracker, CarriesTwoCrossingTracksThroughByMomentum) {
  // They meet at 90 s, 40 km north, at right angles.
  const std::vector<Flight> flights{straight(-13500.0, 40000.0, 150.0, 0.0),
                                    straight(13500.0 * 0.6, 40000.0 + 10800.0, -90.0, -120.0)};
  Station station;
  station.run(TestRadar::sectors(flights, 30));
  EXPECT_EQ(station.count(WindowEvent::kStarted), 2);
  EXPECT_EQ(station.count(WindowEvent::kDropped), 0);
  EXPECT_GE(station.count(WindowEvent::kMissed), 2) << "their windows coincide for a scan at least";
  std::map<std::uint32_t, Eigen::Vector2d> first;
  for (const auto& said : station.said)
    first.try_emplace(said.file.uid, tws::planarFromPolar(said.file.measured.range, said.file.measured.azimuth));
  for (const auto& [number, track] : station.tracker.tracks()) {
    const bool westerly = first.at(track.uid).x() < 0.0;  // the one that came from the west
    EXPECT_NEAR((station.tracker.at(track, 180.0).position - flights[westerly ? 0 : 1](180.0)).norm(), 0.0, 300.0);
  }
}

TEST(WindowTracker, TakesTheCentreOfGravityOfTwoPlotsInOneWindow) {
  auto sectors = TestRadar::sectors({kAircraft}, 11);
  tws::Plot* last = nullptr;
  for (auto& sector : sectors)
    if (!sector.plots.empty()) last = &sector.plots.front();
  ASSERT_NE(last, nullptr);
  const double range = last->range;
  for (auto& sector : sectors) {
    if (sector.plots.empty() || &sector.plots.front() != last) continue;
    sector.plots.push_back(*last);
    sector.plots.back().range += 200.0;
    break;
  }
  Station station;
  station.run(sectors);
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  EXPECT_NEAR(station.tracker.tracks().begin()->second.measured.range, range + 100.0, 1e-6);
  EXPECT_EQ(station.count(WindowEvent::kStarted), 1) << "the second plot is no second target";
}

// A false detection near an aircraft opens a large window around it; that may not take the aircraft's detections away.
TEST(WindowTracker, LetsNoAcquisitionWindowTakeADetectionOfATrack) {
  auto sectors = TestRadar::sectors({kAircraft}, 20);
  for (auto& sector : sectors) {
    if (sector.plots.empty() || sector.running < 640 || sector.running > 760) continue;
    tws::Plot stray = sector.plots.front();
    stray.range += 1500.0;
    sector.plots.push_back(stray);
  }
  Station station;
  station.run(sectors);
  for (const auto& said : station.said)
    EXPECT_FALSE(said.file.uid == 0 && said.event == WindowEvent::kMissed) << "the aircraft lost its detection";
  EXPECT_GT(station.count(WindowEvent::kDropped), 0) << "the strays opened windows of their own";
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  EXPECT_EQ(station.tracker.tracks().begin()->second.hits, 20);
}

TEST(WindowTracker, FollowsATargetThroughNorthAndCloseBy) {
  Station station;
  station.run(TestRadar::sectors({straight(-15000.0, 6000.0, 200.0, 0.0)}, 25));
  EXPECT_EQ(station.count(WindowEvent::kStarted), 1);
  EXPECT_EQ(station.count(WindowEvent::kMissed), 0);
}

TEST(WindowTracker, CountsWhatItCannotTake) {
  WindowParams params;
  params.capacity = 2;
  Station station(params);
  auto sectors = TestRadar::sectors({kAircraft, straight(-40000.0, 0.0, 200.0, 0.0)}, 4);
  tws::Plot bad;
  bad.range = std::nan("");
  sectors[5].plots.push_back(bad);
  bad.range = -1.0;
  sectors[6].plots.push_back(bad);
  station.run(sectors);
  EXPECT_EQ(station.tracker.counts().rejected_plots, 2U);
  EXPECT_GE(station.tracker.counts().refused_tracks, 3U);
  EXPECT_EQ(station.tracker.tracks().size(), 1U);
}

// If this fails, one sector full of jamming stops the tracker for seconds, uses up all track numbers, or costs a track.
TEST(WindowTracker, AFloodOfPlotsStartsNoTracksAndLosesNone) {
  std::vector<Flight> flights;
  for (int i = 0; i < 7; ++i) flights.push_back(straight(20e3 + 15e3 * i, 30e3, -100.0, 50.0));
  auto sectors = TestRadar::sectors(flights, 12);
  constexpr int kPlots = 20003;
  tws::RadarSector& flood = sectors[7 * tws::kSectors + 10];
  for (int i = 0; i < kPlots; ++i) {
    tws::Plot plot = TestRadar::plotAt(flights[0], flood.enter_time);
    plot.range = 1e3 + 10.0 * i;
    flood.plots.push_back(plot);
  }
  Station station;
  station.run(sectors);
  EXPECT_EQ(station.count(WindowEvent::kStarted), 7);
  EXPECT_EQ(station.count(WindowEvent::kDropped), 0);
  EXPECT_GT(station.tracker.counts().crowded_plots, kPlots / 2U);
}

// A radar that was off comes back: what was tracked is missed and dropped, and nothing is stuck.
TEST(WindowTracker, GoesOnAfterAGapInTheSectors) {
  Station station;
  const auto sectors = TestRadar::sectors({kAircraft}, 60);
  station.run(sectors, 0, 640);
  station.run(sectors, 30 * 64);
  ASSERT_EQ(station.tracker.tracks().size(), 1U);
  EXPECT_NEAR((station.tracker.at(station.tracker.tracks().begin()->second, 360.0).position - kAircraft(360.0)).norm(),
              0.0, 5.0);
}

TEST(WindowParams, AreRefusedByName) {
  const auto complaint = [](auto change) {
    WindowParams params;
    change(params);
    try {
      check(params);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint([](auto&) {}), "");
  EXPECT_EQ(complaint([](auto& p) { p.greatest_speed = 0.0; }).find("greatest_speed is "), 0U);
  EXPECT_EQ(complaint([](auto& p) { p.error_weight = 1.5; }).find("error_weight is "), 0U);
  EXPECT_EQ(complaint([](auto& p) { p.firm_hits = 1; }).find("firm_hits is "), 0U);
  EXPECT_EQ(complaint([](auto& p) { p.air_speed = 5.0; }).find("air_speed is "), 0U);
  EXPECT_EQ(complaint([](auto& p) { p.filter.kind = "alpha_beta", p.filter.beta = 3.9; }).find("alpha is "), 0U);
  EXPECT_EQ(complaint([](auto& p) { p.widest = 2.0; }).find("widest is "), 0U);
}

}  // namespace
}  // namespace range_gate_tracker
