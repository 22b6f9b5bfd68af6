#include "adit_params_reader.h"

#include <algorithm>
#include <limits>

#include <tws_core/angles.h>

#include "registration_params_reader.h"

namespace adit_tracker {
namespace {

using tws_runtime::ParameterReader;

constexpr double kMost = 1e9;

void readRadars(ParameterReader& reader, std::vector<RadarParams>& radars) {
  std::vector<ParameterReader> entries = reader.list("radars");
  if (!reader.has("radars")) return;
  radars.clear();
  for (ParameterReader& entry : entries) {
    RadarParams radar;
    entry.require("name");
    entry.text("name", radar.name);
    entry.number("period_s", radar.period, 0.5, 120.0);
    entry.number("range_sigma_m", radar.range_sigma, 0.1, 1e5);
    scaledNumber(entry, "azimuth_sigma_deg", radar.azimuth_sigma, tws::kRadiansPerDegree, 1e-4, 20.0);
    entry.number("range_rate_sigma_mps", radar.range_rate_sigma, 0.0, 1e3);
    entry.number("range_rate_span_mps", radar.range_rate_span, 1.0, 1e5);
    entry.number("range_rate_ambiguity_mps", radar.range_rate_ambiguity, 0.0, 1e5);
    entry.done();
    radars.push_back(radar);
  }
}

void readIff(ParameterReader& reader, std::vector<IffParams>& all) {
  std::vector<ParameterReader> entries = reader.list("iff");
  if (!reader.has("iff")) return;
  all.clear();
  for (ParameterReader& entry : entries) {
    IffParams& iff = all.emplace_back();
    entry.require("name");
    entry.text("name", iff.name);
    entry.number("range_sigma_m", iff.range_sigma, 0.1, 1e5);
    scaledNumber(entry, "azimuth_sigma_deg", iff.azimuth_sigma, tws::kRadiansPerDegree, 1e-4, 20.0);
    entry.number("range_bias_m", iff.range_bias, -1e4, 1e4);
    scaledNumber(entry, "azimuth_bias_deg", iff.azimuth_bias, tws::kRadiansPerDegree, -20.0, 20.0);
    entry.done();
  }
}

/// Five values, one a gate.
void readGates(ParameterReader reader, std::array<Gate, kGates>& gates) {
  const auto read = [&](const std::string& key, double Gate::*member, double greatest, double unit) {
    std::vector<double> values;
    reader.numbers(key, values, 0.0, greatest);
    if (!reader.has(key)) return;
    if (values.size() != kGates) reader.fail(key, "needs " + std::to_string(kGates) + " values");
    for (std::size_t g = 0; g < kGates; ++g) gates[g].*member = unit * values[g];
  };
  read("range_m", &Gate::range, 1e6, 1.0);
  read("azimuth_deg", &Gate::azimuth, tws::degrees(tws::kSectorWidth), tws::kRadiansPerDegree);
  read("range_weight", &Gate::range_weight, 1e6, 1.0);
  read("azimuth_weight", &Gate::azimuth_weight, 1e6, 1.0);
  reader.done();
}

void readGateDistances(ParameterReader& reader, std::array<double, kGates>& distances) {
  std::vector<double> values;
  reader.numbers("gate_distances", values, 0.0, kMost);
  if (!reader.has("gate_distances")) return;
  if (values.size() + 1 != kGates) reader.fail("gate_distances", "needs 4 values; the fifth region has no limit");
  std::copy(values.begin(), values.end(), distances.begin());
}

void readTurning(ParameterReader& reader, tws::MultipleModelParams& p) {
  scaledNumber(reader, "turn_rate_deg_per_s", p.turn_rate, tws::kRadiansPerDegree, 0.01, 28.0);
  scaledNumber(reader, "turn_rate_sigma_deg_per_s", p.turn_rate_sigma, tws::kRadiansPerDegree, 0.0, 28.0);
  reader.number("straight_acceleration", p.straight_acceleration, 0.0, 1e6);
  reader.number("turning_acceleration", p.turning_acceleration, 0.0, 1e6);
  reader.number("free_acceleration", p.free_acceleration, 0.0, 1e6);
  reader.number("straight_time_s", p.straight_time, 0.1, 1e6);
  reader.number("turning_time_s", p.turning_time, 0.1, 1e6);
  reader.number("free_time_s", p.free_time, 0.1, 1e6);
  reader.number("free_share", p.free_share, 0.0, 0.9);
  reader.number("assumed_height_m", p.assumed_height, 0.0, 50000.0);
  reader.number("manoeuvre_acceleration", p.manoeuvre_acceleration, 0.0, 1000.0);
  reader.number("speed_sigma_mps", p.speed_sigma, 0.1, 1e5);
  reader.number("fast_speed_sigma_mps", p.fast_speed_sigma, 0.0, 1e5);
  reader.done();
}

void readFilters(ParameterReader& reader, AditParams& p) {
  choice(reader, "filter", p.filter,
         {{"adaptive_alpha_beta", FilterKind::kAlphaBeta}, {"turning", FilterKind::kTurning}});
  ParameterReader alpha_beta = reader.map("alpha_beta");
  alpha_beta.number("damping", p.alpha_beta.damping, 0.01, 0.99);
  alpha_beta.number("omega_a", p.alpha_beta.omega_a, 1e-6, 100.0);
  alpha_beta.number("omega_b", p.alpha_beta.omega_b, 1e-6, 100.0);
  alpha_beta.number("omega_min", p.alpha_beta.omega_min, 1e-6, 100.0);
  alpha_beta.number("omega_max", p.alpha_beta.omega_max, 1e-6, 100.0);
  alpha_beta.done();
  ParameterReader turning = reader.map("turning");
  turning.number("fast_share", p.turning.fast_share, 0.0, 0.5);
  readTurning(turning, p.turning);
}

void readExistence(ParameterReader reader, ExistenceParams& p) {
  reader.number("new_targets", p.new_targets, 1e-6, 1e6);
  reader.number("firm_probability", p.firm_probability, 0.5, 0.99999);
  reader.integer("firm_updates", p.firm_updates, 2, 100);
  reader.number("moving_evidence", p.moving_evidence, -kMost, 1e3);
  reader.number("firm_speed_mps", p.firm_speed, 0.0, 1e4);
  reader.number("drop_probability", p.drop_probability, 1e-9, 0.5);
  reader.number("doubt_probability", p.doubt_probability, 0.0, 0.99);
  reader.number("tentative_drop_fraction", p.tentative_drop_fraction, 1e-9, 1.0);
  reader.number("detection_probability", p.detection_probability, 0.05, 0.99);
  reader.number("survival_time_s", p.survival_time, 1.0, kMost);
  reader.done();
}

void readLife(ParameterReader& reader, AditParams& p) {
  choice(reader, "life", p.life, {{"timers", TrackLife::kTimers}, {"existence", TrackLife::kExistence}});
  ParameterReader timers = reader.map("timers");
  timers.number("tentative_drop_time_s", p.timers.tentative_drop_time, 0.1, 1e4);
  timers.number("drop_time_s", p.timers.drop_time, 0.1, 1e4);
  timers.number("firm_time_s", p.timers.firm_time, 0.0, 1e4);
  timers.done();
  readExistence(reader.map("existence"), p.existence);
}

void readLocalClutter(ParameterReader& reader, ClutterParams& p) {
  reader.number("drop_time_s", p.drop_time, 1.0, 1e6);
  reader.integer("hits", p.hits, 1, 1000);
  reader.flag("yields_to_tracks", p.yields_to_tracks);
  reader.done();
}

void readLocalConversion(ParameterReader& reader, ConversionParams& p) {
  scaledNumber(reader, "speed_up_kn", p.speed_up, tws::kMetresPerSecondPerKnot, 0.0, 10000.0);
  scaledNumber(reader, "speed_down_kn", p.speed_down, tws::kMetresPerSecondPerKnot, 0.0, 10000.0);
  reader.number("speed_sigmas", p.speed_sigmas, 0.0, 100.0);
  scaledNumber(reader, "quiet_density_per_km2", p.quiet_density, 1e-6, 0.0, 1e6);
  reader.done();
}

void readClutter(ParameterReader reader, ClutterParams& p) {
  reader.flag("per_radar", p.per_radar);
  reader.integer("capacity", p.capacity, 2, 1000001);
  reader.number("gate_range_m", p.gate.range, 1.0, 1e5);
  scaledNumber(reader, "gate_azimuth_deg", p.gate.azimuth, tws::kRadiansPerDegree, 0.001,
               tws::degrees(tws::kSectorWidth));
  reader.number("gate_sigmas", p.gate_sigmas, 0.0, 100.0);
  reader.number("range_weight", p.gate.range_weight, 0.0, 1e6);
  reader.number("azimuth_weight", p.gate.azimuth_weight, 0.0, 1e6);
  reader.number("smoothing", p.smoothing, 1e-3, 1.0);
  readLocalClutter(reader, p);
}

void readConversion(ParameterReader reader, ConversionParams& p) {
  reader.integer("scans", p.scans, 2, 1000);
  scaledNumber(reader, "azimuth_rate_deg_per_s", p.azimuth_rate, tws::kRadiansPerDegree, 0.0, 100.0);
  reader.flag("over_ground", p.over_ground);
  reader.flag("from_start", p.from_start);
  readLocalConversion(reader, p);
}

void readStitching(ParameterReader reader, StitchingParams& p) {
  reader.number("longest_gap_scans", p.longest_gap, 0.0, 1000.0);
  reader.number("speed_change_mps", p.speed_change, 0.0, 10000.0);
  reader.done();
}

void readLocalParting(ParameterReader& reader, PartingParams& p) {
  reader.number("unresolved_time_s", p.unresolved_time, 0.0, 1e6);
  reader.number("branch_time_s", p.branch_time, 0.0, 1e6);
  reader.number("speed_mps", p.speed, 0.0, 1e4);
  reader.number("speed_sigma_mps", p.speed_sigma, 0.1, 1e5);
  reader.number("per_scan", p.per_scan, 1e-6, 1e3);
  reader.number("moving_evidence", p.moving_evidence, -kMost, 1e3);
  reader.integer("firm_updates", p.firm_updates, 2, 100);
  reader.done();
}

void readParting(ParameterReader reader, PartingParams& p) {
  reader.number("cell_range_sigmas", p.cell_range_sigmas, 0.0, 1000.0);
  reader.number("cell_azimuth_sigmas", p.cell_azimuth_sigmas, 0.0, 1000.0);
  readLocalParting(reader, p);
}

void readOperators(ParameterReader reader, OperatorParams& p) {
  reader.integer("page", p.page, 0, 1000001);
  reader.number("point_sigma_m", p.point_sigma, 1.0, 1e5);
  reader.done();
}

void readElevation(ParameterReader reader, ElevationParams& p) {
  reader.text("radar", p.radar);
  reader.integer("per_scan", p.per_scan, 1, 1000);
  reader.integer("new_per_scan", p.new_per_scan, 1, 1000);
  reader.integer("every_scans", p.every_scans, 1, 1000);
  scaledNumber(reader, "lead_deg", p.lead, tws::kRadiansPerDegree, 0.0, 90.0);
  reader.flag("automatic", p.automatic);
  scaledNumber(reader, "sigma_deg", p.sigma, tws::kRadiansPerDegree, 1e-4, 20.0);
  reader.number("climb_sigma_mps", p.climb_sigma, 0.1, 1e4);
  reader.number("climb_acceleration", p.climb_acceleration, 0.0, 1e6);
  reader.number("gate_sigmas", p.gate_sigmas, 0.5, 100.0);
  reader.number("greatest_sigma_m", p.greatest_sigma, 1.0, 1e6);
  reader.done();
}

/// Of a map within a volume: refuses what is known at the top level alone by saying so.
void refuse(const ParameterReader& reader, const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (reader.has(key)) reader.fail(key, "holds for the whole tracker; no volume can have its own");
}

/// Two numbers that grow, the limits of a region.
void readLimits(ParameterReader& reader, const std::string& key, double least, double greatest, double& from,
                double& to) {
  std::vector<double> limits;
  reader.numbers(key, limits, least, greatest);
  if (!reader.has(key)) return;
  if (limits.size() != 2 || limits[0] >= limits[1])
    reader.fail(key, "needs two numbers, the second greater than the first");
  from = limits[0];
  to = limits[1];
}

/// Clockwise from the first to the second, which may lie past north.
void readAzimuths(ParameterReader& reader, VolumeRegion& region) {
  std::vector<double> limits;
  reader.numbers("azimuth_deg", limits, 0.0, 360.0);
  if (!reader.has("azimuth_deg")) return;
  if (limits.size() != 2 || limits[0] == limits[1])
    reader.fail("azimuth_deg", "needs two numbers that differ: clockwise from the first to the second");
  region.first_azimuth = tws::wrapTwoPi(tws::radians(limits[0]));
  region.azimuths = tws::radians(limits[1] - limits[0]) + (limits[1] < limits[0] ? tws::kTwoPi : 0.0);
}

VolumeRegion readRegion(ParameterReader& reader) {
  VolumeRegion region;
  readLimits(reader, "range_m", 0.0, kFarthest, region.least_range, region.greatest_range);
  readAzimuths(reader, region);
  readLimits(reader, "height_m", -1e4, 1e6, region.least_height, region.greatest_height);
  std::string unknown = "inside";
  reader.choice("unknown_height", unknown, {"inside", "outside"});
  region.holds_unknown_height = unknown == "inside";
  if (!reader.has("range_m") && !reader.has("azimuth_deg") && !reader.has("height_m"))
    reader.fail("name", "this volume needs range_m, azimuth_deg or height_m: it is nowhere");
  return region;
}

/// The top level's values, or those of the volume's own set, and what the volume's keys change.
LocalParams readLocal(ParameterReader& reader, const LocalParams& base) {
  LocalParams p = base;
  if (reader.has("set")) {
    std::string set;
    reader.choice("set", set, {"airport", "default", "marine"});
    p = AditParams::named(set);
    p.conversion.over_ground = base.conversion.over_ground;
    p.conversion.azimuth_rate = base.conversion.azimuth_rate;
    p.turning.fast_share = base.turning.fast_share;
  }
  ParameterReader turning = reader.map("turning"), clutter = reader.map("clutter"),
                  conversion = reader.map("conversion"), parting = reader.map("parting");
  refuse(turning, {"fast_share"});
  readTurning(turning, p.turning);
  readExistence(reader.map("existence"), p.existence);
  refuse(clutter, {"per_radar", "capacity", "gate_range_m", "gate_azimuth_deg", "gate_sigmas", "range_weight",
                   "azimuth_weight", "smoothing"});
  readLocalClutter(clutter, p.clutter);
  refuse(conversion, {"scans", "azimuth_rate_deg_per_s", "over_ground", "from_start"});
  readLocalConversion(conversion, p.conversion);
  readStitching(reader.map("stitching"), p.stitching);
  refuse(parting, {"cell_range_sigmas", "cell_azimuth_sigmas"});
  readLocalParting(parting, p.parting);
  return p;
}

std::vector<Volume> readVolumes(ParameterReader& reader, const LocalParams& base) {
  std::vector<Volume> volumes;
  std::vector<ParameterReader> entries = reader.list("volumes");
  if (entries.size() > kMostVolumes)
    reader.fail("volumes", std::to_string(entries.size()) + " are too many: at most " + std::to_string(kMostVolumes));
  for (ParameterReader& entry : entries) {
    refuse(entry, {"radars",      "iff",          "reference_radar", "capacity",    "skew_limit_s",   "filter",
                   "alpha_beta",  "learn_noise",  "gates",           "track_gates", "gate_distances", "gate_sigmas",
                   "association", "life",         "timers",          "coverage",    "bifurcation",    "operator",
                   "elevation",   "registration", "volumes"});
    Volume& volume = volumes.emplace_back();
    entry.require("name");
    entry.text("name", volume.name);
    volume.region = readRegion(entry);
    volume.params = readLocal(entry, base);
    entry.done();
  }
  return volumes;
}

}  // namespace

AditParams readAditParams(ParameterReader& reader, const std::string& default_set) {
  std::string set = default_set;
  reader.choice("set", set, AditParams::sets());
  AditParams p = AditParams::named(set);
  readRadars(reader, p.radars);
  readIff(reader, p.iff);
  reader.text("reference_radar", p.reference_radar);
  reader.integer("capacity", p.capacity, 2, 1000001);
  reader.number("skew_limit_s", p.skew_limit, 0.0, 60.0);
  readFilters(reader, p);
  reader.flag("learn_noise", p.learn_noise);
  choice(reader, "gates", p.gates, {{"fixed", GateKind::kFixed}, {"statistical", GateKind::kStatistical}});
  readGates(reader.map("track_gates"), p.track_gates);
  readGateDistances(reader, p.gate_distances);
  reader.number("gate_sigmas", p.gate_sigmas, 0.5, 20.0);
  choice(reader, "association", p.association, {{"passes", Association::kPasses}, {"chances", Association::kChances}});
  readLife(reader, p);
  readClutter(reader.map("clutter"), p.clutter);
  readConversion(reader.map("conversion"), p.conversion);
  readStitching(reader.map("stitching"), p.stitching);
  ParameterReader coverage = reader.map("coverage");
  coverage.number("longest_gap_s", p.coverage.longest_gap, 0.0, 1e3);
  coverage.done();
  reader.flag("bifurcation", p.bifurcation);
  readParting(reader.map("parting"), p.parting);
  readOperators(reader.map("operator"), p.operators);
  readRegistrationParams(reader.map("registration"), p.registration, p.registration_references);
  readElevation(reader.map("elevation"), p.elevation);
  p.volumes = readVolumes(reader, p);
  return p;
}

bool isNamedSet(const std::string& name) {
  const auto& sets = AditParams::sets();
  return std::find(sets.begin(), sets.end(), name) != sets.end();
}

AditParams loadAditParams(const std::string& name_or_file) {
  if (isNamedSet(name_or_file)) return AditParams::named(name_or_file);
  ParameterReader reader(tws_runtime::loadParameterFile(name_or_file), name_or_file);
  AditParams params = readAditParams(reader);
  reader.done();
  return params;
}

}  // namespace adit_tracker
