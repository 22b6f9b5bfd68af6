#include "adit_params_reader.h"

#include <gtest/gtest.h>

#include <tws_core/temporary_folder_test_helpers.h>

namespace adit_tracker {
namespace {

using tws_runtime::ParameterError;
using tws_runtime::ParameterReader;

AditParams read(const std::string& yaml) {
  ParameterReader reader(YAML::Load(yaml), "adit");
  AditParams params = readAditParams(reader);
  reader.done();
  return params;
}

/// What the reader says of a tree that it refuses; empty: it took it.
std::string complaint(const std::string& yaml) {
  try {
    check(read(yaml));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// All fields but for the radars, in the order of the struct.
std::vector<double> valuesOf(const AditParams& p) {
  std::vector<double> v = {static_cast<double>(p.capacity),
                           p.skew_limit,
                           static_cast<double>(p.filter),
                           p.alpha_beta.damping,
                           p.alpha_beta.omega_a,
                           p.alpha_beta.omega_b,
                           p.alpha_beta.omega_min,
                           p.alpha_beta.omega_max,
                           p.turning.turn_rate,
                           p.turning.straight_acceleration,
                           p.turning.turning_acceleration,
                           p.turning.straight_time,
                           p.turning.turning_time,
                           p.turning.assumed_height,
                           p.turning.manoeuvre_acceleration,
                           p.turning.speed_sigma,
                           static_cast<double>(p.learn_noise),
                           static_cast<double>(p.gates)};
  for (const Gate& g : p.track_gates) v.insert(v.end(), {g.range, g.azimuth, g.range_weight, g.azimuth_weight});
  v.insert(v.end(), p.gate_distances.begin(), p.gate_distances.end());
  const ExistenceParams& e = p.existence;
  v.insert(v.end(), {p.gate_sigmas, static_cast<double>(p.life), p.timers.tentative_drop_time, p.timers.drop_time,
                     p.timers.firm_time, e.new_targets, e.firm_probability, static_cast<double>(e.firm_updates),
                     e.moving_evidence, e.firm_speed, e.drop_probability, e.doubt_probability,
                     e.tentative_drop_fraction, e.detection_probability, e.survival_time});
  const ClutterParams& c = p.clutter;
  v.insert(v.end(), {static_cast<double>(c.per_radar), static_cast<double>(c.capacity), c.drop_time, c.gate.range,
                     c.gate.azimuth, c.gate.range_weight, c.gate.azimuth_weight, c.gate_sigmas,
                     static_cast<double>(c.hits), c.smoothing, static_cast<double>(c.yields_to_tracks)});
  v.insert(v.end(), {static_cast<double>(p.conversion.scans), p.conversion.speed_up, p.conversion.speed_down,
                     p.conversion.speed_sigmas, p.conversion.quiet_density, p.conversion.azimuth_rate,
                     static_cast<double>(p.conversion.over_ground), static_cast<double>(p.conversion.from_start),
                     p.stitching.longest_gap, p.stitching.speed_change, p.coverage.longest_gap,
                     static_cast<double>(p.operators.page), p.operators.point_sigma});
  const PartingParams& b = p.parting;
  v.insert(v.end(),
           {static_cast<double>(p.bifurcation), b.cell_range_sigmas, b.cell_azimuth_sigmas, b.unresolved_time,
            b.branch_time, b.speed, b.speed_sigma, b.per_scan, static_cast<double>(b.firm_updates), b.moving_evidence});
  const ElevationParams& s = p.elevation;
  v.insert(v.end(), {static_cast<double>(s.per_scan), static_cast<double>(s.new_per_scan),
                     static_cast<double>(s.every_scans), s.lead, static_cast<double>(s.automatic), s.sigma,
                     s.climb_sigma, s.climb_acceleration, s.gate_sigmas, s.greatest_sigma});
  const tws::RegistrationParams& r = p.registration;
  v.insert(v.end(), {static_cast<double>(r.mode), r.significance, r.unobservable, r.gate, r.pairings_per_second,
                     r.settling_time, r.learning_time});
  for (const tws::RegistrationTerms* terms : {&r.sigma, &r.drift, &r.greatest, &r.rate})
    v.insert(v.end(), terms->begin(), terms->end());
  return v;
}

void expectSame(const AditParams& a, const AditParams& b) {
  const auto first = valuesOf(a), second = valuesOf(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NEAR(first[i], second[i], 1e-12 * std::abs(first[i])) << "value " << i;
  }
}

/// The tree of a shipped file, without its key `set`, on top of another set.
AditParams fileOnTopOf(const std::string& set, const std::string& file) {
  YAML::Node tree = YAML::LoadFile(ADIT_CONFIG + ("/" + file));
  tree["set"] = set;
  return read(YAML::Dump(tree));
}

class ShippedFile : public testing::TestWithParam<std::string> {};

// If this fails, the shipped reference says other values than the tracker uses when it is told only the set's name.
TEST_P(ShippedFile, GivesTheSetOfItsName) {
  expectSame(loadAditParams(std::string(ADIT_CONFIG) + "/" + GetParam() + ".yaml"), AditParams::named(GetParam()));
}

// If this fails, a parameter is missing in the file that is the reference of all parameters.
TEST_P(ShippedFile, NamesEveryParameter) {
  const std::string other = GetParam() == "default" ? "nrl7952" : "default";
  expectSame(fileOnTopOf(other, GetParam() + ".yaml"), AditParams::named(GetParam()));
}

TEST_P(ShippedFile, HasTheReportsRadars) {
  const AditParams params = loadAditParams(std::string(ADIT_CONFIG) + "/" + GetParam() + ".yaml");
  ASSERT_EQ(params.radars.size(), 2U);
  EXPECT_EQ(params.radars[0].name, "sps12");
  EXPECT_DOUBLE_EQ(params.radars[0].period, 6.0);
  EXPECT_EQ(params.radars[1].name, "sps39");
  EXPECT_DOUBLE_EQ(params.radars[1].period, 8.0);
  EXPECT_EQ(params.reference_radar, "");  // the last one, whatever its name
  EXPECT_NO_THROW(check(params));
}

INSTANTIATE_TEST_SUITE_P(Both, ShippedFile, testing::Values("default", "nrl7952"),
                         [](const auto& info) { return info.param; });

// If this fails, who gives the radar in config/marine.yaml other values gets another set than who says `set: marine`.
TEST(ShippedMarine, GivesTheSetOfItsName) {
  const AditParams shipped = loadAditParams(std::string(ADIT_CONFIG) + "/marine.yaml");
  expectSame(shipped, AditParams::named("marine"));
  EXPECT_NO_THROW(check(shipped));
}

// The same of config/airport.yaml.
TEST(ShippedAirport, GivesTheSetOfItsName) {
  const AditParams shipped = loadAditParams(std::string(ADIT_CONFIG) + "/airport.yaml");
  expectSame(shipped, AditParams::named("airport"));
  EXPECT_NO_THROW(check(shipped));
}

/// The top level's parameters with those of a volume.
AditParams asIn(AditParams params, std::uint16_t volume) {
  static_cast<LocalParams&>(params) = LocalParams(params.in(volume));
  return params;
}

// If this fails, who copies the example gets no airport, or no airspace above it.
TEST(ShippedApproach, IsAirportBelowAndDefaultElsewhere) {
  const AditParams shipped = loadAditParams(std::string(ADIT_CONFIG) + "/approach.yaml");
  EXPECT_NO_THROW(check(shipped));
  expectSame(shipped, AditParams::named("default"));
  ASSERT_EQ(shipped.volumes.size(), 1U);
  expectSame(asIn(shipped, 1), AditParams::named("airport"));
  EXPECT_EQ(shipped.volumeAt({10e3, 1.0}), 1);
  EXPECT_EQ(shipped.volumeAt({10e3, 1.0, 1000.0}), 1);
  EXPECT_EQ(shipped.volumeAt({10e3, 1.0, 9000.0}), 0);
  EXPECT_EQ(shipped.volumeAt({80e3, 1.0}), 0);
}

// If this fails, `nrl7952` is no longer the report: the figures are those it prints.
TEST(NamedSets, TheLetterHasTheReportsFigures) {
  const AditParams p = AditParams::named("nrl7952");
  EXPECT_EQ(p.capacity, 256U);
  EXPECT_EQ(p.clutter.capacity, 256U);
  EXPECT_NEAR(p.clutter.gate.range, 609.6, 1e-9);  // 2000 ft
  EXPECT_NEAR(tws::degrees(p.clutter.gate.azimuth), 1.4, 1e-12);
  EXPECT_NEAR(p.track_gates.front().range, 609.6, 1e-9);
  EXPECT_NEAR(p.track_gates.back().range, 4267.2, 1e-9);  // 14 000 ft
  EXPECT_NEAR(tws::degrees(p.track_gates.back().azimuth), 5.6, 1e-12);
  EXPECT_EQ(p.clutter.gate.range_weight, 4.0);
  EXPECT_EQ(p.clutter.gate.azimuth_weight, 1.0);
  EXPECT_EQ(p.clutter.drop_time, 40.0);
  EXPECT_EQ(p.timers.firm_time, 20.0);
  EXPECT_EQ(p.conversion.scans, 8);
  EXPECT_EQ(p.operators.page, 32U);
  EXPECT_NEAR(p.conversion.speed_up, 45.0 * 1852.0 / 3600.0, 1e-12);
  EXPECT_NEAR(p.conversion.speed_down, 56.0 * 1852.0 / 3600.0, 1e-12);
}

TEST(AditParamsReader, KeysChangeTheSetThatTheyStandOn) {
  const AditParams p = read("{set: nrl7952, capacity: 1000, timers: {drop_time_s: 33}, conversion: {speed_up_kn: 60}}");
  AditParams expected = AditParams::named("nrl7952");
  expected.capacity = 1000;
  expected.timers.drop_time = 33.0;
  expected.conversion.speed_up = 60.0 * 1852.0 / 3600.0;
  expectSame(p, expected);
}

constexpr char kTwoVolumes[] = R"({conversion: {speed_up_kn: 50}, turning: {speed_sigma_mps: 77}, volumes: [
  {name: a, range_m: [1000, 2000], azimuth_deg: [350, 20], conversion: {speed_up_kn: 60}, clutter: {hits: 9}},
  {name: b, height_m: [0, 500], unknown_height: outside, set: airport, existence: {firm_speed_mps: 33},
   parting: {speed_mps: 44}, stitching: {speed_change_mps: 5}}]})";

// If this fails, a volume has other parameters or lies elsewhere than its file says.
TEST(AditParamsReader, AVolumeChangesTheTopLevelOrItsOwnSet) {
  const AditParams p = read(kTwoVolumes);
  ASSERT_EQ(p.volumes.size(), 2U);
  AditParams a = p;
  a.conversion.speed_up = tws::speedFromKnots(60.0);
  a.clutter.hits = 9;
  expectSame(asIn(p, 1), a);
  AditParams b = AditParams::named("airport");
  b.existence.firm_speed = 33.0;
  b.parting.speed = 44.0;
  b.stitching.speed_change = 5.0;
  expectSame(asIn(p, 2), b);
  EXPECT_EQ(p.volumeAt({1500.0, tws::radians(10.0)}), 1);
  EXPECT_EQ(p.volumeAt({1500.0, tws::radians(30.0)}), 0);
  EXPECT_EQ(p.volumeAt({1500.0, tws::radians(30.0), 400.0}), 2);
  EXPECT_NO_THROW(
      check(read("{radars: [{name: r}], volumes: [{name: a, range_m: [0, 9]}, {name: b, range_m: [5, 9]}]}")));
}

std::string manyVolumes(std::size_t count) {
  std::string yaml = "{radars: [{name: r}], volumes: [";
  for (std::size_t i = 0; i < count; ++i) yaml += "{name: v" + std::to_string(i) + ", range_m: [0, 1000]},";
  return yaml + "]}";
}

// If this fails, a file can make each update of each track cost what it likes.
TEST(AditParamsReader, ThereAreAThousandVolumesAtMost) {
  EXPECT_EQ(complaint(manyVolumes(kMostVolumes)), "");
  EXPECT_NE(complaint(manyVolumes(kMostVolumes + 1)).find("volumes: 1001 are too many"), std::string::npos);
}

struct Mistake {
  const char* yaml;
  const char* key;     // must be named
  const char* detail;  // must be said
};

class Refused : public testing::TestWithParam<Mistake> {};

// If this fails, a user's slip of the pen is taken silently, or said so that he does not find it.
TEST_P(Refused, InOneLineThatNamesTheKey) {
  const std::string said = complaint(GetParam().yaml);
  EXPECT_NE(said.find(GetParam().key), std::string::npos) << said;
  EXPECT_NE(said.find(GetParam().detail), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

constexpr Mistake kMistakes[] = {
    {"{radars: [{name: a}], capactiy: 5}", "capactiy", "did you mean 'capacity'?"},
    {"{radars: [{name: a}], turning: {turn_rate: 2}}", "turning.turn_rate", "turn_rate_deg_per_s"},
    {"{radars: [{name: a, period: 6}]}", "period", "period_s"},
    {"{radars: [{name: a}], set: nrl7925}", "set", "nrl7952"},
    {"{radars: [{name: a}], filter: kalman}", "filter", "turning"},
    {"{radars: [{name: a}], capacity: 1}", "capacity", "[2, 1000001]"},
    {"{radars: [{name: a}], capacity: 10.5}", "capacity", "whole number"},
    {"{radars: [{name: a}], gate_sigmas: wide}", "gate_sigmas", "expected a number"},
    {"{radars: [{name: a}], gate_sigmas: .nan}", "gate_sigmas", "nan"},
    {"{radars: [{name: a}], learn_noise: maybe}", "learn_noise", "true or false"},
    {"{radars: [{name: a}], clutter: [1, 2]}", "clutter", "expected a map"},
    {"{radars: [{name: a}], clutter: {hits: 0}}", "clutter.hits", "[1, 1000]"},
    {"{radars: [{name: a}], timers: {firm_time_s: -1}}", "timers.firm_time_s", "[0, 10000]"},
    {"{radars: [{name: a}], existence: {firm_probability: 1.0}}", "existence.firm_probability", "0.99999"},
    {"{radars: [{name: a}], conversion: {scans: 1}}", "conversion.scans", "[2, 1000]"},
    {"{radars: [{name: a}], bifurcation: sometimes}", "bifurcation", "true or false"},
    {"{radars: [{name: a}], parting: {firm_updates: 1}}", "parting.firm_updates", "[2, 100]"},
    {"{radars: [{name: a}], parting: {per_scan: 0}}", "parting.per_scan", "[1e-06, 1000]"},
    {"{radars: [{name: a}], elevation: {per_scan: 0}}", "elevation.per_scan", "[1, 1000]"},
    {"{radars: [{name: a}], elevation: {radar: b}}", "elevation.radar", "no radar named b"},
    {"{radars: [{name: a}], operator: {page: -1}}", "operator.page", "[0, 1000001]"},
    {"{radars: [{name: a}], operator: {point_sigma_m: 0}}", "operator.point_sigma_m", "[1, 100000]"},
    {"{radars: [{name: a}], track_gates: {range_m: [1, 2, 3]}}", "track_gates.range_m", "needs 5 values"},
    {"{radars: [{name: a}], track_gates: {range_m: [1, 2, 3, 5, 4]}}", "gate 5", "smaller than the one before"},
    {"{radars: [{name: a}], track_gates: {azimuth_deg: [1, 2, 3, 4, 6]}}", "track_gates.azimuth_deg", "5.625"},
    {"{radars: [{name: a}], gate_distances: [1, 2, 3, 4, 5]}", "gate_distances", "needs 4 values"},
    {"{radars: [{name: a}], gate_distances: [4, 3, 2, 1]}", "gate_distances", "grow"},
    {"{radars: []}", "radars", "[1, 8]"},
    {"{radars: [{name: a}, {name: a}]}", "radars", "two radars are named a"},
    {"{radars: [{period_s: 6}]}", "name", "is required"},
    {"{radars: [{name: a, period_s: 0.1}]}", "period_s", "[0.5, 120]"},
    {"{radars: [{name: a}], reference_radar: b}", "reference_radar", "no radar named b"},
    {"{radars: [{name: a}], alpha_beta: {omega_min: 2, omega_max: 1}}", "omega_max", "1"},
    {"{radars: [{name: a}], filter: adaptive_alpha_beta}", "gates", "turning filter"},
    {"{radars: [{name: a}], gates: fixed}", "learn_noise", "statistical"},
    {"{radars: [{name: a}], gates: fixed, learn_noise: false}", "life", "statistical"},
    {"{radars: [{name: a}], volumes: {name: v}}", "volumes", "list of maps"},
    {"{radars: [{name: a}], volumes: [{range_m: [0, 9]}]}", "volumes[0].name", "is required"},
    {"{radars: [{name: a}], volumes: [{name: v}]}", "volumes[0].name", "nowhere"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [9, 9]}]}", "volumes[0].range_m", "greater than the first"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [9, 0]}]}", "volumes[0].range_m", "greater than the first"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0]}]}", "volumes[0].range_m", "two numbers"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, .nan]}]}", "volumes[0].range_m", "nan"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, .inf]}]}", "volumes[0].range_m", "inf"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [-1, 9]}]}", "volumes[0].range_m", "-1"},
    {"{radars: [{name: a}], volumes: [{name: v, azimuth_deg: [20, 20]}]}", "volumes[0].azimuth_deg", "differ"},
    {"{radars: [{name: a}], volumes: [{name: v, azimuth_deg: [0, 361]}]}", "volumes[0].azimuth_deg", "361"},
    {"{radars: [{name: a}], volumes: [{name: v, height_m: [9, 0]}]}", "volumes[0].height_m", "greater than the first"},
    {"{radars: [{name: a}], volumes: [{name: v, height_m: [.nan, 0]}]}", "volumes[0].height_m", "nan"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], unknown_height: up}]}", "unknown_height", "inside"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], set: nrl7952}]}", "volumes[0].set", "airport"},
    {"{radars: [{name: a}], volumes: [{name: v, range_km: [0, 9]}]}", "volumes[0]", "range_m"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], capacity: 9}]}", "volumes[0].capacity",
     "whole tracker"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], life: timers}]}", "volumes[0].life", "whole tracker"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], turning: {fast_share: 0}}]}",
     "volumes[0].turning.fast_share", "whole tracker"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], clutter: {per_radar: true}}]}",
     "volumes[0].clutter.per_radar", "whole tracker"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], conversion: {scans: 4}}]}",
     "volumes[0].conversion.scans", "whole tracker"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], existence: {firm_speed_mps: -1}}]}",
     "volumes[0].existence.firm_speed_mps", "[0, 10000]"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9], existence: {firm_sped_mps: 1}}]}",
     "volumes[0].existence.firm_sped_mps", "firm_speed_mps"},
    {"{radars: [{name: a}], volumes: [{name: v, range_m: [0, 9]}, {name: v, range_m: [0, 9]}]}", "volumes",
     "two volumes"},
    {"{set: nrl7952, radars: [{name: a}], volumes: [{name: v, range_m: [0, 9]}]}", "volumes", "turning filter"},
};
INSTANTIATE_TEST_SUITE_P(Each, Refused, testing::ValuesIn(kMistakes));

// If this fails, the mistakes above may be refused for another reason.
TEST(AditParamsReader, TheSameWithoutTheMistakeIsTaken) { EXPECT_EQ(complaint("{radars: [{name: a}]}"), ""); }

TEST(AditParamsReader, AFileThatIsNotThereIsNamed) {
  try {
    loadAditParams("/no/such/file.yaml");
    FAIL() << "taken";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/file.yaml"), std::string::npos) << error.what();
  }
}

// If this fails, a user has to search a long file for the line that is wrong.
TEST(AditParamsReader, AMistakeInAFileIsSaidWithItsLine) {
  const tws::TemporaryFolder folder;
  const std::string path = folder.write("params.yaml", "set: default\ncapacity: 100\ngate_sigma: 4\n");
  try {
    loadAditParams(path);
    FAIL() << "taken";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find(path + ":3:"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("gate_sigmas"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace adit_tracker
