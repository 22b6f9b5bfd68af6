#include <tws_core/rotation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

using Turning = std::function<double(double)>;  // true unwrapped azimuth [rad] at a time [s]

Turning even(double period, double phase) {
  return [=](double time) { return phase + kTwoPi * time / period; };
}

// Plots at random times from `start` to `end`, `rate` a second, with azimuth noise; a share `false_share` of
// them at any azimuth.
TimedAzimuths plotsOf(std::mt19937_64& generator, const Turning& beam, double start, double end, double rate,
                      double false_share = 0.0, double noise = radians(0.3)) {
  std::normal_distribution<double> error(0.0, noise);
  TimedAzimuths plots;
  for (int left = static_cast<int>((end - start) * rate); left > 0; --left) {
    const double time = uniform(generator, start, end);
    const bool is_false = uniform(generator, 0.0, 1.0) < false_share;
    const double azimuth = is_false ? uniform(generator, 0.0, kTwoPi) : beam(time) + error(generator);
    plots.push_back({time, wrapTwoPi(azimuth)});
  }
  return plots;
}

double worstError(const Rotation& rotation, const Turning& beam, double start, double end) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double time = start + (end - start) * i / 1000.0;
    worst = std::max(worst, std::abs(angularDifference(rotation.unwrappedAt(time), beam(time))));
  }
  return worst;
}

double medianResidual(const Rotation& rotation, const TimedAzimuths& plots) {
  std::vector<double> residuals;
  for (const TimedAzimuth& plot : plots) {
    residuals.push_back(std::abs(angularDifference(plot.azimuth, rotation.unwrappedAt(plot.time))));
  }
  std::sort(residuals.begin(), residuals.end());
  return residuals[residuals.size() / 2];
}

void expectMonotoneWithInverse(const Rotation& rotation, double start, double end) {
  double before = rotation.unwrappedAt(start - 1.0);
  for (int i = 0; i <= 1000; ++i) {
    const double time = start + (end - start) * i / 1000.0;
    const double azimuth = rotation.unwrappedAt(time);
    ASSERT_GT(azimuth, before) << time;
    ASSERT_NEAR(rotation.timeAt(azimuth), time, 1e-6);
    before = azimuth;
  }
}

TEST(Rotation, TurnsEvenlyWhenPeriodAndPhaseAreGiven) {
  const Rotation rotation = Rotation::uniform(8.0, kPi / 2.0);
  EXPECT_DOUBLE_EQ(rotation.period(), 8.0);
  EXPECT_DOUBLE_EQ(rotation.unwrappedAt(0.0), kPi / 2.0);
  EXPECT_NEAR(rotation.unwrappedAt(6.0), kTwoPi, 1e-12);
  EXPECT_NEAR(rotation.unwrappedAt(-2.0), 0.0, 1e-12);
  EXPECT_NEAR(rotation.timeAt(kTwoPi * 100.0), 798.0, 1e-9);
}

// Half or twice the period would put every plot into the wrong scan.
TEST(Rotation, IsFoundForEveryPeriodFromMarineToLongRangeRadars) {
  auto generator = seededGenerator();
  for (const double period :
       {0.2, 0.4, 1.0, 1.25, 2.4, 4.008, 6.0, 8.0, 10.0, 12.5, 15.9, 20.0, 30.0, 45.0, 60.0, 120.0}) {
    for (const double per_turn : {4.0, 40.0}) {
      const Turning beam = even(period, uniform(generator, 0.0, kTwoPi));
      const double end = 40.0 * period;
      const Rotation rotation = Rotation::fromPlots(plotsOf(generator, beam, 0.0, end, per_turn / period));
      EXPECT_NEAR(rotation.period(), period, 2e-4 * period) << per_turn << " plots a turn";
      // Sixteen plots or more make a line: its end is known to 2 · 0.3° / √16, here with a margin of four.
      EXPECT_LT(worstError(rotation, beam, 0.0, end), radians(0.6)) << period << " s, " << per_turn << " plots a turn";
    }
  }
}

TEST(Rotation, IsFoundInSpiteOfThreeInTenPlotsAtOddAzimuths) {
  auto generator = seededGenerator();
  for (const double period : {1.0, 6.0, 60.0}) {
    const Turning beam = even(period, 1.0);
    const Rotation rotation = Rotation::fromPlots(plotsOf(generator, beam, 0.0, 60.0 * period, 20.0 / period, 0.3));
    EXPECT_LT(worstError(rotation, beam, 0.0, 60.0 * period), radians(0.3)) << period;
  }
}

// Few ships on a quiet day: their azimuths fit fractions of the period nearly as well as the period.
TEST(Rotation, IsFoundFromThreeTargetsAmongFalsePlots) {
  auto generator = seededGenerator();
  for (int trial = 0; trial < 100; ++trial) {
    const double period = std::exp(uniform(generator, 0.0, std::log(60.0)));
    const Turning beam = even(period, 1.0);
    TimedAzimuths plots = plotsOf(generator, beam, 0.0, 30.0 * period, 0.75 / period, 1.0);  // a false one in five
    for (int target = 0; target < 3; ++target) {
      const double share = uniform(generator, 0.0, 1.0);
      for (int turn = 0; turn < 30; ++turn) {
        const double time = (turn + share) * period;
        plots.push_back({time, wrapTwoPi(beam(time) + uniform(generator, -0.005, 0.005))});
      }
    }
    const Rotation rotation = Rotation::fromPlots(plots);
    EXPECT_NEAR(rotation.period(), period, 1e-3 * period) << "trial " << trial;
    EXPECT_LT(worstError(rotation, beam, 0.0, 30.0 * period), radians(1.0)) << "trial " << trial << ", " << period;
  }
}

// Wind and mains make real antennas hunt; a beam held to its mean period would be turns off after an hour.
TEST(Rotation, FollowsSlowDriftOfAPercent) {
  auto generator = seededGenerator();
  const double slow = kTwoPi / 900.0;  // one hunt in 15 minutes, rate ± 1 %
  const Turning beam = [=](double t) { return 0.5 + kTwoPi / 4.0 * (t + 0.01 / slow * std::sin(slow * t)); };
  const Rotation rotation = Rotation::fromPlots(plotsOf(generator, beam, 0.0, 3600.0, 8.0));
  // A line through 40 s of this misses by at most φ''·L²·(1/24 + 1/32) = 1.1e-4 · 1600 · 0.073 = 0.73°, plus noise.
  EXPECT_LT(worstError(rotation, beam, 0.0, 3600.0), radians(1.0));
  EXPECT_NEAR(rotation.unwrappedAt(3600.0) - rotation.unwrappedAt(0.0), beam(3600.0) - beam(0.0), radians(2.0));
  expectMonotoneWithInverse(rotation, -100.0, 3700.0);
}

TEST(Rotation, CountsTheTurnsOverGapsOfAMinute) {
  auto generator = seededGenerator();
  for (const double period : {1.0, 4.0}) {
    const double slow = kTwoPi / 900.0;
    const Turning beam = [=](double t) { return kTwoPi / period * (t + 0.002 / slow * std::sin(slow * t)); };
    TimedAzimuths plots;
    for (double start = 0.0; start < 900.0; start += 180.0) {
      const TimedAzimuths part = plotsOf(generator, beam, start, start + 120.0, 5.0);
      plots.insert(plots.end(), part.begin(), part.end());
    }
    const Rotation rotation = Rotation::fromPlots(plots);
    for (double start = 0.0; start < 900.0; start += 180.0) {
      // The end of a line through 40 s is off by φ''·L²/12 = 2.2e-5 · 1600 / 12 = 0.17°, and noise.
      EXPECT_LT(worstError(rotation, beam, start, start + 120.0), radians(0.5)) << period << " s from " << start;
      EXPECT_NEAR(rotation.unwrappedAt(start + 120.0) - rotation.unwrappedAt(0.0), beam(start + 120.0) - beam(0.0),
                  0.1);
    }
    expectMonotoneWithInverse(rotation, 0.0, 900.0);
  }
}

// One ship alone fits every fraction of the period as well.
TEST(Rotation, OfPlotsOfOneTargetHasTheLongestPeriodThatFits) {
  TimedAzimuths plots;
  for (int turn = 0; turn < 40; ++turn) plots.push_back({1.0 + 2.5 * turn, radians(144.0)});
  const Rotation rotation = Rotation::fromPlots(plots);
  EXPECT_NEAR(rotation.period(), 2.5, 1e-6);
  EXPECT_NEAR(rotation.unwrappedAt(1.0), radians(144.0), 1e-6);
}

TEST(Rotation, DoesNotDependOnTheOrderOfThePlotsNorOnTheEpoch) {
  auto generator = seededGenerator();
  constexpr double kEpoch = 1.7e9;
  TimedAzimuths plots = plotsOf(generator, even(6.0, 0.0), 0.0, 300.0, 3.0);
  const Rotation rotation = Rotation::fromPlots(plots);
  std::shuffle(plots.begin(), plots.end(), generator);
  EXPECT_EQ(Rotation::fromPlots(plots).unwrappedAt(100.0), rotation.unwrappedAt(100.0));
  for (TimedAzimuth& plot : plots) plot.time += kEpoch;
  EXPECT_NEAR(Rotation::fromPlots(plots).unwrappedAt(kEpoch + 100.0), rotation.unwrappedAt(100.0), 1e-5);
}

// If this fails, every track ends when an antenna changes its speed, is restarted, or its radar's clock is set.
TEST(Rotation, GoesOnBehindABreak) {
  auto generator = seededGenerator();
  struct Case {
    double period, jump;
  };
  for (const Case& c : {Case{5.0, 0.0}, Case{3.2, 0.0}, Case{4.0, 1.5}, Case{4.0, kPi}}) {
    const Turning before = even(4.0, 1.0);
    const Turning after = [&](double t) { return before(300.0) + c.jump + kTwoPi * (t - 300.0) / c.period; };
    TimedAzimuths plots = plotsOf(generator, before, 0.0, 300.0, 5.0, 0.1);
    const TimedAzimuths more = plotsOf(generator, after, 300.0, 600.0, 5.0, 0.1);
    plots.insert(plots.end(), more.begin(), more.end());
    const Rotation rotation = Rotation::fromPlots(plots);
    ASSERT_EQ(rotation.breaks().size(), 1U) << c.period << ' ' << c.jump;
    EXPECT_NEAR(rotation.breaks()[0].time, 300.0, 4.0);
    EXPECT_LT(worstError(rotation, before, 0.0, 296.0), radians(1.0)) << c.period << ' ' << c.jump;
    EXPECT_LT(worstError(rotation, after, 304.0, 600.0), radians(1.0)) << c.period << ' ' << c.jump;
    expectMonotoneWithInverse(rotation, 0.0, 600.0);
  }
}

// If this fails, a radar whose clock is set, or whose antenna is restarted, in its first minute has no track until
// then.
TEST(Rotation, BeginsAndEndsWithAShortPiece) {
  auto generator = seededGenerator();
  for (const double at : {12.0, 20.0, 280.0, 288.0}) {
    const Turning before = even(4.0, 1.0);
    const Turning after = even(4.0, 1.0 + kPi / 2.0);
    TimedAzimuths plots = plotsOf(generator, before, 0.0, at, 5.0);
    const TimedAzimuths more = plotsOf(generator, after, at, 300.0, 5.0);
    plots.insert(plots.end(), more.begin(), more.end());
    const Rotation rotation = Rotation::fromPlots(plots);
    EXPECT_EQ(rotation.breaks().size(), 1U) << at;
    EXPECT_LT(worstError(rotation, before, 0.0, at - 4.0), radians(4.0)) << at;
    EXPECT_LT(worstError(rotation, after, at + 4.0, 300.0), radians(4.0)) << at;
  }
}

// If this fails, an antenna that scans to and fro over 270 degrees has tracks of nothing.
TEST(Rotation, OfAnAntennaThatScansToAndFroIsRefused) {
  auto generator = seededGenerator();
  for (const double width : {radians(60.0), radians(180.0), radians(270.0), radians(340.0)}) {
    const Turning beam = [&](double time) { return 1.0 + std::abs(std::remainder(time, 9.0)) / 4.5 * width; };
    EXPECT_THROW(Rotation::fromPlots(plotsOf(generator, beam, 0.0, 300.0, 3.0)), std::invalid_argument) << width;
  }
}

// Two recordings of one radar in one file, with a night between.
TEST(Rotation, OfTwoStretchesIsFoundWhateverTheGap) {
  auto generator = seededGenerator();
  for (const double gap : {500.0, 3600.0, 21600.0, 86000.0}) {
    const Turning beam = even(4.0, 1.0);
    TimedAzimuths plots = plotsOf(generator, beam, 0.0, 180.0, 3.0);
    const TimedAzimuths more = plotsOf(generator, beam, gap, gap + 180.0, 3.0);
    plots.insert(plots.end(), more.begin(), more.end());
    const Rotation rotation = Rotation::fromPlots(plots);
    EXPECT_LT(worstError(rotation, beam, 0.0, 180.0), radians(1.0)) << gap;
    EXPECT_LT(worstError(rotation, beam, gap, gap + 180.0), radians(1.0)) << gap;
  }
}

TEST(Rotation, WithAKnownPeriodNeedsOnlyAFewPlotsForThePhase) {
  const Turning beam = even(12.0, 2.0);
  TimedAzimuths plots;
  for (const double time : {1.0, 2.0, 5.0, 11.0, 17.0}) plots.push_back({time, wrapTwoPi(beam(time))});
  const Rotation rotation = Rotation::fromPlots(plots, 12.0);
  EXPECT_NEAR(rotation.period(), 12.0, 1e-9);
  EXPECT_LT(worstError(rotation, beam, 0.0, 600.0), 1e-9);
}

TEST(Rotation, WithANominalPeriodFindsTheRealOneNearby) {
  auto generator = seededGenerator();
  const Turning beam = even(4.04, 3.0);
  for (const double rate : {0.2, 10.0}) {
    const Rotation rotation = Rotation::fromPlots(plotsOf(generator, beam, 50.0, 800.0, rate), 4.0);
    EXPECT_NEAR(rotation.period(), 4.04, 1e-3);
    EXPECT_LT(worstError(rotation, beam, 50.0, 800.0), radians(1.0)) << rate;
  }
}

TEST(Rotation, RefusesPlotsThatShowNone) {
  auto generator = seededGenerator();
  const Turning beam = even(6.0, 0.0);
  EXPECT_THROW(Rotation::fromPlots({}), std::invalid_argument);
  EXPECT_THROW(Rotation::fromPlots({}, 6.0), std::invalid_argument);
  EXPECT_THROW(Rotation::fromPlots(plotsOf(generator, beam, 0.0, 60.0, 0.3)), std::invalid_argument);   // 18 plots
  EXPECT_THROW(Rotation::fromPlots(plotsOf(generator, beam, 0.0, 2.0, 100.0)), std::invalid_argument);  // a third turn
  EXPECT_THROW(Rotation::fromPlots(TimedAzimuths(100, {1.0, 1.0})), std::invalid_argument);  // all at one instant
  EXPECT_THROW(Rotation::fromPlots(TimedAzimuths(100, {1.0, 1.0}), 6.0), std::invalid_argument);
  EXPECT_THROW(Rotation::fromPlots({{0.0, 1.0}, {1e9, 2.0}, {1e10, 3.0}, {-1e10, 4.0}, {5.0, 0.0}}, 0.01),
               std::invalid_argument);
  const Turning backwards = even(-6.0, 0.0);
  EXPECT_THROW(Rotation::fromPlots(plotsOf(generator, backwards, 0.0, 600.0, 3.0)), std::invalid_argument);
  EXPECT_THROW(Rotation::fromPlots(plotsOf(generator, beam, 0.0, 600.0, 3.0), 7.0), std::invalid_argument);
}

TEST(Rotation, RefusesRandomPlotsHoweverFewOrMany) {
  auto generator = seededGenerator();
  for (int trial = 0; trial < 100; ++trial) {
    const double rate = std::pow(10.0, uniform(generator, -1.4, 0.5));
    const TimedAzimuths plots = plotsOf(generator, even(6.0, 0.0), 0.0, 600.0, rate, 1.0);
    EXPECT_THROW(Rotation::fromPlots(plots), std::invalid_argument) << plots.size();
  }
}

TEST(Rotation, RefusesNumbersThatAreNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  TimedAzimuths plots(100, {1.0, 1.0});
  plots[42].azimuth = kNaN;
  try {
    Rotation::fromPlots(plots);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("42"), std::string::npos) << error.what();
  }
  EXPECT_THROW(Rotation::fromPlots({{kNaN, 1.0}}, 6.0), std::invalid_argument);
  for (const double period : {0.0, -6.0, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Rotation::uniform(period, 0.0), std::invalid_argument);
    EXPECT_THROW(Rotation::fromPlots(plots, period), std::invalid_argument);
  }
  EXPECT_THROW(Rotation::uniform(6.0, kNaN), std::invalid_argument);
}

// Plots of each radar in a file with columns t_s,radar,scan,range_m,az_deg,… of the data folder; empty without
// it.
std::map<int, TimedAzimuths> readPlots(const std::string& name) {
  const char* folder = std::getenv("TWS_SHARED");
  std::map<int, TimedAzimuths> plots;
  if (folder == nullptr) return plots;
  std::ifstream file(std::string(folder) + "/" + name);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    double time, scan, range, azimuth;
    int radar;
    if (fields >> time >> radar >> scan >> range >> azimuth) plots[radar].push_back({time, radians(azimuth)});
  }
  return plots;
}

TEST(RotationOfData, OfARealRadarIsFoundAndFollowedFor48Minutes) {
  if (std::getenv("TWS_SHARED") == nullptr) GTEST_SKIP() << "TWS_SHARED is not set: no real data";
  const TimedAzimuths plots = readPlots("data/asterix_msr_canalA/plots.csv")[0];
  ASSERT_EQ(plots.size(), 30651U);
  const Rotation rotation = Rotation::fromPlots(plots);
  EXPECT_NEAR(rotation.period(), 4.008, 0.004);
  // Times in steps of 1/128 s are 0.70° of the beam: errors from those alone have a median of a quarter of it.
  const double tick = kTwoPi / 128.0 / 4.008;
  std::cout << "period " << rotation.period() << " s, median absolute residual "
            << degrees(medianResidual(rotation, plots)) << " deg\n";
  EXPECT_LT(medianResidual(rotation, plots), 0.5 * tick);
  expectMonotoneWithInverse(rotation, 0.0, 2870.0);
}

TEST(RotationOfData, OfTheBenchRadarsAgreesWithTheirKnownPeriodsAndPhases) {
  if (std::getenv("TWS_SHARED") == nullptr) GTEST_SKIP() << "TWS_SHARED is not set: no bench data";
  for (const std::string name : {"n10", "n60", "n250"}) {
    for (const auto& [radar, plots] : readPlots("bench/" + name + "/det_rot.csv")) {
      const Turning beam = radar == 0 ? even(6.0, 0.0) : even(8.0, kPi / 2.0);
      const Rotation rotation = Rotation::fromPlots(plots);
      std::cout << name << " radar " << radar << ": period " << rotation.period() << " s, median absolute residual "
                << degrees(medianResidual(rotation, plots)) << " deg, worst error of the beam "
                << degrees(worstError(rotation, beam, 0.0, 600.0)) << " deg\n";
      EXPECT_LT(worstError(rotation, beam, 0.0, 600.0), radians(0.15)) << name;  // half of one plot's noise
      EXPECT_LT(medianResidual(rotation, plots), radians(0.3)) << name;
    }
  }
}

}  // namespace
}  // namespace tws
