#include "range_gate_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <string>
#include <utility>

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

// If this fails, a tracker that once took noise for a target shows a firm track there for minutes, and its own target
// goes by.
TEST(RangeGateTracker, GivesUpWhatJumpsAboutFromOneProfileToTheNext) {
  Radar radar(params());
  radar.run(1.0);
  GateReport report;
  for (int i = 0; i < 55; ++i) {
    radar.target = 5300.0 + 400.0 * (i % 2);
    report = radar.step();
    EXPECT_EQ(report.lock, i < 50 ? Lock::kLocked : Lock::kSearching) << i;
  }
}

// A target of which every third profile shows something else is one all the same.
TEST(RangeGateTracker, KeepsATargetThatIsSometimesOutshone) {
  RangeGateParams chosen = params();
  chosen.confirming_profiles = 2;
  Radar radar(chosen);
  for (int i = 0; i < 500; ++i) {
    radar.other = 5800.0;
    radar.other_power = i % 3 == 2 ? 9.0 : 0.0;
    const Lock lock = radar.step().lock;
    EXPECT_TRUE(lock == Lock::kLocked || i < 2) << i;
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

/// Looks where it was told to as many profiles ago as it has `gates` at first, and beyond `noise_from` there is always
/// something, now here, now there.
class NoisyRadar {
 public:
  NoisyRadar(const RangeGateParams& params, std::deque<RangeInterval> gates, double noise_from)
      : radar_(params), gates_(std::move(gates)), noise_from_(noise_from) {}

  /// Seconds until it is locked on a target at `range`; `at_most`: it is not.
  double timeToLock(double range, double at_most) {
    radar_.target = range;
    for (double time = 0.0; time < at_most; time += kPeriod) {
      radar_.gate = gates_.front();
      gates_.pop_front();
      radar_.other_power = radar_.gate.max > noise_from_ ? 2.0 : 0.0;
      radar_.other = radar_.gate.max - 100.0 - 150.0 * static_cast<double>(++looks_ % 5);
      const GateReport report = radar_.step();
      gates_.push_back(report.gate);
      if (report.lock == Lock::kLocked && std::abs(report.smoothed - range) < 10.0) return time;
    }
    return at_most;
  }

 private:
  Radar radar_;
  std::deque<RangeInterval> gates_;
  double noise_from_;
  int looks_ = 0;
};

// If this fails, a radar that follows its gate with a delay may look at a target and away from it for good.
TEST(RangeGateTracker, LocksOnThoughTheRadarIsStillOnItsWayFromElsewhere) {
  const RangeInterval here{5000.0, 6000.0}, there{9000.0, 10000.0};
  EXPECT_LT(NoisyRadar(params(), {here, here, there}, 8000.0).timeToLock(5500.0, 5.0), 0.3);
}

// If this fails, the sweep stays where the noise is above the threshold, and a target elsewhere is never found. One
// sweep of 20 places takes 4 s, and each of the ten with noise is left after as long again.
TEST(RangeGateTracker, SweepsOnWhereThereIsOnlyNoise) {
  const RangeInterval far{14000.0, 15000.0};
  EXPECT_LT(NoisyRadar(params(), {far, far, far}, 10000.0).timeToLock(2500.0, 60.0), 4.0 + 4.0 + 10 * 0.2 + 1.0);
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
