#include "core/track_life.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

/// Five false plots a scan within 10 km: 5 / (π·10⁸) = 1.5915e-8 per m².
constexpr double kFalsePlots = 5.0, kFalseDensity = kFalsePlots / (3.14159265358979 * 1e8);

Track trackUpdatedAt(double first, double last) {
  Track track;
  track.first_time = first;
  track.last_update = last;
  track.updates = 3;
  return track;
}

/// The letter: TFIX 20 s; TNMAX 9 s and TTMAX 20 s are ours.
class TimersTest : public testing::Test {
 protected:
  TrackJudge judge_{AditParams::named("nrl7952")};
};

// If this fails, the operator sees tentative tracks as firm, or waits longer than the report says.
TEST_F(TimersTest, FirmIsATrackThatIsUpdatedLaterThan20SecondsAfterItsFirstDetection) {
  Track track = trackUpdatedAt(100.0, 120.0);
  EXPECT_FALSE(judge_.updated(track, 0, 0.0, kFalseDensity));
  EXPECT_FALSE(track.firm);
  track.last_update = 120.1;
  EXPECT_TRUE(judge_.updated(track, 0, 0.0, kFalseDensity));
  EXPECT_TRUE(track.firm);
  EXPECT_TRUE(judge_.confirmed(track));
  EXPECT_FALSE(judge_.updated(track, 0, 0.0, kFalseDensity));  // Only the first time is news.
}

TEST_F(TimersTest, BeingAliveFor20SecondsIsNotEnoughToBeFirm) {
  Track track = trackUpdatedAt(100.0, 114.0);
  EXPECT_FALSE(judge_.missed(track, 0, 122.0));
  EXPECT_FALSE(track.firm);
}

TEST_F(TimersTest, ATentativeTrackIsDroppedAfter9SecondsAndAFirmOneAfter20) {
  Track track = trackUpdatedAt(100.0, 110.0);
  EXPECT_FALSE(judge_.missed(track, 0, 119.0));
  EXPECT_TRUE(judge_.missed(track, 0, 119.1));
  track.firm = true;
  EXPECT_FALSE(judge_.missed(track, 0, 130.0));
  EXPECT_TRUE(judge_.missed(track, 0, 130.1));
}

class ExistenceTest : public testing::Test {
 protected:
  ExistenceTest() {
    ExistenceParams& e = params_.existence;
    e.new_targets = 1.0;
    e.firm_probability = 0.99;
    e.firm_updates = 3;
    e.moving_evidence = 2.0;
    e.drop_probability = 0.01;
    e.doubt_probability = 0.5;
    e.tentative_drop_fraction = 0.03;
    e.detection_probability = 0.85;
    e.survival_time = 1e9;  // Nobody leaves, but where a test says so.
  }

  Track started() {
    Track track = trackUpdatedAt(100.0, 100.0);
    judge().started(track, kFalsePlots);
    return track;
  }
  TrackJudge judge() const { return TrackJudge(params_); }

  AditParams params_ = AditParams::named("default");
};

TEST_F(ExistenceTest, ANewTrackHasTheChanceOfNewTargetsAgainstFalsePlots) {
  EXPECT_NEAR(started().existence, 1.0 / 6.0, 1e-6);
  EXPECT_NEAR(started().detection_probability[0], 0.85, 1e-6);
}

// Odds 1/5 · 0.85 · 4e-8 / 1.5915e-8 = 0.42726; chance 0.29936.
TEST_F(ExistenceTest, ADetectionWeighsByItsLikelihoodAgainstFalsePlots) {
  Track track = started();
  judge().updated(track, 0, std::log(4e-8), kFalseDensity);
  const double odds = 0.2 * 0.85 * 4e-8 / kFalseDensity;
  EXPECT_NEAR(odds, 0.42726, 1e-4);
  EXPECT_NEAR(track.existence, odds / (1.0 + odds), 1e-5);
}

// Odds 1/5 · 0.15 = 0.03; chance 0.02913. Then it has learned a detection chance of 0.765: odds · 0.235.
TEST_F(ExistenceTest, AMissedIlluminationLowersTheChanceByWhatADetectionWasWorth) {
  Track track = started();
  EXPECT_FALSE(judge().missed(track, 0, 106.0));
  EXPECT_NEAR(track.existence, 0.03 / 1.03, 1e-5);
  EXPECT_NEAR(track.detection_probability[0], 0.765, 1e-5);
  judge().missed(track, 0, 112.0);
  EXPECT_NEAR(track.existence, 0.03 * 0.235 / (1.0 + 0.03 * 0.235), 1e-5);
}

// 3 % of 1/6 is 0.005: two misses give 0.0070, three with a learned chance of 0.6885 0.0022.
TEST_F(ExistenceTest, ATentativeTrackGoesWhenItsChanceHasFallenTo3PercentOfTheFirst) {
  Track track = started();
  EXPECT_FALSE(judge().missed(track, 0, 106.0));
  EXPECT_FALSE(judge().missed(track, 0, 112.0));
  EXPECT_TRUE(judge().missed(track, 0, 118.0));
}

/// Surely there and surely moving, at a velocity that is known to 2 m/s.
Track surelyMoving(double speed) {
  Track track = trackUpdatedAt(100.0, 112.0);
  track.existence = 0.999F;
  track.detection_probability.fill(0.9F);
  track.fixed.moving_evidence = 100.0;
  auto& filter = track.filter.emplace<tws::MultipleModelFilter>();
  filter.start({0.0, 20e3, {100.0, 0.0, 100.0}}, tws::MultipleModelParams{});
  filter.setVelocity(speed, 0.0, {4.0, 0.0, 4.0});
  return track;
}

// If this fails, every bird and every car at an airport is a firm track, or what has flown in and slows down is none.
TEST_F(ExistenceTest, AFirmTrackMustOnceHaveBeenSurelySoFast) {
  params_.existence.firm_speed = 20.0;
  Track slow = surelyMoving(21.0);  // one standard deviation short
  EXPECT_FALSE(judge().updated(slow, 0, std::log(4e-8), kFalseDensity));
  Track fast = surelyMoving(23.0);
  EXPECT_TRUE(judge().updated(fast, 0, std::log(4e-8), kFalseDensity));
  std::get<tws::MultipleModelFilter>(fast.filter).setVelocity(5.0, 0.0, {4.0, 0.0, 4.0});
  judge().updated(fast, 0, std::log(4e-8), kFalseDensity);
  EXPECT_TRUE(fast.firm);
}

TEST_F(ExistenceTest, ATargetMayHaveGoneInTheMeantime) {
  params_.existence.survival_time = 50.0;
  Track track = started();
  track.existence = 0.8F;
  track.last_update = 110.0;
  judge().updated(track, 0, std::log(kFalseDensity / 0.85), kFalseDensity);  // A detection that says nothing: ratio 1.
  EXPECT_NEAR(track.existence, 0.8 * std::exp(-10.0 / 50.0), 1e-5);
}

// If this fails, false tracks become firm, or clutter does.
TEST_F(ExistenceTest, FirmNeedsChanceDetectionsAndMovementTogether) {
  const auto firm = [&](double chance, int updates, double moving) {
    Track track = started();
    track.existence = static_cast<float>(chance);
    track.updates = updates;
    track.fixed.moving_evidence = moving;
    judge().updated(track, 0, std::log(kFalseDensity / 0.85), kFalseDensity);
    return track.firm;
  };
  EXPECT_TRUE(firm(0.995, 3, 2.1));
  EXPECT_FALSE(firm(0.985, 3, 2.1));
  EXPECT_FALSE(firm(0.995, 2, 2.1));
  EXPECT_FALSE(firm(0.995, 3, 1.9));
}

TEST_F(ExistenceTest, AFirmTrackInDoubtShowsAsTentativeAndGoesBelowOnePercent) {
  Track track = started();
  track.firm = true;
  track.existence = 0.9F;
  EXPECT_TRUE(judge().confirmed(track));
  EXPECT_FALSE(judge().missed(track, 0, 106.0));  // Odds 9 · 0.15 = 1.35.
  EXPECT_TRUE(judge().confirmed(track));
  EXPECT_FALSE(judge().missed(track, 0, 112.0));  // 1.35 · 0.235 = 0.317.
  EXPECT_FALSE(judge().confirmed(track));
  EXPECT_FALSE(judge().missed(track, 0, 118.0));  // · 0.3115 = 0.0988.
  EXPECT_FALSE(judge().missed(track, 0, 124.0));  // · 0.38035 = 0.0376.
  EXPECT_FALSE(judge().missed(track, 0, 130.0));  // · 0.44232 = 0.0166.
  EXPECT_TRUE(judge().missed(track, 0, 136.0));   // · 0.49808 = 0.0083.
}

// Weighed at 0.6, 40 % of it missed: it has aged e^(-10/50) since, and learned 0.85 + 0.1 (0.6 - 0.85).
TEST_F(ExistenceTest, AWeighedTrackHasTheChanceThatTheWeighingLeavesIt) {
  params_.existence.survival_time = 50.0;
  Track track = started();
  EXPECT_FALSE(judge().weighed(track, 0, 110.0, 0.6, 0.4));
  EXPECT_NEAR(track.existence, 0.6 * std::exp(-10.0 / 50.0), 1e-5);
  EXPECT_NEAR(track.detection_probability[0], 0.825, 1e-5);
}

// If this fails, a track becomes firm on a scan on which it was rather missed.
TEST_F(ExistenceTest, AWeighedTrackBecomesFirmWhenItWasRatherDetected) {
  const auto firm = [&](double missed) {
    Track track = started();
    track.updates = 3;
    track.fixed.moving_evidence = 2.1;
    return judge().weighed(track, 0, 100.0, 0.999, missed);
  };
  EXPECT_TRUE(firm(0.4));
  EXPECT_FALSE(firm(0.6));
}

// If this fails, one detection too good to be true makes a track immortal.
TEST_F(ExistenceTest, NoChanceBecomesCertainty) {
  Track track = started();
  for (int i = 0; i < 50; ++i) judge().updated(track, 0, 100.0, kFalseDensity);
  EXPECT_LT(track.existence, 1.0F);
  int misses = 0;
  while (!judge().missed(track, 0, 100.0)) ASSERT_LT(++misses, 100);
}

}  // namespace
}  // namespace adit_tracker
