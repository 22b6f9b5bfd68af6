#include "range_gate_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace range_gate_tracker {
namespace {

RangeGateParams params() {
  RangeGateParams params;
  params.window = 20.0;
  params.background = Background::kNone;
  params.threshold = 1.0;
  params.damping_time = 0.2;
  params.gate_length = 1000.0;
  params.confirming_profiles = 3;
  params.coast_time = 1.0;
  params.widening_time = 4.0;
  params.sweep_dwell = 0.2;
  params.max_range = 20000.0;
  return params;
}

constexpr double kPeriod = 0.02;

/// A radar without noise whose gate is where the tracker wants it at once, and a point target.
class Radar {
 public:
  explicit Radar(const RangeGateParams& params) : tracker(params) {}

  RangeProfile look() {
    RangeProfile profile;
    profile.time = time += kPeriod;
    profile.range_min = gate.min;
    profile.bin_size = 2.0;
    profile.amplitude.assign(static_cast<std::size_t>((gate.max - gate.min) / 2.0), 0.0F);
    add(profile, target, power);
    add(profile, other, other_power);
    return profile;
  }

  GateReport step() {
    const GateReport report = tracker.process(look());
    gate = report.gate;
    return report;
  }

  GateReport run(double duration, double velocity = 0.0) {
    GateReport report;
    for (double spent = 0.0; spent < duration; spent += kPeriod) {
      target += velocity * kPeriod;
      report = step();
    }
    return report;
  }

  RangeGateTracker tracker;
  RangeInterval gate{5000.0, 6000.0};
  double time = 100.0;
  double target = 5500.0, power = 4.0;  // [m], [m²]
  double other = 0.0, other_power = 0.0;

 private:
  static void add(RangeProfile& profile, double range, double power) {
    if (power <= 0.0 || range < profile.range_min || range >= profile.rangeMax()) return;
    const auto bin = static_cast<std::size_t>((range - profile.range_min) / profile.bin_size);
    profile.amplitude[bin] = static_cast<float>(std::sqrt(power));
  }
};

TEST(RangeGateTracker, LocksOnATargetThatSomeProfilesAgreeOn) {
  Radar radar(params());
  EXPECT_EQ(radar.step().lock, Lock::kSearching);
  EXPECT_EQ(radar.step().lock, Lock::kSearching);
  const GateReport report = radar.step();
  EXPECT_EQ(report.lock, Lock::kLocked);
  EXPECT_NEAR(report.measured, 5500.0, 1.0);
  EXPECT_EQ(report.smoothed, report.measured);
  EXPECT_DOUBLE_EQ(report.power, 4.0);
  EXPECT_DOUBLE_EQ(report.quality, 1.0);
}

TEST(RangeGateTracker, DoesNotLockOnWhatJumpsAbout) {
  Radar radar(params());
  for (int i = 0; i < 50; ++i) {
    radar.target = 5200.0 + 300.0 * (i % 2);
    radar.gate = {5000.0, 6000.0};
    EXPECT_EQ(radar.step().lock, Lock::kSearching);
  }
}

// The purpose of it all: the gate follows the target.
TEST(RangeGateTracker, KeepsAFastTargetInsideTheGateLaggingAsTheFilterMust) {
  Radar radar(params());
  radar.run(0.1);
  const GateReport report = radar.run(60.0, 150.0);
  EXPECT_EQ(report.lock, Lock::kLocked);
  const double alpha = std::exp(-kPeriod / 0.2);
  EXPECT_NEAR(radar.target - report.smoothed, 150.0 * kPeriod * alpha / (1.0 - alpha), 2.0);  // a bin
  EXPECT_EQ(report.predicted, report.smoothed);
  EXPECT_NEAR(report.gate.centre(), report.predicted, 1e-9);
}

TEST(RangeGateTracker, FollowsTheReportThroughAnEmptyProfile) {
  Radar radar(params());
  const GateReport before = radar.run(20.0);
  radar.power = 0.0;
  const GateReport report = radar.step();
  EXPECT_EQ(report.lock, Lock::kCoasting);
  EXPECT_TRUE(std::isnan(report.measured));
  EXPECT_NEAR(report.smoothed, before.smoothed, 0.1);  // of a target at rest: the previous range, used again
  EXPECT_EQ(report.power, 0.0);
}

// A fade must not end the track, nor may the target outrun the gate meanwhile.
TEST(RangeGateTracker, FindsATargetAgainThatFadedWhileItFlewOn) {
  Radar radar(params());
  radar.run(0.1);
  radar.run(5.0, 150.0);
  radar.power = 0.5;  // below the threshold
  EXPECT_EQ(radar.run(0.9, 150.0).lock, Lock::kCoasting);
  radar.power = 4.0;
  EXPECT_EQ(radar.run(kPeriod, 150.0).lock, Lock::kLocked);
}

TEST(RangeGateTracker, GivesATargetUpAfterTheCoastTimeAndFindsItInTheWideningGate) {
  Radar radar(params());
  radar.run(2.0);
  radar.power = 0.0;
  EXPECT_EQ(radar.run(1.0).lock, Lock::kCoasting);
  const GateReport lost = radar.run(0.1);
  EXPECT_EQ(lost.lock, Lock::kSearching);
  EXPECT_TRUE(std::isnan(lost.smoothed));
  EXPECT_TRUE(std::isnan(lost.predicted));
  radar.run(2.0);
  radar.power = 4.0;
  radar.target = 6050.0;  // outside the usual gate
  const GateReport found = radar.run(0.1);
  EXPECT_EQ(found.lock, Lock::kLocked);
  EXPECT_NEAR(found.smoothed, 6050.0, 1.0);
  EXPECT_NEAR(found.gate.max - found.gate.min, 1000.0, 1e-6);
}

// 14 km away, in the time that one sweep of 20 places at 0.2 s takes.
TEST(RangeGateTracker, SweepsAllRangesForATargetThatIsGone) {
  Radar radar(params());
  radar.run(2.0);
  radar.target = 19500.0;
  radar.run(1.0 + 4.0);
  double time = 0.0;
  while (radar.step().lock != Lock::kLocked && time < 60.0) time += kPeriod;
  EXPECT_LT(time, 0.2 * 21);
  EXPECT_NEAR(radar.run(1.0).smoothed, 19500.0, 1.0);
}

// As the report has it, the brightest window wins wherever it is; with the limit the interferer does not.
TEST(RangeGateTracker, StaysWithItsTargetBesideABrighterOneOnlyWithAJumpLimit) {
  for (const bool limited : {false, true}) {
    RangeGateParams chosen = params();
    if (limited) chosen.jump_limit = 50.0;
    Radar radar(chosen);
    radar.run(1.0);
    radar.other = 5800.0;
    radar.other_power = 9.0;
    EXPECT_NEAR(radar.run(3.0).smoothed, limited ? 5500.0 : 5800.0, 2.0);
  }
}

// The other one comes the other way, twice as bright: whoever follows the brightest echo turns round with it.
TEST(RangeGateTracker, PassesAnInterfererWithTheKalmanPredictorAndAJumpLimit) {
  RangeGateParams chosen = params();
  chosen.predictor = Predictor::kKalman;
  chosen.jump_limit = 30.0;
  chosen.acceleration_density = 1.0;
  Radar radar(chosen);
  radar.run(0.1);
  radar.run(5.0, 150.0);
  radar.other = radar.target + 900.0;
  radar.other_power = 2.0 * radar.power;
  GateReport report;
  for (int i = 0; i < 300; ++i) {
    radar.other -= 150.0 * kPeriod;
    report = radar.run(kPeriod, 150.0);
  }
  EXPECT_NEAR(report.smoothed, radar.target, 5.0);
  EXPECT_LT(radar.other, radar.target - 800.0);
}

TEST(RangeGateTracker, PredictsAheadWithTheKalmanPredictor) {
  RangeGateParams chosen = params();
  chosen.predictor = Predictor::kKalman;
  chosen.prediction_time = 2.0;
  Radar radar(chosen);
  radar.run(0.1);
  const GateReport report = radar.run(10.0, 150.0);
  EXPECT_NEAR(report.predicted, radar.target + 300.0, 20.0);
  EXPECT_NEAR(report.rate, 150.0, 10.0);
}

std::string complaint(RangeGateTracker& tracker, const RangeProfile& profile) {
  try {
    tracker.process(profile);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

// A bad profile must leave no trace: what follows is as if it had never been.
TEST(RangeGateTracker, RefusesABadProfileWithAReasonAndChangesNothing) {
  Radar good(params()), spoilt(params());
  good.run(1.0, 100.0);
  spoilt.run(1.0, 100.0);
  const auto refuse = [&](const std::string& reason, const auto& spoil) {
    RangeProfile profile = spoilt.look();
    spoilt.time -= kPeriod;
    spoil(profile);
    const std::string said = complaint(spoilt.tracker, profile);
    EXPECT_NE(said.find(reason), std::string::npos) << said << "; expected: " << reason;
  };
  refuse("larger than the gate", [](RangeProfile& p) { p.amplitude.resize(9); });
  refuse("larger than the gate of 0", [](RangeProfile& p) { p.amplitude.clear(); });
  refuse("amplitude of bin 7 is nan", [](RangeProfile& p) { p.amplitude[7] = std::nanf(""); });
  refuse("not later", [](RangeProfile& p) { p.time -= kPeriod; });
  refuse("time is nan", [](RangeProfile& p) { p.time = std::nan(""); });
  refuse("bin_size is 0", [](RangeProfile& p) { p.bin_size = 0.0; });
  refuse("bin_size is nan", [](RangeProfile& p) { p.bin_size = std::nan(""); });
  refuse("range_min is inf", [](RangeProfile& p) { p.range_min = INFINITY; });
  const GateReport a = good.step(), b = spoilt.step();
  EXPECT_EQ(a.smoothed, b.smoothed);
  EXPECT_EQ(a.gate.min, b.gate.min);
  EXPECT_EQ(a.power, b.power);
}

}  // namespace
}  // namespace range_gate_tracker
