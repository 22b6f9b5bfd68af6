#include "range_radar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "flight_path.h"
#include "range_sensor.h"
#include "scenario_file_test_helpers.h"

namespace radar_sim {
namespace {

constexpr double kBegin = 1000.0;

/// A target north of the radar, at that range and at the antenna's height above a flat world.
Target targetAt(const std::string& name, double range, double rcs, Fluctuation fluctuation, double speed = 0.0) {
  Target target;
  target.name = name;
  target.reflection.rcs = rcs;
  target.reflection.fluctuation = fluctuation;
  PathStart start;
  start.time = kBegin;
  start.position = {0.0, range};
  start.height = 25.0;
  start.speed = speed;
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  return target;
}

/// A radar without noise; its site is the map's origin at the height of the targets, so that ranges are plain.
RangeRadarParams quiet() {
  RangeRadarParams params;
  params.name = "mrs";
  params.target = "alpha";
  params.noise_rcs = 0.0;
  return params;
}

Eigen::Isometry3d site() {
  Eigen::Isometry3d map_to_site = Eigen::Isometry3d::Identity();
  map_to_site.translation() = Eigen::Vector3d(0.0, 0.0, -25.0);
  return map_to_site;
}

struct World {
  World(const RangeRadarParams& params, std::vector<Target> all, std::uint64_t seed = 1)
      : targets(std::move(all)), radar(params, site(), targets, {}, seed, kBegin) {}
  std::vector<Target> targets;
  RangeRadar radar;
};

double squareOf(float amplitude) { return static_cast<double>(amplitude) * static_cast<double>(amplitude); }

double powerOf(const AmplitudeProfile& profile) {
  return std::accumulate(profile.amplitude.begin(), profile.amplitude.end(), 0.0,
                         [](double sum, float a) { return sum + squareOf(a); });
}

double centreOf(const AmplitudeProfile& profile, double bin_size) {
  double moment = 0.0;
  for (std::size_t i = 0; i < profile.amplitude.size(); ++i)
    moment += squareOf(profile.amplitude[i]) * (profile.range_min + (static_cast<double>(i) + 0.5) * bin_size);
  return moment / powerOf(profile);
}

struct Moments {
  double mean = 0.0, second = 0.0;
};

Moments momentsOf(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) {
    moments.mean += value / static_cast<double>(values.size());
    moments.second += value * value / static_cast<double>(values.size());
  }
  return moments;
}

// The threshold of the range-gate tracker is in square metres: it means nothing unless this holds.
TEST(RangeRadar, IsCalibratedToTheCrossSectionOfAPointAtTheMiddleOfTheGate) {
  for (const double range : {10000.0, 10000.25, 10000.5, 10000.8}) {
    World world(quiet(), {targetAt("alpha", range, 3.0, Fluctuation::kSteady)});
    const AmplitudeProfile profile = world.radar.takeProfile();
    EXPECT_EQ(profile.amplitude.size(), 1200u);
    EXPECT_NEAR(powerOf(profile), 3.0, 3.0 * 2e-3);  // a gate is a whole number of bins: 4 · 0.5 m / 10 km
    EXPECT_NEAR(centreOf(profile, 1.0), range, 0.02);
    EXPECT_NEAR(profile.azimuth, 0.0, 1e-9);
  }
}

TEST(RangeRadar, ScalesEchoesOffTheMiddleOfTheGateByTheFourthPowerOfRange) {
  RangeRadarParams params = quiet();
  World world(params, {targetAt("alpha", 10000.0, 3.0, Fluctuation::kSteady)});
  ASSERT_TRUE(world.radar.setGate({9900.0, 10500.0}));
  EXPECT_NEAR(powerOf(world.radar.takeProfile()), 3.0 * std::pow(10200.0 / 10000.0, 4), 0.01);
}

TEST(RangeRadar, SpreadsAPointOverItsResolution) {
  RangeRadarParams params = quiet();
  params.bin_size = 0.1;
  params.resolution = 3.0;
  params.gate_length = 100.0;
  World world(params, {targetAt("alpha", 10000.05, 3.0, Fluctuation::kSteady)});
  const AmplitudeProfile profile = world.radar.takeProfile();
  const auto peak = std::max_element(profile.amplitude.begin(), profile.amplitude.end());
  EXPECT_NEAR(squareOf(*(peak + 15)) / squareOf(*peak), 0.5, 0.01);
  EXPECT_NEAR(squareOf(*(peak - 15)) / squareOf(*peak), 0.5, 0.01);
}

// Exponential power (Rayleigh amplitude): second moment twice the square of the mean.
TEST(RangeRadar, HasReceiverNoiseOfTheStatedPowerThatGrowsWithTheFourthPowerOfRange) {
  RangeRadarParams params = quiet();
  params.noise_rcs = 2e-3;
  params.noise_range = 10e3;
  params.start_range = 20e3;
  World world(params, {targetAt("alpha", 10e3, 1.0, Fluctuation::kSteady)});
  std::vector<double> powers;
  for (int i = 0; i < 100; ++i)
    for (const float a : world.radar.takeProfile().amplitude) powers.push_back(squareOf(a));
  const Moments moments = momentsOf(powers);  // 120 000 values: standard error 0.3 %
  const double mean = 2e-3 * 16.0;
  EXPECT_NEAR(moments.mean, mean, 0.012 * mean);
  EXPECT_NEAR(moments.second, 2.0 * mean * mean, 0.05 * mean * mean);
}

// Mean σ0 · R · θ · Δr; of a compound Gaussian the second moment is 2(1 + 1/ν) times its square.
TEST(RangeRadar, HasSeaClutterOfTheStatedPowerAndSpikiness) {
  for (const double shape : {0.8, 3.0}) {
    RangeRadarParams params = quiet();
    params.sea_clutter.sigma0 = 1e-4;
    params.sea_clutter.shape = shape;
    params.sea_clutter.patch_length = 2.0;
    params.sea_clutter.patch_time = 0.02;
    params.gate_length = 1000.0;
    params.start_range = 30e3;
    World world(params, {targetAt("alpha", 1000.0, 1.0, Fluctuation::kSteady)});
    std::vector<double> powers;
    for (int i = 0; i < 400; ++i)
      for (const float a : world.radar.takeProfile().amplitude) powers.push_back(squareOf(a));
    const Moments moments = momentsOf(powers);
    const double mean = 1e-4 * 30e3 * params.beamwidth * 1.0;
    EXPECT_NEAR(moments.mean, mean, 0.02 * mean);
    EXPECT_NEAR(moments.second / (mean * mean), 2.0 * (1.0 + 1.0 / shape), 0.08 * 2.0 * (1.0 + 1.0 / shape));
  }
}

TEST(RangeRadar, KeepsAPatchOfSeaWhereItIsWhenTheGateMoves) {
  RangeRadarParams params = quiet();
  params.sea_clutter.sigma0 = 1e-4;
  params.sea_clutter.shape = 0.1;
  params.sea_clutter.patch_time = 1000.0;
  const auto patchPower = [&](double from) {
    World world(params, {targetAt("alpha", 1000.0, 1.0, Fluctuation::kSteady)});
    EXPECT_TRUE(world.radar.setGate({from, from + 1000.0}));
    double power = 0.0;
    for (int i = 0; i < 400; ++i) {
      const AmplitudeProfile profile = world.radar.takeProfile();
      for (std::size_t bin = 0; bin < 1000; ++bin) {
        const double range = profile.range_min + static_cast<double>(bin);
        if (range >= 10500.0 && range < 10550.0) power += squareOf(profile.amplitude[bin]);
      }
    }
    return power;
  };
  const double here = patchPower(10000.0);
  EXPECT_NEAR(patchPower(10400.0) / here, std::pow(10900.0 / 10500.0, 4), 0.05);  // 20 000 speckles: 0.7 %
}

std::vector<double> echoes(Fluctuation fluctuation, double fading_time, int profiles, std::uint64_t seed = 1) {
  Target target = targetAt("alpha", 10e3, 5.0, fluctuation);
  target.body.fading_time = fading_time;
  RangeRadarParams params = quiet();
  params.gate_length = 20.0;
  World world(params, {target}, seed);
  std::vector<double> powers;
  for (int i = 0; i < profiles; ++i) powers.push_back(powerOf(world.radar.takeProfile()));
  return powers;
}

// Swerling: exponential power has a variance of the mean squared, that of four degrees of freedom half of it.
TEST(RangeRadar, FadesWithTheStatisticsOfTheTarget) {
  for (const auto& [fluctuation, second] :
       {std::pair(Fluctuation::kSteady, 1.0), std::pair(Fluctuation::kExponential, 2.0),
        std::pair(Fluctuation::kOneDominant, 1.5)}) {
    const Moments moments = momentsOf(echoes(fluctuation, 0.002, 20000));
    EXPECT_NEAR(moments.mean, 5.0, 0.15);
    EXPECT_NEAR(moments.second / (moments.mean * moments.mean), second, 0.08);
  }
}

// Complex Gaussian with correlation exp(-Δt/T): powers are correlated by its square.
TEST(RangeRadar, FadesAsFastAsTheTargetDoes) {
  const std::vector<double> powers = echoes(Fluctuation::kExponential, 0.1, 50000);
  const Moments moments = momentsOf(powers);
  double product = 0.0;
  constexpr std::size_t kLag = 3;  // 0.06 s
  for (std::size_t i = 0; i + kLag < powers.size(); ++i)
    product += powers[i] * powers[i + kLag] / static_cast<double>(powers.size() - kLag);
  const double correlation = (product / (moments.mean * moments.mean)) - 1.0;
  EXPECT_NEAR(correlation, std::exp(-2.0 * 0.06 / 0.1), 0.06);
}

// A ship is many scatterers over its length, seen foreshortened; their powers add up in the mean.
TEST(RangeRadar, SeesAnExtendedTargetAsScatterersOverItsLength) {
  Target ship = targetAt("alpha", 10e3, 1000.0, Fluctuation::kExponential, 5.0);
  ship.body.length = 120.0;
  ship.body.scatterers = 200;
  ship.body.fading_time = 0.002;
  World world(quiet(), {ship});
  std::vector<double> total;
  double spread = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const AmplitudeProfile profile = world.radar.takeProfile();
    total.push_back(powerOf(profile));
    const double middle = 10e3 + 5.0 * (profile.time - kBegin);
    for (std::size_t bin = 0; bin < profile.amplitude.size(); ++bin)
      spread +=
          squareOf(profile.amplitude[bin]) * std::pow(profile.range_min + static_cast<double>(bin) + 0.5 - middle, 2);
  }
  const double mean = momentsOf(total).mean;
  EXPECT_NEAR(mean, 1000.0, 25.0);
  EXPECT_NEAR(std::sqrt(spread / mean / 1000.0), 120.0 / std::sqrt(12.0), 3.0);  // uniform over the length
}

// Half a beamwidth off the axis is half the power one way, a quarter both ways.
TEST(RangeRadar, SeesOtherTargetsThroughItsBeam) {
  RangeRadarParams params = quiet();
  Target other = targetAt("bravo", 10100.0, 8.0, Fluctuation::kSteady);
  PathStart start;
  start.time = kBegin;
  start.height = 25.0;
  start.position = 10100.0 * Eigen::Vector2d(std::sin(0.5 * params.beamwidth), std::cos(0.5 * params.beamwidth));
  other.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  World world(params, {targetAt("alpha", 10e3, 1e-6, Fluctuation::kSteady), other});
  EXPECT_NEAR(powerOf(world.radar.takeProfile()), 2.0 * std::pow(10000.0 / 10100.0, 4), 0.01);
}

TEST(RangeRadar, ReportsAtItsRateAndFollowsItsTarget) {
  World world(quiet(), {targetAt("alpha", 10e3, 1.0, Fluctuation::kSteady, 150.0)});
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_DOUBLE_EQ(world.radar.nextProfile(), kBegin + i / 50.0);
    const AmplitudeProfile profile = world.radar.takeProfile();
    EXPECT_EQ(profile.number, i);
    EXPECT_NEAR(centreOf(profile, 1.0), 10e3 + 150.0 * i / 50.0, 0.05);
  }
}

TEST(RangeRadar, OpensTheGateItIsToldToWithinItsRanges) {
  World world(quiet(), {targetAt("alpha", 10e3, 1.0, Fluctuation::kSteady)});
  ASSERT_TRUE(world.radar.setGate({12000.3, 12500.2}));
  AmplitudeProfile profile = world.radar.takeProfile();
  EXPECT_EQ(profile.range_min, 12000.0);
  EXPECT_EQ(profile.amplitude.size(), 500u);
  EXPECT_EQ(powerOf(profile), 0.0);  // the target is elsewhere
  ASSERT_TRUE(world.radar.setGate({0.0, 700.0}));
  profile = world.radar.takeProfile();
  EXPECT_EQ(profile.range_min, 500.0);
  EXPECT_EQ(profile.amplitude.size(), 200u);
}

TEST(RangeRadar, RefusesAGateThatMakesNoSenseAndKeepsTheOldOne) {
  World world(quiet(), {targetAt("alpha", 10e3, 1.0, Fluctuation::kSteady)});
  for (const RangeGate gate : {RangeGate{9000.0, 9000.0}, RangeGate{9000.0, 8000.0}, RangeGate{std::nan(""), 9000.0},
                               RangeGate{9000.0, INFINITY}, RangeGate{50e3, 60e3}})
    EXPECT_FALSE(world.radar.setGate(gate)) << gate.min << " to " << gate.max;
  EXPECT_EQ(world.radar.takeProfile().range_min, 9400.0);
}

// A closed loop is only comparable between trackers if the world does not depend on where they look.
TEST(RangeRadar, GivesATargetTheSameEchoesWhateverTheGateWas) {
  const auto world = [] { return World(quiet(), {targetAt("alpha", 10e3, 1.0, Fluctuation::kExponential)}); };
  World still = world(), moved = world();
  for (int i = 0; i < 20; ++i) {
    moved.radar.setGate(i < 10 ? RangeGate{20e3, 20.5e3} : RangeGate{9400.0, 10600.0});
    const AmplitudeProfile a = still.radar.takeProfile(), b = moved.radar.takeProfile();
    if (i < 10) continue;
    EXPECT_EQ(a.amplitude, b.amplitude);
  }
}

TEST(RangeRadar, WantsATargetThatIsThere) {
  EXPECT_THROW(World(quiet(), {targetAt("bravo", 10e3, 1.0, Fluctuation::kSteady)}), std::invalid_argument);
}

TEST_F(ScenarioFile, RangeRadarsAreReadInTheirUnits) {
  const Scenario scenario = load(R"(
range_radars:
  - {name: mrs, target: alpha, profile_rate_hz: 100, bin_size_m: 2, resolution_m: 3, beamwidth_deg: 1, latency_s: 0.05,
     sea_clutter: {sigma0_db: -40, shape: 1.5}}
targets:
  - {name: alpha, range_m: 8000, azimuth_deg: 10, length_m: 20, scatterers: 5, fading_time_s: 0.5}
)");
  const RangeRadarParams& radar = dynamic_cast<const RangeSpec&>(*scenario.sensors.back()).params;
  EXPECT_EQ(radar.profile_rate, 100.0);
  EXPECT_DOUBLE_EQ(radar.beamwidth, M_PI / 180.0);
  EXPECT_NEAR(radar.sea_clutter.sigma0, 1e-4, 1e-12);
  EXPECT_EQ(radar.site, "origin");
  EXPECT_EQ(scenario.targets.at(0).body.scatterers, 5);
  EXPECT_EQ(scenario.targets.at(0).body.length, 20.0);
}

TEST_F(ScenarioFile, WrongRangeRadarsAreRefusedWithTheirLine) {
  const auto complain = [&](const std::string& keys, const std::string& reason) {
    expectComplaint(
        "targets:\n  - {name: alpha, range_m: 8000, azimuth_deg: 10}\nrange_radars:\n  - {name: mrs, " + keys + "}\n",
        4, reason);
  };
  complain("profile_rate_hz: 50", "target");
  complain("target: bravo", "there is no target 'bravo'");
  complain("target: alpha, profile_rate_hz: 0", "profile_rate_hz");
  complain("target: alpha, resolution_m: 0.5", "resolution_m");
  complain("target: alpha, latency_s: 0", "latency_s");
  complain("target: alpha, max_range_m: 1000", "max_range_m");
  complain("target: alpha, start_range_m: 100", "start_range_m");
  complain("target: alpha, sea_clutter: {sigma: -40}", "sigma");
}

}  // namespace
}  // namespace radar_sim
