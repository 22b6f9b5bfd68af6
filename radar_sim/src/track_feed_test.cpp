#include "track_feed.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

#include "flight_path.h"
#include "scenario.h"
#include "scenario_file_test_helpers.h"
#include "track_feed_messages.h"
#include "track_feed_sensor.h"

namespace radar_sim {
namespace {

/// An aircraft 30 km north-east that flies east.
Target aircraft(const std::string& name) {
  Target target;
  target.name = name;
  const PathStart start{1000.0, {21000.0, 21000.0}, 6000.0, tws::kPi / 2.0, 200.0};
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0, 1e9);
  target.transponder.codes[index(Mode::k3A)] = 04101;
  target.transponder.altitude = true;
  return target;
}

/// All updates of a feed in some scans of 6 s, with an antenna at the map's origin.
std::vector<FedTrack> updates(FeedKind kind, const std::vector<Target>& targets, int scans, double sigma = 0.0) {
  TrackFeed feed(kind, {"sps12", sigma, sigma / 2.0}, Eigen::Isometry3d::Identity(), targets, 7);
  std::vector<FedTrack> all;
  for (std::int64_t running = 0; running < scans * tws::kSectors; ++running) {
    tws::RadarSector sector;
    sector.running = running;
    sector.sector = static_cast<int>(running % tws::kSectors);
    sector.enter_time = 1000.0 + static_cast<double>(running) * 6.0 / tws::kSectors;
    for (const FedTrack& update : feed.tracksOf(sector)) all.push_back(update);
  }
  return all;
}

// If one of these fails, a scenario that is fed as tracks measures the feed instead of the correlator.

TEST(TrackFeed, UpdatesEveryAircraftOnceAScanWhereItIs) {
  const std::vector<Target> targets{aircraft("a")};
  const auto said = updates(FeedKind::kPrimary, targets, 5);
  ASSERT_EQ(said.size(), 5u);
  for (std::size_t turn = 0; turn < said.size(); ++turn) {
    // 45° and a little more is sector 8, entered 8/64 of a turn after north.
    EXPECT_NEAR(said[turn].time, 1000.0 + 6.0 * static_cast<double>(turn) + 0.75, 0.1);
    const TargetState truth = targets[0].trajectory->at(said[turn].time);
    EXPECT_NEAR(said[turn].state.head<2>().norm(), truth.position.norm(), 1e-6);
    EXPECT_NEAR(tws::azimuthOf(said[turn].state.head<2>()), tws::azimuthOf(truth.position.head<2>()), 1e-12);
    EXPECT_EQ(said[turn].number, 1u);
    EXPECT_TRUE(std::isnan(said[turn].height));
  }
}

TEST(TrackFeed, HasTheErrorsThatItIsGivenNewEachScan) {
  const std::vector<Target> targets{aircraft("a")};
  const int scans = 2000;
  const auto exact = updates(FeedKind::kSecondary, targets, scans),
             noisy = updates(FeedKind::kSecondary, targets, scans, 8.0);
  ASSERT_EQ(exact.size(), noisy.size());
  Eigen::Vector4d squares = Eigen::Vector4d::Zero(), products = Eigen::Vector4d::Zero(), last = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Eigen::Vector4d error = noisy[i].state - exact[i].state;
    squares += error.cwiseAbs2();
    products += error.cwiseProduct(last);
    last = error;
  }
  // Four standard deviations of a variance and of a covariance from 2000 values: 4·√(2/2000) = 0.13, 4/√2000 = 0.09.
  for (int i = 0; i < 4; ++i) {
    const double variance = i < 2 ? 64.0 : 16.0;
    EXPECT_NEAR(squares(i) / scans, variance, 0.13 * variance);
    EXPECT_NEAR(products(i) / scans, 0.0, 0.09 * variance);
  }
}

TEST(TrackFeed, AnotherAircraftChangesNoErrors) {
  const auto alone = updates(FeedKind::kPrimary, {aircraft("a")}, 3, 8.0);
  const auto both = updates(FeedKind::kPrimary, {aircraft("b"), aircraft("a")}, 3, 8.0);
  ASSERT_EQ(both.size(), 2 * alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(both[2 * i + 1].state, alone[i].state);
  EXPECT_NE(both[0].state, both[1].state);
  EXPECT_NE(updates(FeedKind::kSecondary, {aircraft("a")}, 3, 8.0)[0].state, alone[0].state);
}

TEST(TrackFeed, ASecondaryTrackHasHeightAndNeedsATransponder) {
  std::vector<Target> targets{aircraft("a"), aircraft("mute")};
  targets[1].transponder = Transponder();
  const auto said = updates(FeedKind::kSecondary, targets, 2);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0].target, 0u);
  EXPECT_EQ(said[0].height, 6000.0);
  EXPECT_EQ(updates(FeedKind::kPrimary, targets, 2).size(), 4u);
}

// The paper's change of the secondary track's identity.
TEST(TrackFeed, ATransponderThatFallsSilentForAMomentComesBackUnderAnotherNumber) {
  std::vector<Target> targets{aircraft("a")};
  targets[0].transponder.silences = {{1009.0, 1009.5}};
  const auto said = updates(FeedKind::kSecondary, targets, 4);
  ASSERT_EQ(said.size(), 5u);
  EXPECT_EQ(said[1].number, 1u);
  EXPECT_TRUE(said[2].dropped);
  EXPECT_EQ(said[2].number, 1u);
  EXPECT_EQ(said[3].number, 2u);
  EXPECT_FALSE(said[4].dropped);
  EXPECT_EQ(updates(FeedKind::kPrimary, targets, 4).size(), 4u);
}

TEST(TrackFeed, MessagesSayPrimaryTracksWithoutAndSecondaryTracksWithHeightAndCodes) {
  const std::vector<Target> targets{aircraft("a")};
  for (const FeedKind kind : {FeedKind::kPrimary, FeedKind::kSecondary}) {
    const TrackFeed feed(kind, {"sps12", 8.0, 5.0}, Eigen::Isometry3d::Identity(), targets, 7);
    tws::RadarSector sector;
    sector.sector = 8;
    sector.running = 72;
    sector.enter_time = 1006.75;
    const tws_msgs::Tracks message = toTracks(feed, updates(kind, targets, 1), sector, targets, tws::SeaLevel());
    EXPECT_EQ(message.header.stamp, ros::Time(1006, 750000000));
    EXPECT_EQ(message.radar, "sps12");
    EXPECT_EQ(message.running_sector, 72u);
    ASSERT_EQ(message.tracks.size(), 1u);
    const tws_msgs::Track& track = message.tracks[0];
    const bool primary = kind == FeedKind::kPrimary;
    EXPECT_EQ(message.tracker, primary ? "primary" : "secondary");
    EXPECT_EQ(std::isnan(track.height), primary);
    EXPECT_EQ(track.mode_3a, primary ? tws_msgs::Track::CODE_UNKNOWN : 04101);
    // The slant range laid on the ground, or the place on the ground: the start and 0.75 s at 200 m/s.
    const double expected = primary ? track.range : std::hypot(21150.0, 21000.0);
    EXPECT_NEAR(std::hypot(track.position.x, track.position.y), expected, 30.0);
    EXPECT_EQ(track.covariance[0], 64.0);
    EXPECT_EQ(track.covariance[15], 25.0);
    EXPECT_NEAR(track.speed, 200.0, 5.0);
  }
}

TEST_F(ScenarioFile, OfAFeedNamesAPrimaryRadar) {
  const std::string radars = "radars: [{name: a}]\nsecondary_radars: [{name: s}]\n";
  EXPECT_EQ(load(radars).sensors.size(), 2u);
  const Scenario scenario = load(radars + "track_feed: {clock_radar: a, position_sigma_m: 3}");
  const TrackFeedParams feed = dynamic_cast<const TrackFeedSpec&>(*scenario.sensors.back()).params;
  EXPECT_EQ(feed.clock_radar, "a");
  EXPECT_EQ(feed.position_sigma, 3.0);
  EXPECT_EQ(feed.velocity_sigma, 5.0);
  expectComplaint(radars + "track_feed: {}", 3, "clock_radar");
  expectComplaint(radars + "track_feed: {clock_radar: s}", 3, "clock_radar");
  expectComplaint(radars + "track_feed: {clock_radar: a, position_sigma_m: -1}", 3, "position_sigma_m");
  expectComplaint(radars + "track_feed: {clock_radar: a, sigma: 1}", 3, "sigma");
}

// The paper's figures: 1 km, 2 km and 100 m from the radar at the start; 20 m, 20 m and 40 m apart in seconds 10 to 20.
TEST(ThreeTargets, FlyAsThePaperSays) {
  const auto targets = allTargets(loadScenario(SCENARIOS "/bel_three_targets.yaml"));
  ASSERT_EQ(targets.size(), 3u);
  const auto at = [&](std::size_t target, double time) -> Eigen::Vector2d {
    return targets[target].trajectory->at(1000.0 + time).position.head<2>();
  };
  EXPECT_NEAR(at(0, 0.0).norm(), 1000.0, 1e-3);
  EXPECT_NEAR(at(1, 0.0).norm(), 2000.0, 1e-3);
  EXPECT_NEAR(at(2, 0.0).norm(), 100.0, 1e-3);
  for (double time = 10.0; time <= 20.0; time += 1.0) {
    EXPECT_NEAR((at(0, time) - at(1, time)).norm(), 20.0, 0.05) << time;
    EXPECT_NEAR((at(0, time) - at(2, time)).norm(), 20.0, 0.05) << time;
    EXPECT_NEAR((at(1, time) - at(2, time)).norm(), 40.0, 0.05) << time;
  }
  EXPECT_GT((at(0, 23.0) - at(1, 23.0)).norm(), (at(0, 22.0) - at(1, 22.0)).norm());
}

}  // namespace
}  // namespace radar_sim
