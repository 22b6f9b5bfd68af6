#include <esa_frame_builder/frame_builder_node.h>
#include <esa_frame_builder/mfa_stub_node.h>

#include <tws_runtime/defaults.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <iterator>

#include "esa_chain_test_helpers.h"

namespace esa_frame_builder {
namespace {

class MfaStubNodeTest : public EsaChain {
 protected:
  void start(const std::string& builder = "{}", const std::string& tracker = "{}") {
    builder_ = std::make_unique<FrameBuilderNode>(graph_.addNode("frame_builder", YAML::Load(builder)));
    tracker_ = std::make_unique<MfaStubNode>(graph_.addNode("mfa_stub", YAML::Load(tracker)));
  }

  // An aircraft 50 km ahead, 0.01 to the right and 0.02 up, that comes nearer at 200 m/s; one dwell on it a period.
  Dwell look(double time) const { return dwellAt(time, 0.01, 0.02, {measurementAt(50e3 - 200.0 * time, 0.01, 0.02)}); }

  void fly(int periods, double from = 0.0) {
    for (int n = 1; n <= periods; ++n) publish(report(from + 0.1 * n, {look(from + 0.1 * n - 0.05)}));
  }

  std::unique_ptr<FrameBuilderNode> builder_;
  std::unique_ptr<MfaStubNode> tracker_;
};

TEST_F(MfaStubNodeTest, AnswersEachReportWithItsStampAndSaysTheAircraftWhereItIs) {
  start();
  placeArray();
  fly(30);
  ASSERT_EQ(databases_.size(), 30U);
  ASSERT_EQ(tracks_.size(), 30U);
  for (int n = 0; n < 30; ++n) {
    EXPECT_EQ(databases_[static_cast<std::size_t>(n)].header.stamp, tws_runtime::toTime(0.1 * (n + 1)));
    EXPECT_EQ(tracks_[static_cast<std::size_t>(n)].sequence, static_cast<std::uint32_t>(n));
  }
  ASSERT_EQ(databases_.back().tracks.size(), 1U);
  const tws_msgs::TrackDatabaseEntry& entry = databases_.back().tracks[0];
  const double range = 50e3 - 200.0 * 3.0;
  EXPECT_EQ(entry.stamp, tws_runtime::toTime(3.0));
  EXPECT_NEAR(entry.position.x, range * std::sqrt(1.0 - 0.0005), 10.0);
  EXPECT_NEAR(entry.position.y, -range * 0.01, 20.0);
  EXPECT_NEAR(entry.position.z, range * 0.02, 20.0);
  EXPECT_NEAR(entry.velocity.x, -200.0, 20.0);
  ASSERT_EQ(tracks_.back().tracks.size(), 1U);
  EXPECT_EQ(tracks_.back().tracks[0].state, tws_msgs::Track::FIRM);
  EXPECT_NEAR(tracks_.back().tracks[0].azimuth, 1.5708 + 0.01, 1e-3);
}

TEST_F(MfaStubNodeTest, WaitsForTheArraysPose) {
  start();
  fly(10);
  EXPECT_TRUE(databases_.empty());
  placeArray();
  fly(1, 1.0);
  EXPECT_EQ(databases_.size(), 11U);
  EXPECT_EQ(count("unknown sites"), 0U);
}

// If this fails, a bag played twice shows the aircraft of the first time.
TEST_F(MfaStubNodeTest, BeginsAnewWhenTimeGoesFarBack) {
  start();
  placeArray();
  fly(80);
  EXPECT_EQ(databases_.back().tracks.size(), 1U);
  next_period_ = 0;
  const std::size_t first = databases_.size();
  fly(15);
  EXPECT_EQ(databases_.size(), first + 15U);
  EXPECT_TRUE(databases_[first].tracks.empty());
  EXPECT_EQ(count("new runs"), 1U);
}

// If this fails, one stamp that was damaged on its way costs all tracks: of the reports, or of the frames between the
// two nodes.
TEST_F(MfaStubNodeTest, OneStrayStampLosesNoTrack) {
  start();
  placeArray();
  auto frames = graph_.addNode("between").advertise<tws_msgs::Frame>("/esa/frames");
  double time = 100.0;
  for (const double off : tws_runtime::kStrays) {
    fly(20, time);
    time += 2.1;
    publish(tws_runtime::withStrayStamp(report(time, {}), off));
    tws_msgs::Frame stray = frames_.back();
    stray.through = tws_runtime::strayed(stray.through, off);
    frames.publish(stray);
    graph_.drain();
  }
  fly(20, time);
  EXPECT_EQ(databases_.size(), 100U);
  EXPECT_EQ(count("new runs"), 0U);
  EXPECT_GE(count("stray messages"), std::size(tws_runtime::kStrays));
  for (const auto& message : tracks_)
    for (const auto& track : message.tracks) EXPECT_NE(track.state, tws_msgs::Track::DROPPED);
  ASSERT_EQ(tracks_.back().tracks.size(), 1U);
  EXPECT_EQ(tracks_.back().tracks[0].uid, tracks_[10].tracks[0].uid);
}

// If this fails, nobody is told that a frame builder sends nonsense, or one bad frame costs the good ones.
TEST_F(MfaStubNodeTest, CountsFramesThatBreakTheRulesAndGoesOn) {
  tracker_ = std::make_unique<MfaStubNode>(graph_.addNode("mfa_stub"));
  placeArray();
  auto frames = graph_.addNode("builder").advertise<tws_msgs::Frame>("/esa/frames");
  const auto send = [&](std::uint32_t number, double time, std::uint8_t status, const std::string& radar = "esa") {
    tws_msgs::Frame message;
    if (status != tws_msgs::Frame::HEARTBEAT) message.dwells.push_back(toMessage(look(time)));
    message.radar = radar;
    message.header.frame_id = "esa";
    message.frame = number;
    message.status = status;
    message.through = tws_runtime::toTime(time);
    frames.publish(message);
    graph_.drain();
  };
  using tws_msgs::Frame;
  for (std::uint32_t n = 0; n < 6; ++n) send(n, 10.0 + 0.1 * n, Frame::CLOSED);
  send(9, 10.6, Frame::CLOSED);  // three are missing
  send(10, 10.7, Frame::CLOSED, "other");
  send(10, 10.5, Frame::CLOSED);  // late
  send(0, 10.7, Frame::HEARTBEAT);
  EXPECT_EQ(count("broken frame rules"), 1U);
  EXPECT_EQ(count("bad messages"), 1U);
  EXPECT_EQ(count("late messages"), 1U);
  EXPECT_EQ(count("frames"), 7U);
  ASSERT_EQ(databases_.size(), 1U);
  EXPECT_EQ(databases_[0].tracks.size(), 1U);
}

TEST_F(MfaStubNodeTest, SaysTheSameInEveryRun) {
  start();
  placeArray();
  for (int run = 0; run < 2; ++run) {
    next_period_ = 0;
    fly(80);
  }
  ASSERT_EQ(databases_.size(), 160U);
  for (std::size_t n = 0; n < 80; ++n) {
    ASSERT_EQ(databases_[n].tracks.size(), databases_[80 + n].tracks.size());
    for (std::size_t i = 0; i < databases_[n].tracks.size(); ++i)
      EXPECT_EQ(databases_[n].tracks[i], databases_[80 + n].tracks[i]) << n;
  }
}

TEST_F(MfaStubNodeTest, HasTheDefaultsOfTheShippedFile) {
  const YAML::Node shipped = tws_runtime::loadParameterFile(ESA_CONFIG "/mfa_stub.yaml");
  const auto departures = tws_runtime::departuresFromDefaults([&] { MfaStubNode(graph_.addNode("shipped", shipped)); });
  EXPECT_EQ(departures, std::vector<std::string>{});
}

TEST_F(MfaStubNodeTest, RefusesUnknownParameters) {
  EXPECT_THROW(start("{}", "{algorithm: 3}"), tws_runtime::ParameterError);
  EXPECT_THROW(MfaStubNode(graph_.addNode("wrong", YAML::Load("{initiation_hits: 9}"))), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace esa_frame_builder
