#include "adit_params_reader.h"

#include <algorithm>
#include <limits>

namespace adit_tracker {
namespace {

using tws_runtime::ParameterError;
using tws_runtime::ParameterReader;

constexpr double kMost = 1e9;

template <class T>
void choice(ParameterReader& reader, const std::string& key, T& value,
            const std::vector<std::pair<std::string, T>>& names) {
  std::vector<std::string> allowed;
  std::string chosen;
  for (const auto& [name, meaning] : names) {
    allowed.push_back(name);
    if (meaning == value) chosen = name;
  }
  reader.choice(key, chosen, allowed);
  value = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == chosen; })->second;
}

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
  scaledNumber(turning, "turn_rate_deg_per_s", p.turning.turn_rate, tws::kRadiansPerDegree, 0.01, 28.0);
  scaledNumber(turning, "turn_rate_sigma_deg_per_s", p.turning.turn_rate_sigma, tws::kRadiansPerDegree, 0.0, 28.0);
  turning.number("straight_acceleration", p.turning.straight_acceleration, 0.0, 1e6);
  turning.number("turning_acceleration", p.turning.turning_acceleration, 0.0, 1e6);
  turning.number("free_acceleration", p.turning.free_acceleration, 0.0, 1e6);
  turning.number("straight_time_s", p.turning.straight_time, 0.1, 1e6);
  turning.number("turning_time_s", p.turning.turning_time, 0.1, 1e6);
  turning.number("free_time_s", p.turning.free_time, 0.1, 1e6);
  turning.number("free_share", p.turning.free_share, 0.0, 0.9);
  turning.number("assumed_height_m", p.turning.assumed_height, 0.0, 50000.0);
  turning.number("manoeuvre_acceleration", p.turning.manoeuvre_acceleration, 0.0, 1000.0);
  turning.number("speed_sigma_mps", p.turning.speed_sigma, 0.1, 1e5);
  turning.number("fast_speed_sigma_mps", p.turning.fast_speed_sigma, 0.0, 1e5);
  turning.number("fast_share", p.turning.fast_share, 0.0, 0.5);
  turning.done();
}

void readLife(ParameterReader& reader, AditParams& p) {
  choice(reader, "life", p.life, {{"timers", TrackLife::kTimers}, {"existence", TrackLife::kExistence}});
  ParameterReader timers = reader.map("timers");
  timers.number("tentative_drop_time_s", p.timers.tentative_drop_time, 0.1, 1e4);
  timers.number("drop_time_s", p.timers.drop_time, 0.1, 1e4);
  timers.number("firm_time_s", p.timers.firm_time, 0.0, 1e4);
  timers.done();
  ParameterReader e = reader.map("existence");
  e.number("new_targets", p.existence.new_targets, 1e-6, 1e6);
  e.number("firm_probability", p.existence.firm_probability, 0.5, 0.99999);
  e.integer("firm_updates", p.existence.firm_updates, 2, 100);
  e.number("moving_evidence", p.existence.moving_evidence, -kMost, 1e3);
  e.number("drop_probability", p.existence.drop_probability, 1e-9, 0.5);
  e.number("doubt_probability", p.existence.doubt_probability, 0.0, 0.99);
  e.number("tentative_drop_fraction", p.existence.tentative_drop_fraction, 1e-9, 1.0);
  e.number("detection_probability", p.existence.detection_probability, 0.05, 0.99);
  e.number("survival_time_s", p.existence.survival_time, 1.0, kMost);
  e.done();
}

void readClutter(ParameterReader& reader, AditParams& p) {
  ParameterReader c = reader.map("clutter");
  c.flag("per_radar", p.clutter.per_radar);
  c.integer("capacity", p.clutter.capacity, 2, 1000001);
  c.number("drop_time_s", p.clutter.drop_time, 1.0, 1e6);
  c.number("gate_range_m", p.clutter.gate.range, 1.0, 1e5);
  scaledNumber(c, "gate_azimuth_deg", p.clutter.gate.azimuth, tws::kRadiansPerDegree, 0.001,
               tws::degrees(tws::kSectorWidth));
  c.number("gate_sigmas", p.clutter.gate_sigmas, 0.0, 100.0);
  c.number("range_weight", p.clutter.gate.range_weight, 0.0, 1e6);
  c.number("azimuth_weight", p.clutter.gate.azimuth_weight, 0.0, 1e6);
  c.integer("hits", p.clutter.hits, 1, 1000);
  c.number("smoothing", p.clutter.smoothing, 1e-3, 1.0);
  c.flag("yields_to_tracks", p.clutter.yields_to_tracks);
  c.done();
  ParameterReader v = reader.map("conversion");
  v.integer("scans", p.conversion.scans, 2, 1000);
  scaledNumber(v, "speed_up_kn", p.conversion.speed_up, tws::kMetresPerSecondPerKnot, 0.0, 10000.0);
  scaledNumber(v, "speed_down_kn", p.conversion.speed_down, tws::kMetresPerSecondPerKnot, 0.0, 10000.0);
  v.number("speed_sigmas", p.conversion.speed_sigmas, 0.0, 100.0);
  scaledNumber(v, "quiet_density_per_km2", p.conversion.quiet_density, 1e-6, 0.0, 1e6);
  scaledNumber(v, "azimuth_rate_deg_per_s", p.conversion.azimuth_rate, tws::kRadiansPerDegree, 0.0, 100.0);
  v.flag("over_ground", p.conversion.over_ground);
  v.flag("from_start", p.conversion.from_start);
  v.done();
}

void readStitching(ParameterReader reader, StitchingParams& p) {
  reader.number("longest_gap_scans", p.longest_gap, 0.0, 1000.0);
  reader.number("speed_change_mps", p.speed_change, 0.0, 10000.0);
  reader.done();
}

void readParting(ParameterReader reader, PartingParams& p) {
  reader.number("cell_range_sigmas", p.cell_range_sigmas, 0.0, 1000.0);
  reader.number("cell_azimuth_sigmas", p.cell_azimuth_sigmas, 0.0, 1000.0);
  reader.number("unresolved_time_s", p.unresolved_time, 0.0, 1e6);
  reader.number("branch_time_s", p.branch_time, 0.0, 1e6);
  reader.number("speed_mps", p.speed, 0.0, 1e4);
  reader.number("speed_sigma_mps", p.speed_sigma, 0.1, 1e5);
  reader.number("per_scan", p.per_scan, 1e-6, 1e3);
  reader.number("moving_evidence", p.moving_evidence, -kMost, 1e3);
  reader.integer("firm_updates", p.firm_updates, 2, 100);
  reader.done();
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
  readClutter(reader, p);
  readStitching(reader.map("stitching"), p.stitching);
  ParameterReader coverage = reader.map("coverage");
  coverage.number("longest_gap_s", p.coverage.longest_gap, 0.0, 1e3);
  coverage.done();
  reader.flag("bifurcation", p.bifurcation);
  readParting(reader.map("parting"), p.parting);
  readOperators(reader.map("operator"), p.operators);
  readElevation(reader.map("elevation"), p.elevation);
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
