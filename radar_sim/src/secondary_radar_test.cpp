#include "secondary_radar.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "flight_path.h"
#include "rotating_radar.h"

namespace radar_sim {
namespace {

constexpr double kStart = 1000.0;
constexpr std::uint64_t kSeed = 11;

/// No errors, no misses, no FRUIT; 12 interrogations while the beam is on an aircraft: 4 in 3/A, 4 in C, 2 in 1 and 2.
SecondaryParams perfectRadar() {
  SecondaryParams params;
  params.name = "ssr";
  params.antenna_height = 1000.0;
  params.interrogation_rate = 300.0;
  params.missed_reply_probability = params.fruit_plots_per_scan = 0.0;
  params.range_sigma = params.azimuth_sigma = params.range_lsb = params.azimuth_lsb = params.time_lsb = 0.0;
  return params;
}

Target airliner(const std::string& name, double range, double azimuth_deg, int mode_3a) {
  PathStart start;
  start.time = kStart;
  start.position = range * Eigen::Vector2d(std::sin(tws::radians(azimuth_deg)), std::cos(tws::radians(azimuth_deg)));
  start.height = 3048.0;  // 10 000 ft
  Target target;
  target.name = name;
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  target.transponder.codes[index(Mode::k3A)] = mode_3a;
  target.transponder.altitude = true;
  return target;
}

class SecondaryRun {
 public:
  SecondaryRun(const SecondaryParams& params, std::vector<Target> targets, std::vector<Fault> faults = {})
      : targets_(std::move(targets)),
        radar_(params, Eigen::Isometry3d::Identity(), targets_, std::move(faults), kSeed, kStart) {}

  std::vector<SecondarySector> sectors(int turns) {
    std::vector<SecondarySector> sectors;
    sectors.reserve(static_cast<std::size_t>(turns) * tws::kSectors);
    for (int i = 0; i < turns * tws::kSectors; ++i) sectors.push_back(radar_.closeSector());
    return sectors;
  }
  std::vector<SecondaryPlot> plots(int turns) {
    std::vector<SecondaryPlot> plots;
    for (const SecondarySector& sector : sectors(turns))
      plots.insert(plots.end(), sector.plots.begin(), sector.plots.end());
    return plots;
  }
  double trueRange(std::size_t target) { return targets_[target].trajectory->at(kStart).position.norm(); }

 private:
  std::vector<Target> targets_;
  SecondaryRadar radar_;
};

CodeReading mode3A(const SecondaryPlot& plot) { return plot.readings[index(Mode::k3A)]; }

/// 4.5 standard deviations of a binomial share: a wrong alarm once in 150 000.
double binomialBound(double p, double n) { return 4.5 * std::sqrt(p * (1.0 - p) / n); }

double binomial(int n, int k, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0)) * std::pow(p, k) *
         std::pow(1.0 - p, n - k);
}

TEST(SecondaryRadar, ReportsAnAircraftOnceATurnWithAllItReplies) {
  Target alpha = airliner("alpha", 50e3, 77.1, 07421);
  alpha.transponder.codes[index(Mode::k1)] = 03100;
  SecondaryRun run(perfectRadar(), {alpha});
  const auto plots = run.plots(20);
  ASSERT_EQ(plots.size(), 20u);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    EXPECT_NEAR(plots[i].time, kStart + 6.0 * (static_cast<double>(i) + 77.1 / 360.0), 1e-6);
    EXPECT_NEAR(plots[i].range, run.trueRange(0), 1e-6);
    EXPECT_NEAR(plots[i].azimuth, tws::radians(77.1), 1e-9);
    EXPECT_EQ(mode3A(plots[i]).code, 07421);
    EXPECT_EQ(plots[i].readings[index(Mode::k1)].code, 03100);
    EXPECT_FALSE(plots[i].readings[index(Mode::k2)].code);
    EXPECT_EQ(plots[i].readings[index(Mode::kC)].code, 06520);  // 10 000 ft: 22, Gray 11101, A2 A4 B1 B4
  }
}

// The mast's marks clock both trackers: with others the correlator would wait for the wrong instants.
TEST(SecondaryRadar, HasTheMarksOfThePrimaryWhoseRotationItShares) {
  RadarParams primary;
  primary.name = "sps12";
  primary.start_azimuth = tws::radians(100.0);
  SecondaryParams params = perfectRadar();
  params.rotation_period = primary.rotation_period;
  params.start_azimuth = primary.start_azimuth;
  params.time_lsb = primary.time_lsb;
  const std::vector<Target> nobody;
  RotatingRadar radar(primary, Eigen::Isometry3d::Identity(), nobody, {}, kSeed, kStart);
  SecondaryRadar ssr(params, Eigen::Isometry3d::Identity(), nobody, {}, kSeed, kStart);
  for (int i = 0; i < 200; ++i) {
    const tws::RadarSector sector = radar.closeSector();
    const SectorSpan span = ssr.closeSector().span;
    EXPECT_EQ(span.running, sector.running);
    EXPECT_EQ(span.enter_time, sector.enter_time);
    EXPECT_EQ(span.leave_time, sector.leave_time);
  }
}

TEST(SecondaryRadar, KeepsPlotsInsideTheirSectorInOrderOfTimeAndQuantised) {
  SecondaryParams params = perfectRadar();
  params.fruit_plots_per_scan = 500.0;
  params.range_lsb = 19.05;
  params.azimuth_lsb = tws::radians(360.0 / 32768.0);
  params.time_lsb = 0.008;
  SecondaryRun run(params, {});
  for (const SecondarySector& sector : run.sectors(5)) {
    double before = sector.span.enter_time;
    for (const SecondaryPlot& plot : sector.plots) {
      EXPECT_GE(plot.time, before);
      EXPECT_LT(plot.time, sector.span.leave_time);
      before = plot.time;
      EXPECT_NEAR(std::remainder(plot.range, 19.05), 0.0, 1e-6);
      EXPECT_NEAR(std::remainder(plot.azimuth, tws::radians(360.0 / 32768.0)), 0.0, 1e-9);
    }
  }
}

// Gates are sized by these errors, and the correlator's registration by the bias. Bounds are 4.5 standard deviations.
TEST(SecondaryRadar, HasTheBiasAndNoiseThatItStates) {
  SecondaryParams params = perfectRadar();
  params.errors.range_bias = 40.0;
  params.range_sigma = 80.0;
  params.beam_offset = tws::radians(-0.2);
  params.azimuth_sigma = tws::radians(0.25);
  SecondaryRun run(params, {airliner("alpha", 50e3, 77.1, 01234)});
  const auto plots = run.plots(4000);
  const double n = 4000.0;
  ASSERT_EQ(plots.size(), 4000u);
  double range_mean = 0.0, range_square = 0.0, azimuth_mean = 0.0, azimuth_square = 0.0;
  for (const SecondaryPlot& plot : plots) {
    const double range = (plot.range - run.trueRange(0) - 40.0) / 80.0;
    const double azimuth = (plot.azimuth - tws::radians(77.1 - 0.2)) / tws::radians(0.25);
    range_mean += range / n;
    range_square += range * range / n;
    azimuth_mean += azimuth / n;
    azimuth_square += azimuth * azimuth / n;
  }
  EXPECT_NEAR(range_mean, 0.0, 4.5 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(range_square), 1.0, 4.5 / std::sqrt(2.0 * n));
  EXPECT_NEAR(azimuth_mean, 0.0, 4.5 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(azimuth_square), 1.0, 4.5 / std::sqrt(2.0 * n));
}

// On a mast of its own its errors are those of its turning gear, marks and all; on another radar's its beam is off
// beside these.
TEST(SecondaryRadar, HasTheErrorsOfItsMastAndThoseOfItsBeam) {
  SecondaryParams params = perfectRadar();
  params.errors.range_gain = 1e-3;
  params.errors.azimuth.bias = tws::radians(2.0);
  params.errors.clock.offset = 0.3;
  params.beam_offset = tws::radians(-0.5);
  SecondaryRun run(params, {airliner("alpha", 50e3, 77.1, 01234)});
  const auto sectors = run.sectors(3);
  EXPECT_NEAR(sectors[0].span.leave_time, kStart + 0.3 + (5.625 - 2.0) / 60.0, 1e-6);
  for (const SecondarySector& sector : sectors) {
    for (const SecondaryPlot& plot : sector.plots) {
      EXPECT_NEAR(plot.azimuth, tws::radians(77.1 + 2.0 - 0.5), 1e-9);
      EXPECT_NEAR(plot.range, run.trueRange(0) * 1.001, 1e-6);
      EXPECT_NEAR(std::fmod(plot.time - kStart, 6.0), 0.3 + 77.1 / 60.0, 1e-6);
    }
  }
}

// Of 8 replies (4 in 3/A, 4 in C), half of which are missed: a plot with 4 or more, a code with 2 or more in its mode.
TEST(SecondaryRadar, MissesPlotsAndCodesAsOftenAsItsRepliesSay) {
  SecondaryParams params = perfectRadar();
  params.missed_reply_probability = 0.5;
  SecondaryRun run(params, {airliner("alpha", 50e3, 77.1, 01234)});
  double plot_chance = 0.0, code_chance = 0.0;
  for (int a = 0; a <= 4; ++a) {
    for (int c = 0; c <= 4; ++c) {
      const double chance = binomial(4, a, 0.5) * binomial(4, c, 0.5);
      if (a + c >= 4) plot_chance += chance;
      if (a + c >= 4 && a >= 2) code_chance += chance;
    }
  }
  EXPECT_NEAR(plot_chance, 163.0 / 256.0, 1e-12);
  const double turns = 4000.0;
  const auto plots = run.plots(4000);
  double codes = 0.0;
  for (const SecondaryPlot& plot : plots) codes += mode3A(plot).code.has_value();
  EXPECT_NEAR(static_cast<double>(plots.size()) / turns, plot_chance, binomialBound(plot_chance, turns));
  EXPECT_NEAR(codes / turns, code_chance, binomialBound(code_chance, turns));
}

TEST(SecondaryRadar, AsksInTheModesOfItsInterlaceOnly) {
  SecondaryParams params = perfectRadar();
  params.interlace = {Mode::k3A};
  SecondaryRun run(params, {airliner("alpha", 50e3, 77.1, 01234)});
  const auto plots = run.plots(5);
  ASSERT_EQ(plots.size(), 5u);
  EXPECT_EQ(mode3A(plots[0]).code, 01234);
  EXPECT_FALSE(plots[0].readings[index(Mode::kC)].code);
}

// 2 km apart the replies overlap; 2 · 2000 m / c = 13.34 µs = 9.2 positions, between which nothing is read wrong.
TEST(SecondaryRadar, MarksTheCodesOfAircraftWithinTheGarbleRegion) {
  SecondaryRun run(perfectRadar(), {airliner("a", 50e3, 77.1, 01234), airliner("b", 52e3, 77.1, 04321)});
  const auto plots = run.plots(5);
  ASSERT_EQ(plots.size(), 10u);
  for (const SecondaryPlot& plot : plots) {
    EXPECT_TRUE(mode3A(plot).garbled);
    EXPECT_TRUE(plot.readings[index(Mode::kC)].garbled);
    EXPECT_TRUE(mode3A(plot).code);
  }
}

// Slant ranges that differ by 4 positions of the reply: 4 · 1.45 µs · c / 2 = 869.4 m. The far one's pulses, seen by
// the near one's decoder: F1 on A2; and for 04321 (D1, C2, B1 B2, A4): C2 3 on X, A4 6 on B2, B1 8 on B4, D1 9 on D4,
// B2 10 on F2. So 01234 with 02000, 00200, 00400, 00004: 03634.
TEST(SecondaryRadar, AddsThePulsesThatFallOnPositions) {
  const double between = 4.0 * 1.45e-6 * 299792458.0 / 2.0;
  SecondaryRun run(perfectRadar(), {airliner("a", 50e3, 77.1, 01234), airliner("b", 50e3 + between, 77.1, 04321)});
  const auto plots = run.plots(1);
  ASSERT_EQ(plots.size(), 2u);
  const auto near = std::min_element(plots.begin(), plots.end(), [](auto& a, auto& b) { return a.range < b.range; });
  EXPECT_EQ(mode3A(*near).code, 03634);
}

TEST(SecondaryRadar, LeavesCodesAloneOutsideTheGarbleRegion) {
  for (const auto& other : {airliner("b", 53.2e3, 77.1, 04321), airliner("b", 51e3, 79.6, 04321)}) {
    SecondaryRun run(perfectRadar(), {airliner("a", 50e3, 77.1, 01234), other});
    const auto plots = run.plots(5);
    ASSERT_EQ(plots.size(), 10u);
    for (const SecondaryPlot& plot : plots) {
      EXPECT_FALSE(mode3A(plot).garbled);
      EXPECT_TRUE(mode3A(plot).code == 01234 || mode3A(plot).code == 04321);
    }
  }
}

// 1.6° apart in a beam of 2.4°: a third of the interrogations reaches both, and the rest is enough for the codes.
TEST(SecondaryRadar, ReadsCodesFromTheRepliesThatNothingOverlapped) {
  SecondaryRun run(perfectRadar(), {airliner("a", 50e3, 77.1, 01234), airliner("b", 51e3, 78.7, 04321)});
  const auto plots = run.plots(5);
  ASSERT_EQ(plots.size(), 10u);
  for (const SecondaryPlot& plot : plots) EXPECT_FALSE(mode3A(plot).garbled);
}

// What the secondary tracker of the paper is made for: two aircraft that the radar sees as one.
TEST(SecondaryRadar, GivesOneGarbledPlotForAircraftThatItCannotTellApart) {
  SecondaryRun run(perfectRadar(), {airliner("a", 50e3, 77.1, 01234), airliner("b", 50.02e3, 77.1, 04321)});
  const auto plots = run.plots(5);
  ASSERT_EQ(plots.size(), 5u);
  EXPECT_EQ(mode3A(plots[0]).code, 01234 | 04321);
  EXPECT_TRUE(mode3A(plots[0]).garbled);
  EXPECT_NEAR(plots[0].range, (run.trueRange(0) + run.trueRange(1)) / 2.0, 1e-6);
}

TEST(SecondaryRadar, HearsNobodyWithoutATransponderOrWhileItIsSilentOrOutOfReach) {
  Target without = airliner("without", 50e3, 30.0, Transponder::kNone);
  without.transponder.altitude = false;
  Target silent = airliner("silent", 50e3, 77.1, 01234);
  silent.transponder.silences = {{kStart + 6.0, kStart + 12.0}};
  SecondaryParams params = perfectRadar();
  params.max_range = 300e3;
  const Target far = airliner("far", 301e3, 140.0, 01234);
  SecondaryRun run(params, {without, silent, far});
  const auto plots = run.plots(3);
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_LT(plots[0].time, kStart + 6.0);
  EXPECT_GT(plots[1].time, kStart + 12.0);
}

// 4/3 earth: sqrt(2 · 8495 km · 1000 m) = 130.3 km for the radar, 227.6 km for the aircraft at 3048 m.
TEST(SecondaryRadar, HearsNobodyBeyondTheHorizon) {
  EXPECT_EQ(SecondaryRun(perfectRadar(), {airliner("above", 356e3, 77.1, 01234)}).plots(1).size(), 1u);
  EXPECT_EQ(SecondaryRun(perfectRadar(), {airliner("below", 360e3, 77.1, 01234)}).plots(1).size(), 0u);
}

// Too many or too few, or all of them near: false tracks would be others than in reality. FRUIT comes at any time after
// an interrogation, so at any range alike.
TEST(SecondaryRadar, HasFruitAtItsRateUniformInRangeWithOneCode) {
  SecondaryParams params = perfectRadar();
  params.fruit_plots_per_scan = 20.0;
  params.min_range = 1e3;
  params.max_range = 101e3;
  SecondaryRun run(params, {});
  const auto plots = run.plots(500);
  const double n = static_cast<double>(plots.size());
  EXPECT_NEAR(n, 10000.0, 4.5 * 100.0);
  double near = 0.0, in_3a = 0.0;
  for (const SecondaryPlot& plot : plots) {
    near += plot.range < 26e3;
    in_3a += mode3A(plot).code.has_value();
    int codes = 0;
    for (const CodeReading& reading : plot.readings) codes += reading.code.has_value();
    EXPECT_EQ(codes, 1);
  }
  EXPECT_NEAR(near / n, 0.25, binomialBound(0.25, n));
  EXPECT_NEAR(in_3a / n, 1.0 / 3.0, binomialBound(1.0 / 3.0, n));
}

TEST(SecondaryRadar, HasMarksButNoPlotsOnAMissedScan) {
  Fault fault;
  fault.kind = FaultKind::kMissedScan;
  fault.from = kStart + 6.0;
  fault.to = kStart + 12.0;
  SecondaryParams params = perfectRadar();
  params.fruit_plots_per_scan = 50.0;
  SecondaryRun run(params, {airliner("a", 50e3, 77.1, 01234)}, {fault});
  std::vector<std::size_t> counts(3, 0);
  for (const SecondarySector& sector : run.sectors(3))
    counts[static_cast<std::size_t>(sector.span.running / 64)] += sector.plots.size();
  EXPECT_GT(counts[0], 10u);
  EXPECT_EQ(counts[1], 0u);
  EXPECT_GT(counts[2], 10u);
}

TEST(SecondaryRadar, GivesOtherAircraftTheSamePlotsWhenOneFarAwayIsAdded) {
  SecondaryParams params = perfectRadar();
  params.missed_reply_probability = 0.3;
  params.range_sigma = 60.0;
  SecondaryRun alone(params, {airliner("a", 50e3, 77.1, 01234)});
  SecondaryRun both(params, {airliner("b", 70e3, 200.0, 04321), airliner("a", 50e3, 77.1, 01234)});
  const auto expected = alone.plots(50);
  auto plots = both.plots(50);
  const auto isOther = [](const SecondaryPlot& plot) { return plot.azimuth > tws::kPi; };
  plots.erase(std::remove_if(plots.begin(), plots.end(), isOther), plots.end());
  ASSERT_EQ(plots.size(), expected.size());
  for (std::size_t i = 0; i < plots.size(); ++i) {
    EXPECT_EQ(plots[i].time, expected[i].time);
    EXPECT_EQ(plots[i].range, expected[i].range);
    EXPECT_EQ(mode3A(plots[i]).code, expected[i].readings[index(Mode::k3A)].code);
  }
}

}  // namespace
}  // namespace radar_sim
