#include "rotating_radar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include "flight_path.h"

namespace radar_sim {
namespace {

constexpr double kStart = 1000.0;
constexpr std::uint64_t kSeed = 11;

RadarParams quietRadar() {
  RadarParams radar;
  radar.name = "sps12";
  radar.false_alarms_per_scan = 0.0;
  return radar;
}

Target still(const std::string& name, double range, double azimuth_deg, double detection_probability) {
  PathStart start;
  start.time = kStart;
  start.position = range * Eigen::Vector2d(std::sin(tws::radians(azimuth_deg)), std::cos(tws::radians(azimuth_deg)));
  Target target;
  target.name = name;
  target.reflection.detection_probability = detection_probability;
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  return target;
}

Target straight(const std::string& name, const Eigen::Vector2d& from, const Eigen::Vector2d& velocity) {
  PathStart start;
  start.time = kStart;
  start.position = from;
  start.speed = velocity.norm();
  start.course = std::atan2(velocity.x(), velocity.y());
  start.height = 8000.0;
  Target target;
  target.name = name;
  target.reflection.detection_probability = 0.999;
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  return target;
}

class RadarRun {
 public:
  RadarRun(const RadarParams& params, std::vector<Target> targets, std::vector<Fault> faults = {})
      : targets_(std::move(targets)),
        radar_(params, Eigen::Isometry3d::Identity(), targets_, std::move(faults), kSeed, kStart) {}

  std::vector<tws::RadarSector> sectors(int turns) {
    std::vector<tws::RadarSector> sectors;
    for (int i = 0; i < turns * tws::kSectors; ++i) sectors.push_back(radar_.closeSector());
    return sectors;
  }
  std::vector<tws::Plot> plots(int turns) {
    std::vector<tws::Plot> plots;
    for (const tws::RadarSector& sector : sectors(turns))
      plots.insert(plots.end(), sector.plots.begin(), sector.plots.end());
    return plots;
  }
  RotatingRadar& radar() { return radar_; }

 private:
  std::vector<Target> targets_;
  RotatingRadar radar_;
};

/// 4.5 standard deviations of a binomial share: a wrong alarm once in 150 000.
double binomialBound(double p, double n) { return 4.5 * std::sqrt(p * (1.0 - p) / n); }

TEST(RotatingRadar, CountsItsSectorsAndStampsTheMarksInTicks) {
  RadarParams params = quietRadar();
  params.start_azimuth = tws::radians(100.0);
  RadarRun run(params, {});
  const auto sectors = run.sectors(3);
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    EXPECT_EQ(sectors[i].running, 17 + static_cast<std::int64_t>(i));
    EXPECT_EQ(sectors[i].sector, sectors[i].running % 64);
    const double exact = kStart + 6.0 * (static_cast<double>(sectors[i].running + 1) * 5.625 - 100.0) / 360.0;
    EXPECT_LE(sectors[i].leave_time, exact + 1e-9);
    EXPECT_GT(sectors[i].leave_time, exact - 0.008 - 1e-6);
    EXPECT_NEAR(std::remainder(sectors[i].leave_time, 0.008), 0.0, 1e-9);
    if (i > 0) {
      EXPECT_EQ(sectors[i].enter_time, sectors[i - 1].leave_time);
    }
  }
  EXPECT_TRUE(std::isnan(run.radar().rotationPeriod(81)));
  EXPECT_NEAR(run.radar().rotationPeriod(82), 6.0, 1e-9);
}

// All errors at once, no noise. Plots must be off by what each error says, lie in the sector of their measured azimuth,
// and leave the truth alone: an estimator that finds these errors is judged by them.
TEST(RotatingRadar, MeasuresWithItsErrorsAndKeepsTheTruth) {
  RadarParams params = quietRadar();
  params.range_sigma = params.azimuth_sigma = 0.0;
  params.range_lsb = params.azimuth_lsb = params.time_lsb = 0.0;
  params.errors.range_bias = 120.0;
  params.errors.range_gain = 2e-3;
  params.errors.azimuth.bias = tws::radians(-1.5);
  params.errors.azimuth.eccentricity = tws::radians(0.5);
  params.errors.azimuth.eccentricity_phase = tws::radians(45.0);
  params.errors.azimuth.north_drift = tws::radians(180.0) / 3600.0;
  params.errors.clock = {-0.5, 1e-3};
  std::vector<Target> targets;
  for (int i = 0; i < 30; ++i) targets.push_back(still("t" + std::to_string(i), 40e3, 12.0 * i + 1.0, 0.999));
  RadarRun run(params, targets);
  const double true_range = targets[3].trajectory->at(kStart).position.norm();  // on a round sea
  std::size_t count = 0;
  for (const tws::RadarSector& sector : run.sectors(20)) {
    for (const tws::Plot& plot : sector.plots) {
      const double told = plot.time - kStart + 0.5;  // elapsed time by the clock, less its offset
      const double elapsed = told / 1.001;
      const double truth = tws::kTwoPi * elapsed / 6.0;  // where the beam points: on a target
      const double error = tws::radians(-1.5 + 0.5 * std::sin(truth + tws::kPi / 4.0) + 0.05 * elapsed);
      EXPECT_NEAR(std::remainder(truth - tws::radians(1.0), tws::radians(12.0)), 0.0, 1e-7);
      EXPECT_NEAR(tws::wrapPi(plot.azimuth - truth - error), 0.0, 1e-7);
      EXPECT_NEAR(plot.range, true_range * 1.002 + 120.0, 1e-6);
      EXPECT_EQ(tws::sectorOf(plot.azimuth), sector.sector);
      EXPECT_GE(plot.time, sector.enter_time);
      EXPECT_LE(plot.time, sector.leave_time);
      ++count;
    }
  }
  EXPECT_GT(count, 500u);
  const tws::Polar truth = run.radar().polarOf(targets[3], kStart + 60.0);
  EXPECT_NEAR(truth.range, true_range, 1e-6);
  EXPECT_NEAR(truth.azimuth, tws::radians(37.0), 1e-9);
}

// The axis leans by 1° to the north. An aircraft 45° up in the east (a little less: the sea is round) comes under the
// beam 0.99985° late, and is measured there (registration_errors_test.cpp).
TEST(RotatingRadar, SeesHighAircraftAsideWhenItsAxisLeans) {
  RadarParams params = quietRadar();
  params.range_sigma = params.azimuth_sigma = 0.0;
  params.range_lsb = params.azimuth_lsb = params.time_lsb = 0.0;
  params.errors.tilt = tws::radians(1.0);
  RadarRun run(params, {straight("alpha", {8000.0, 0.0}, {0.0, 0.0})});
  const auto plots = run.plots(10);
  ASSERT_GT(plots.size(), 5u);
  for (const tws::Plot& plot : plots) {
    EXPECT_NEAR(plot.azimuth, tws::radians(90.99985), 2e-5);
    EXPECT_NEAR(std::fmod(plot.time - kStart, 6.0), tws::degrees(plot.azimuth) / 60.0, 1e-6);
  }
}

// The whole chain for a moving target: plot time, azimuth and range all belong to the instant when the beam was on it.
TEST(RotatingRadar, MeasuresAMovingTargetWhereItIsWhenTheBeamPasses) {
  RadarParams params = quietRadar();
  params.range_sigma = params.azimuth_sigma = 0.0;
  params.range_lsb = params.azimuth_lsb = params.time_lsb = 0.0;
  const Eigen::Vector2d from(30e3, -20e3), velocity(-200.0, 220.0);
  RadarRun run(params, {straight("alpha", from, velocity)});
  const auto plots = run.plots(40);
  ASSERT_GT(plots.size(), 35u);
  for (const tws::Plot& plot : plots) {
    const Eigen::Vector2d place = from + velocity * (plot.time - kStart);
    const double beam = tws::kTwoPi * (plot.time - kStart) / 6.0;
    EXPECT_NEAR(tws::wrapPi(plot.azimuth - std::atan2(place.x(), place.y())), 0.0, 1e-9);
    EXPECT_NEAR(tws::wrapPi(plot.azimuth - beam), 0.0, 1e-8);
    const double height = 8000.0 - place.squaredNorm() / (2.0 * 6379e3);
    EXPECT_NEAR(plot.range, std::hypot(place.norm(), height), 0.5);
  }
}

// If it fails, a tracker that uses range rates is pulled off by them.
TEST(RotatingRadar, MeasuresRangeRatesWithTheirErrorIfItMeasuresAny) {
  RadarParams params = quietRadar();
  const Eigen::Vector2d from(30e3, -20e3), velocity(-200.0, 220.0);
  const auto without = RadarRun(params, {straight("alpha", from, velocity)}).plots(40);
  params.range_rate_sigma = 3.0;
  const auto plots = RadarRun(params, {straight("alpha", from, velocity)}).plots(40);
  ASSERT_GT(plots.size(), 35u);
  ASSERT_EQ(plots.size(), without.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    EXPECT_TRUE(std::isnan(without[i].range_rate));
    EXPECT_EQ(plots[i].range, without[i].range);
    const Eigen::Vector2d place = from + velocity * (plots[i].time - kStart);
    const double height = 8000.0 - place.squaredNorm() / (2.0 * 6379e3);
    const double rate = place.dot(velocity) / std::hypot(place.norm(), height);
    squares += std::pow(plots[i].range_rate - rate, 2) / static_cast<double>(plots.size());
  }
  EXPECT_NEAR(std::sqrt(squares), 3.0, 3.0 * 4.5 / std::sqrt(2.0 * 36.0));
}

TEST(RotatingRadar, SpreadsRangeRatesOfFalseAlarmsOverTheirSpan) {
  RadarParams params = quietRadar();
  params.false_alarms_per_scan = 200.0;
  params.range_rate_sigma = 3.0;
  params.range_rate_span = 400.0;
  double least = 0.0, greatest = 0.0;
  for (const tws::Plot& plot : RadarRun(params, {}).plots(20)) {
    least = std::min(least, plot.range_rate);
    greatest = std::max(greatest, plot.range_rate);
  }
  EXPECT_NEAR(least, -199.0, 1.0);
  EXPECT_NEAR(greatest, 199.0, 1.0);
  params.range_rate_ambiguity = 50.0;
  for (const tws::Plot& plot : RadarRun(params, {}).plots(5)) EXPECT_LE(std::abs(plot.range_rate), 25.0);
}

TEST(RotatingRadar, SeesEachTargetOnceATurnAlsoAcrossNorth) {
  RadarParams params = quietRadar();
  std::vector<Target> targets;
  for (int i = 0; i < 20; ++i)
    targets.push_back(
        straight("t" + std::to_string(i), {1000.0 * (i - 10), 40e3 + 3e3 * i}, {i % 2 == 0 ? 250.0 : -250.0, 0.0}));
  RadarRun run(params, targets);
  std::map<int, int> seen;
  const auto plots = run.plots(100);
  // At most one a turn and target, and one more for those who go against the beam and are met earlier.
  EXPECT_GT(plots.size(), 1950u);
  EXPECT_LE(plots.size(), 2020u);
}

TEST(RotatingRadar, KeepsPlotsInsideTheirSectorAndQuantised) {
  RadarParams params = quietRadar();
  params.false_alarms_per_scan = 500.0;
  RadarRun run(params, {});
  for (const tws::RadarSector& sector : run.sectors(5)) {
    double before = sector.enter_time;
    for (const tws::Plot& plot : sector.plots) {
      EXPECT_GE(plot.time, before);
      EXPECT_LT(plot.time, sector.leave_time);
      before = plot.time;
      EXPECT_NEAR(std::remainder(plot.time, 0.008), 0.0, 1e-9);
      EXPECT_NEAR(std::remainder(plot.range, 19.05), 0.0, 1e-6);  // 62.5 ft
      EXPECT_NEAR(std::remainder(plot.azimuth, tws::radians(360.0 / 32768.0)), 0.0, 1e-9);
      EXPECT_LT(plot.azimuth, tws::kTwoPi);
    }
  }
}

// Gates and filters are sized by these errors. 4000 scans; bounds are 4.5 standard deviations of the estimates.
TEST(RotatingRadar, HasTheNoiseThatItStates) {
  RadarParams params = quietRadar();
  params.range_lsb = params.azimuth_lsb = 0.0;
  params.range_sigma = 80.0;
  params.azimuth_sigma = tws::radians(0.25);
  RadarRun run(params, {still("alpha", 50e3, 77.0, 0.999)});
  const auto plots = run.plots(4000);
  const double n = static_cast<double>(plots.size());
  ASSERT_GT(n, 3900.0);
  double range_mean = 0.0, range_square = 0.0, azimuth_mean = 0.0, azimuth_square = 0.0;
  for (const tws::Plot& plot : plots) {
    const double range = plot.range - 50e3;
    const double azimuth = plot.azimuth - tws::radians(77.0);
    range_mean += range / n;
    range_square += range * range / n;
    azimuth_mean += azimuth / n;
    azimuth_square += azimuth * azimuth / n;
    EXPECT_EQ(plot.range_sigma, 80.0);
  }
  EXPECT_NEAR(range_mean, 0.0, 4.5 * 80.0 / std::sqrt(n) + 0.2);  // 0.2 m: the sea bends down
  EXPECT_NEAR(std::sqrt(range_square) / 80.0, 1.0, 4.5 / std::sqrt(2.0 * n));
  EXPECT_NEAR(azimuth_mean / params.azimuth_sigma, 0.0, 4.5 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(azimuth_square) / params.azimuth_sigma, 1.0, 4.5 / std::sqrt(2.0 * n));
}

TEST(RotatingRadar, DetectsAsOftenAsItsRadarEquationSays) {
  for (const auto fluctuation : {Fluctuation::kSteady, Fluctuation::kExponential, Fluctuation::kOneDominant}) {
    RadarParams params = quietRadar();
    params.sea_reflection = 0.0;
    Target target = still("alpha", 120e3, 33.0, 0.5);
    PathStart start;
    start.time = kStart;
    start.position = {0.0, 120e3};
    start.height = 6000.0;
    target.reflection = {2.0, fluctuation, tws::Plot::kUnknown, 0.0};
    target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
    RadarRun run(params, {target});
    const double expected = run.radar().detectionProbability(0, kStart + 5.0);
    ASSERT_GT(expected, 0.02);  // neither certain nor hopeless, or the check would check nothing
    ASSERT_LT(expected, 0.98);
    const int turns = 3000;
    EXPECT_NEAR(static_cast<double>(run.plots(turns).size()) / turns, expected, binomialBound(expected, turns));
  }
}

TEST(RotatingRadar, DetectsStatedTargetsWithTheirProbabilityAndJitter) {
  Target target = still("rock", 30e3, 200.0, 0.6);
  target.reflection.jitter = 60.0;
  RadarParams params = quietRadar();
  params.range_sigma = 80.0;
  params.range_lsb = 0.0;
  RadarRun run(params, {target});
  EXPECT_DOUBLE_EQ(run.radar().detectionProbability(0, kStart + 1.0), 0.6);
  const auto plots = run.plots(3000);
  EXPECT_NEAR(static_cast<double>(plots.size()) / 3000.0, 0.6, binomialBound(0.6, 3000.0));
  double square = 0.0;
  for (const tws::Plot& plot : plots) square += std::pow(plot.range - 30e3, 2) / static_cast<double>(plots.size());
  EXPECT_NEAR(std::sqrt(square) / 100.0, 1.0, 4.5 / std::sqrt(2.0 * 1800.0));  // hypot(80, 60)
}

// Too many or too few false alarms, or all of them near, make the false-track figures worthless.
TEST(RotatingRadar, RaisesFalseAlarmsAtTheirRateUniformOverTheArea) {
  RadarParams params = quietRadar();
  params.false_alarms_per_scan = 40.0;
  params.min_range = 1000.0;
  params.max_range = 100e3;
  RadarRun run(params, {});
  const int turns = 500;
  const auto plots = run.plots(turns);
  const double n = static_cast<double>(plots.size());
  EXPECT_NEAR(n, 20000.0, 4.5 * std::sqrt(20000.0) + 15.0);  // 15: a few share a resolution cell
  double near = 0.0;
  std::vector<double> quadrants(4, 0.0);
  for (const tws::Plot& plot : plots) {
    near += plot.range < 50e3;
    quadrants[static_cast<std::size_t>(plot.azimuth / (tws::kPi / 2.0))] += 1.0;
  }
  EXPECT_NEAR(near / n, 0.25, binomialBound(0.25, n));
  for (const double count : quadrants) EXPECT_NEAR(count / n, 0.25, binomialBound(0.25, n));
}

TEST(RotatingRadar, RaisesFalseAlarmsUniformOverTheCellsWhenAskedTo) {
  RadarParams params = quietRadar();
  params.false_alarms_per_scan = 40.0;
  params.max_range = 100e3;
  params.false_alarms_by_area = false;
  RadarRun run(params, {});
  const auto plots = run.plots(200);
  double near = 0.0;
  for (const tws::Plot& plot : plots) near += plot.range < 50.5e3;
  EXPECT_NEAR(near / static_cast<double>(plots.size()), 0.5, binomialBound(0.5, 8000.0));
}

TEST(RotatingRadar, GivesOnePlotForTwoTargetsInOneCell) {
  RadarParams params = quietRadar();
  params.pulse_width = 2e-6;  // 300 m
  RadarRun apart(params, {still("a", 50e3, 40.0, 0.999), still("b", 51e3, 40.0, 0.999)});
  RadarRun together(params, {still("a", 50e3, 40.0, 0.999), still("b", 50.1e3, 40.5, 0.999)});
  EXPECT_GT(apart.plots(100).size(), 195u);
  const auto merged = together.plots(100);
  EXPECT_LE(merged.size(), 100u);
  EXPECT_GE(merged.size(), 99u);
}

TEST(RotatingRadar, SeesNothingBeyondItsInstrumentedRange) {
  RadarParams params = quietRadar();
  params.max_range = 60e3;
  RadarRun run(params, {still("far", 61e3, 40.0, 0.999), still("near", 500.0, 40.0, 0.999)});
  EXPECT_TRUE(run.plots(20).empty());
  EXPECT_EQ(run.radar().detectionProbability(0, kStart + 1.0), 0.0);
}

TEST(RotatingRadar, HasMarksButNoPlotsOnAMissedScan) {
  RadarParams params = quietRadar();
  params.false_alarms_per_scan = 200.0;
  Fault fault;
  fault.kind = FaultKind::kMissedScan;
  fault.from = kStart + 6.0;
  fault.to = kStart + 12.0;
  RadarRun run(params, {still("a", 50e3, 40.0, 0.999)}, {fault});
  std::vector<std::size_t> counts(3, 0);
  for (const tws::RadarSector& sector : run.sectors(3))
    counts[static_cast<std::size_t>(sector.running / 64)] += sector.plots.size();
  EXPECT_GT(counts[0], 100u);
  EXPECT_EQ(counts[1], 0u);
  EXPECT_GT(counts[2], 100u);
  EXPECT_EQ(run.radar().detectionProbability(0, kStart + 7.0), 0.0);
  EXPECT_FALSE(run.radar().isSilentAt(kStart + 7.0));
}

TEST(RotatingRadar, RaisesABurstWithinItsTimeAndAzimuths) {
  Fault burst;
  burst.kind = FaultKind::kFalseAlarmBurst;
  burst.from = kStart;
  burst.to = kStart + 30.0;
  burst.false_alarms_per_scan = 3600.0;
  burst.azimuth_from = tws::radians(350.0);
  burst.azimuth_to = tws::radians(370.0);
  RadarParams params = quietRadar();
  params.azimuth_beamwidth = tws::radians(0.1);
  params.azimuth_sigma = 0.0;
  RadarRun run(params, {}, {burst});
  const auto plots = run.plots(10);
  EXPECT_NEAR(static_cast<double>(plots.size()), 5.0 * 200.0, 4.5 * std::sqrt(1000.0) + 10.0);
  for (const tws::Plot& plot : plots) {
    EXPECT_LT(std::abs(tws::wrapPi(plot.azimuth)), tws::radians(10.01));
    EXPECT_LT(plot.time, kStart + 30.0);
  }
}

// A merged picture of before and after is no comparison: one more target must leave the others' plots as they were.
TEST(RotatingRadar, GivesOtherTargetsTheSamePlotsWhenOneIsAdded) {
  const Target a = straight("a", {40e3, 40e3}, {-200.0, 0.0});
  const Target b = straight("b", {-40e3, 60e3}, {0.0, -200.0});
  RadarRun alone(quietRadar(), {a});
  RadarRun both(quietRadar(), {b, a});
  const auto expected = alone.plots(30);
  auto plots = both.plots(30);
  plots.erase(std::remove_if(plots.begin(), plots.end(), [](const tws::Plot& plot) { return plot.azimuth > tws::kPi; }),
              plots.end());
  ASSERT_EQ(plots.size(), expected.size());
  for (std::size_t i = 0; i < plots.size(); ++i) {
    EXPECT_EQ(plots[i].time, expected[i].time);
    EXPECT_EQ(plots[i].range, expected[i].range);
    EXPECT_EQ(plots[i].azimuth, expected[i].azimuth);
    EXPECT_EQ(plots[i].snr, expected[i].snr);
  }
}

// Trackers refuse a range that is not positive.
TEST(RotatingRadar, NeverReportsARangeBelowZero) {
  RadarParams params = quietRadar();
  params.min_range = 10.0;
  params.range_sigma = 500.0;
  params.range_lsb = 0.0;
  RadarRun run(params, {still("near", 50.0, 40.0, 0.999)});
  const auto plots = run.plots(100);
  ASSERT_GT(plots.size(), 90u);
  for (const tws::Plot& plot : plots) EXPECT_GT(plot.range, 0.0);
}

// The turn of azimuth against the beam at the zenith has no crossing; the run must go on.
TEST(RotatingRadar, SurvivesATargetStraightOverhead) {
  RadarRun run(quietRadar(), {straight("overhead", {0.0, -3000.0}, {0.0, 300.0})});
  EXPECT_NO_THROW(run.plots(20));
}

}  // namespace
}  // namespace radar_sim
