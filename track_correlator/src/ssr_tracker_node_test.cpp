#include <track_correlator/ssr_tracker_node.h>

#include <gtest/gtest.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

#include "ssr_test_helpers.h"

namespace track_correlator {
namespace {

/// The node in one process, a radar 5 km east of the map's origin, and a listener.
class SsrTrackerNodeTest : public testing::Test {
 protected:
  SsrTrackerNodeTest() {
    tws_runtime::Bus& bus = graph_.addNode("radar");
    plots_ = bus.advertise<tws_msgs::SsrPlots>("/ssr/plots");
    bus.subscribe<tws_msgs::Tracks>("/ssr/tracks", [this](const auto& message) { published_.push_back(message); });
    site_.header.frame_id = "map";
    site_.child_frame_id = "ssr";
    site_.transform.translation.x = 5000.0;
    site_.transform.rotation.w = 1.0;
  }

  tws_msgs::SsrPlots messageOf(const SecondarySector& sector) const {
    tws_msgs::SsrPlots message;
    message.header.stamp = tws_runtime::toTime(sector.leave_time);
    message.header.frame_id = message.radar = "ssr";
    message.running_sector = static_cast<std::uint32_t>(sector.running);
    message.sector = static_cast<std::uint8_t>(sector.running % 64);
    for (const SecondaryPlot& plot : sector.plots) {
      tws_msgs::SsrPlot& p = message.plots.emplace_back();
      p.stamp = tws_runtime::toTime(plot.time);
      p.range = plot.range;
      p.azimuth = plot.azimuth;
      p.height = plot.height;
      p.mode_1 = p.mode_2 = tws_msgs::SsrPlot::CODE_UNKNOWN;
      p.mode_3a = plot.mode_3a.code;
    }
    return message;
  }

  std::vector<tws_msgs::SsrPlots> flight(int turns) const {
    std::vector<SecondarySector> sectors = ssr_.emptySectors(turns);
    for (int turn = 0; turn <= turns; ++turn) ssr_.put(ssr_.plotOf(aircraft_, turn), sectors);
    std::vector<tws_msgs::SsrPlots> messages;
    for (const SecondarySector& sector : sectors) messages.push_back(messageOf(sector));
    return messages;
  }

  void publish(const std::vector<tws_msgs::SsrPlots>& messages) {
    for (const auto& message : messages) {
      plots_.publish(message);
      graph_.drain();
    }
  }

  std::uint64_t count(const std::string& name) const {
    for (const auto& reading : graph_.counters())
      if (reading.node == "ssr_tracker" && reading.name == name) return reading.value;
    return 0;
  }

  void start(const std::string& parameters = "{}") {
    node_ = std::make_unique<SsrTrackerNode>(graph_.addNode("ssr_tracker", YAML::Load(parameters)));
  }
  void placeRadar() { graph_.addNode("sites").publishStaticTransform(site_); }

  const TestSsr ssr_;
  const TestAircraft aircraft_{20e3, 10e3, 200.0, 0.0, 04321, 9000.0};
  std::ostringstream log_;
  tws_runtime::LocalGraph graph_{log_};
  tws_runtime::Publisher<tws_msgs::SsrPlots> plots_;
  geometry_msgs::TransformStamped site_;
  std::vector<tws_msgs::Tracks> published_;
  std::unique_ptr<SsrTrackerNode> node_;
};

TEST_F(SsrTrackerNodeTest, SaysEverySectorAndTheAircraftAtItsPlaceInTheMap) {
  start();
  placeRadar();
  publish(flight(10));
  ASSERT_EQ(published_.size(), 638U);  // Two sectors behind.
  const tws_msgs::Track* last = nullptr;
  for (std::size_t n = 0; n < published_.size(); ++n) {
    EXPECT_EQ(published_[n].sequence, n);
    EXPECT_EQ(published_[n].running_sector, n);
    for (const auto& track : published_[n].tracks) last = &track;
  }
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->state, tws_msgs::Track::FIRM);
  EXPECT_EQ(last->mode_3a, 04321);
  EXPECT_EQ(last->mode_1, tws_msgs::Track::CODE_UNKNOWN);
  EXPECT_EQ(last->height, 9000.0);
  EXPECT_EQ(last->detection_bits, tws_msgs::Track::DETECTED_BY_IFF);
  // By hand: the aircraft's x and y stand for slant range and azimuth; at 9000 m the ground range is shorter. z is less
  // than the height by d² / (2·R) from the map's origin, of a sphere of 6371 km.
  const double t = tws_runtime::toSeconds(last->stamp), slant = std::hypot(aircraft_.xAt(t), aircraft_.yAt(t));
  const double from_origin = std::hypot(last->position.x, last->position.y);
  const double up = 9000.0 - from_origin * from_origin / (2.0 * 6371e3);
  const double shorter = std::sqrt(slant * slant - up * up) / slant;
  EXPECT_NEAR(last->range, slant, 60.0);
  EXPECT_NEAR(last->position.x, 5000.0 + aircraft_.xAt(t) * shorter, 60.0);
  EXPECT_NEAR(last->position.y, aircraft_.yAt(t) * shorter, 60.0);
  EXPECT_NEAR(last->position.z, up, 2.0);
  EXPECT_EQ(last->covariance.size(), 16U);
}

// If this fails, a run depends on how fast the transforms arrive.
TEST_F(SsrTrackerNodeTest, WaitsForTheRadarsSite) {
  start();
  const auto messages = flight(3);
  publish({messages.begin(), messages.begin() + 50});
  EXPECT_TRUE(published_.empty());
  placeRadar();
  publish({messages.begin() + 50, messages.end()});
  EXPECT_EQ(published_.size(), 190U);
  EXPECT_EQ(count("unknown sites"), 0U);
}

TEST_F(SsrTrackerNodeTest, GoesOnWithoutASiteAfterTwoTurns) {
  start();
  publish(flight(5));
  EXPECT_EQ(published_.size(), 318U);
  EXPECT_EQ(count("unknown sites"), 1U);
}

// If this fails, bad input stops the picture, or nobody is told of it.
TEST_F(SsrTrackerNodeTest, CountsWhatIsBadAndLosesNothingElse) {
  start();
  placeRadar();
  auto messages = flight(10);
  for (auto& message : messages) {
    if (message.plots.empty() || message.running_sector < 300) continue;
    tws_msgs::SsrPlot bad = message.plots[0];
    bad.range = std::nan("");
    message.plots.push_back(bad);
    message.plots[0].mode_1 = 5000;  // Not octal, four digits.
    message.plots[0].height = 1e9;
  }
  messages[200].radar = "other";
  messages[201].sector = 77;
  messages[210].header.stamp = ros::Time(99999.0);
  publish(messages);
  publish({messages[600]});
  EXPECT_EQ(count("bad messages"), 2U);
  EXPECT_EQ(count("stray messages"), 1U);
  EXPECT_EQ(count("lost sectors"), 3U);
  EXPECT_EQ(count("late sectors"), 1U);
  EXPECT_EQ(count("bad plots"), 3U * count("plots") - 3U * 5U) << "three faults in each sector from the sixth turn on";
  EXPECT_EQ(published_.size(), 638U);
  std::set<std::uint32_t> tracks;
  for (const auto& message : published_)
    for (const auto& track : message.tracks) tracks.insert(track.uid);
  EXPECT_EQ(tracks.size(), 1U);
}

// If this fails, a bag played twice shows the aircraft of the first time.
TEST_F(SsrTrackerNodeTest, BeginsAnewWhenTimeGoesBack) {
  start();
  placeRadar();
  publish(flight(10));
  const std::size_t first = published_.size();
  publish(flight(10));
  EXPECT_EQ(count("new runs"), 1U);
  EXPECT_EQ(published_.size(), 2 * first);
}

// If this fails, one stamp that was damaged on its way costs all tracks.
TEST_F(SsrTrackerNodeTest, OneStrayStampLosesNoTrack) {
  start();
  placeRadar();
  auto messages = flight(10);
  std::size_t sector = 400;
  for (const double off : tws_runtime::kStrays) {
    messages[sector] = tws_runtime::withStrayStamp(messages[sector], off);
    sector += 20;
  }
  publish(messages);
  EXPECT_EQ(count("stray messages"), std::size(tws_runtime::kStrays));
  EXPECT_EQ(count("new runs"), 0U);
  EXPECT_EQ(published_.size(), 638U);
  std::set<std::uint32_t> uids;
  for (const auto& message : published_)
    for (const auto& track : message.tracks) {
      EXPECT_NE(track.state, tws_msgs::Track::DROPPED);
      uids.insert(track.uid);
    }
  EXPECT_EQ(uids.size(), 1U);
}

// If this fails, who remaps a radar's topic sees no tracks.
TEST_F(SsrTrackerNodeTest, TakesARadarUnderARemappedTopicAndNamesItAsConfigured) {
  start();
  placeRadar();
  auto messages = flight(10);
  for (auto& message : messages) message.radar = "myradar";
  publish(messages);
  ASSERT_EQ(published_.size(), 638U);
  EXPECT_EQ(published_.back().radar, "ssr");
  EXPECT_EQ(count("bad messages"), 0U);
}

TEST_F(SsrTrackerNodeTest, RefusesUnknownParameters) {
  EXPECT_THROW(start("{radars: [ssr]}"), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace track_correlator
