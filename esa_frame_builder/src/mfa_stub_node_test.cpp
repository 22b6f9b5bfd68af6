#include <esa_frame_builder/frame_builder_node.h>
#include <esa_frame_builder/mfa_stub_node.h>

#include <tws_runtime/parameters.h>

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
  EXPECT_EQ(count("unknown poses"), 0U);
}

// If this fails, a bag played twice shows the aircraft of the first time.
TEST_F(MfaStubNodeTest, BeginsAnewWhenTimeGoesFarBack) {
  start();
  placeArray();
  fly(80);
  EXPECT_EQ(databases_.back().tracks.size(), 1U);
  next_period_ = 0;
  fly(1);
  EXPECT_TRUE(databases_.back().tracks.empty());
  EXPECT_EQ(count("new runs"), 1U);
}

TEST_F(MfaStubNodeTest, RefusesUnknownParameters) {
  EXPECT_THROW(start("{}", "{algorithm: 3}"), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace esa_frame_builder
