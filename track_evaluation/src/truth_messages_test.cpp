#include "truth_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "message_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, a tracker is blamed for what no radar saw, or praised for tracks of rocks.

using tws_msgs::TruthTarget;

std::vector<TruthState> truths(const std::vector<TruthTarget>& targets) {
  return truthsOf(truthMessage(1.0, targets), Eigen::Vector3d::Zero(), TruthFilter());
}

TEST(TruthMessages, AnAircraftIsRequiredWhereTheBestRadarSeesItWell) {
  const auto states = truths({aircraft(1, 0, 0, 0, 0.8), aircraft(2, 0, 0, 0, 0.79)});
  ASSERT_EQ(states.size(), 2U);
  EXPECT_TRUE(states[0].required);
  EXPECT_FALSE(states[1].required);
}

// An array is not asked for what only the rotating radars see, nor they for what only the array sees.
TEST(TruthMessages, AnAircraftIsRequiredOnlyByTheRadarsThatMakeTheCover) {
  tws_msgs::Truth message = truthMessage(1.0, {aircraft(1, 0, 0)});
  message.radars = {"sps12", "sps39", "esa"};
  message.targets[0].detection_probability = {0.1, 0.2, 0.9};
  const auto required = [&](const std::vector<std::string>& radars) {
    TruthFilter filter;
    filter.radars = radars;
    return truthsOf(message, Eigen::Vector3d::Zero(), filter).at(0).required;
  };
  EXPECT_TRUE(required({"esa"}));
  EXPECT_FALSE(required({"sps12", "sps39"}));
  EXPECT_TRUE(required({}));
  EXPECT_TRUE(required({"ssr"}));
}

TEST(TruthMessages, ASlowMoverIsToleratedAndClutterIsNoTruth) {
  TruthTarget boat = aircraft(1, 0, 0), rock = aircraft(2, 0, 0);
  boat.kind = TruthTarget::SLOW_MOVER;
  rock.kind = TruthTarget::CLUTTER;
  const auto states = truths({boat, rock});
  ASSERT_EQ(states.size(), 1U);
  EXPECT_FALSE(states[0].required);
}

TEST(TruthMessages, ATargetThatNoRadarMentionsIsRequired) {
  TruthTarget target = aircraft(1, 0, 0);
  target.detection_probability.clear();
  EXPECT_TRUE(truths({target}).at(0).required);
}

TEST(TruthMessages, LeavesOutATargetThatIsNoNumber) {
  TruthTarget bad = aircraft(1, 0, 0);
  bad.velocity.z = std::nan("");
  EXPECT_EQ(faultOf(bad), "velocity.z is nan");
  EXPECT_EQ(truths({bad, aircraft(2, 0, 0)}).size(), 1U);
}

TEST(TruthMessages, KnowsTheTargetOnBothPlanes) {
  const TruthState state = truths({aircraft(1, 3000, 0, 4000)}).at(0);
  EXPECT_NEAR(state.ground.position.x(), 3000.0, 1e-9);
  EXPECT_NEAR(state.slant.position.x(), 5000.0, 1e-9);
  EXPECT_NEAR(state.height, 4000.0, 1.0);
}

}  // namespace
// The plane is 3139 m below the sea's level at 200 km. If this fails, every distant height counts as wrong.
TEST(TruthMessages, KnowsTheHeightAboveARoundEarth) {
  EXPECT_NEAR(truths({aircraft(1, 200e3, 0, 6861)}).at(0).height, 10000.0, 10.0);
}

}  // namespace track_evaluation
