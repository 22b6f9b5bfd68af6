#include "adit_params.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "core/track.h"

namespace adit_tracker {
namespace {

void require(bool good, const std::string& name, double value, const std::string& range) {
  if (good) return;
  std::ostringstream text;
  text << name << ": " << value << " is not in " << range;
  throw std::invalid_argument(text.str());
}

void checkRadars(const AditParams& params) {
  const auto count = static_cast<double>(params.radars.size());
  require(count >= 1 && count <= kMaxRadars, "number of radars", count, "[1, 8]");
  std::set<std::string> names;
  for (const RadarParams& r : params.radars) {
    if (r.name.empty()) throw std::invalid_argument("radars: a radar has no name");
    if (!names.insert(r.name).second) throw std::invalid_argument("radars: two radars are named " + r.name);
    require(r.period >= 0.5 && r.period <= 120.0, "period of " + r.name, r.period, "[0.5, 120] s");
    require(r.range_sigma > 0.0 && r.range_sigma <= 1e5, "range_sigma of " + r.name, r.range_sigma, "(0, 100000] m");
    require(r.azimuth_sigma > 0.0 && r.azimuth_sigma <= 0.5, "azimuth_sigma of " + r.name, r.azimuth_sigma,
            "(0, 0.5] rad");
    require(r.range_rate_sigma >= 0.0 && r.range_rate_sigma <= 1e3, "range_rate_sigma of " + r.name, r.range_rate_sigma,
            "[0, 1000] m/s");
    require(r.range_rate_span >= 1.0 && r.range_rate_span <= 1e5, "range_rate_span of " + r.name, r.range_rate_span,
            "[1, 100000] m/s");
    require(r.range_rate_ambiguity >= 0.0 && r.range_rate_ambiguity <= 1e5, "range_rate_ambiguity of " + r.name,
            r.range_rate_ambiguity, "[0, 100000] m/s");
  }
  if (!params.reference_radar.empty() && names.count(params.reference_radar) == 0) {
    throw std::invalid_argument("reference_radar: there is no radar named " + params.reference_radar);
  }
  if (!params.elevation.radar.empty() && names.count(params.elevation.radar) == 0)
    throw std::invalid_argument("elevation.radar: there is no radar named " + params.elevation.radar);
}

void checkIff(const AditParams& params) {
  require(params.iff.size() <= kMaxRadars, "number of secondary radars (iff)", static_cast<double>(params.iff.size()),
          "[0, 8]");
  std::set<std::string> names;
  for (const IffParams& iff : params.iff) {
    if (iff.name.empty()) throw std::invalid_argument("iff: a secondary radar has no name");
    if (!names.insert(iff.name).second) throw std::invalid_argument("iff: two secondary radars are named " + iff.name);
    require(iff.range_sigma > 0.0, "range_sigma of " + iff.name, iff.range_sigma, "(0, inf) m");
    require(iff.azimuth_sigma > 0.0, "azimuth_sigma of " + iff.name, iff.azimuth_sigma, "(0, inf) rad");
  }
}

void checkGates(const AditParams& params) {
  for (std::size_t g = 0; g < kGates; ++g) {
    const std::string name = "gate " + std::to_string(g + 1);
    require(params.track_gates[g].range > 0.0, name + " in range", params.track_gates[g].range, "(0, inf) m");
    require(params.track_gates[g].azimuth > 0.0 && params.track_gates[g].azimuth <= tws::kSectorWidth,
            name + " in azimuth", params.track_gates[g].azimuth,
            "(0, 0.0982] rad: only neighbouring sectors are searched");
    if (g > 0 && params.track_gates[g].range < params.track_gates[g - 1].range) {
      throw std::invalid_argument(name + " is smaller than the one before");
    }
  }
  if (!std::is_sorted(params.gate_distances.begin(), params.gate_distances.end())) {
    throw std::invalid_argument("gate_distances: they must grow from one to the next");
  }
  if (params.gates == GateKind::kStatistical && params.filter != FilterKind::kTurning) {
    throw std::invalid_argument("gates: statistical gates need the turning filter, which has a covariance");
  }
  if (params.learn_noise && params.gates != GateKind::kStatistical) {
    throw std::invalid_argument("learn_noise: needs statistical gates");
  }
  if (params.life == TrackLife::kExistence && params.gates != GateKind::kStatistical) {
    throw std::invalid_argument("life: the chance of existence needs statistical gates");
  }
  if (params.association == Association::kChances && params.life != TrackLife::kExistence) {
    throw std::invalid_argument("association: chances need the chance of existence (life)");
  }
}

void checkVolumes(const AditParams& params) {
  if (params.volumes.empty()) return;
  if (params.life != TrackLife::kExistence)
    throw std::invalid_argument("volumes: need the turning filter and the chance of existence (life)");
  require(params.volumes.size() <= kMostVolumes, "number of volumes", static_cast<double>(params.volumes.size()),
          "[0, 1000]");
  std::set<std::string> names;
  for (const Volume& volume : params.volumes) {
    if (!names.insert(volume.name).second) throw std::invalid_argument("volumes: two volumes are named " + volume.name);
  }
}

constexpr double feet(double value) { return value * tws::kMetresPerFoot; }

/// Even steps from 2000 ft × 1.4° to 14 000 ft × 5.6°; the three between are our choice.
std::array<Gate, kGates> reportGates() {
  std::array<Gate, kGates> gates;
  for (std::size_t g = 0; g < kGates; ++g) {
    const double step = static_cast<double>(g) / (kGates - 1);
    gates[g].range = feet(2000.0 + step * 12000.0);
    gates[g].azimuth = tws::radians(1.4 + step * 4.2);
  }
  return gates;
}

/// Boats and ships, seen by a radar of a harbour or a vessel.
void makeMarine(AditParams& p) {
  p.turning.turn_rate = tws::radians(6.0);
  p.turning.turn_rate_sigma = tws::radians(3.0);
  p.turning.straight_acceleration = 0.02;
  p.turning.turning_acceleration = 0.2;
  p.turning.free_acceleration = 1.0;
  p.turning.assumed_height = 0.0;
  p.turning.manoeuvre_acceleration = 0.5;
  p.turning.speed_sigma = 8.0;
  p.turning.fast_speed_sigma = 0.0;
  p.existence.firm_updates = 4;
  p.parting.speed = 5.0;
  p.parting.speed_sigma = 2.0;
  p.conversion.speed_up = tws::speedFromKnots(1.0);
  p.conversion.speed_down = tws::speedFromKnots(0.5);
}

/// What flies, drives and stands at an airport and about it, seen by its approach radar.
void makeAirport(AditParams& p) {
  p.existence.firm_speed = 21.0;
  p.conversion.speed_up = tws::speedFromKnots(8.0);
  p.conversion.speed_down = tws::speedFromKnots(4.0);
}

}  // namespace

bool isFaster(double range_rate, double azimuth_rate, double range, double speed, const ConversionParams& params) {
  if (params.over_ground) return std::hypot(range_rate, range * azimuth_rate) > speed;
  return std::abs(range_rate) > speed || std::abs(azimuth_rate) > params.azimuth_rate;
}

const std::vector<std::string>& AditParams::sets() {
  static const std::vector<std::string> sets{"airport", "default", "marine", "nrl7952"};
  return sets;
}

std::string AditParams::setNames() {
  std::string names;
  for (const std::string& set : sets()) names += (names.empty() ? "" : ", ") + set;
  return names;
}

AditParams AditParams::named(const std::string& name) {
  if (std::count(sets().begin(), sets().end(), name) == 0)
    throw std::invalid_argument("parameter set: there is no set named " + name + " (" + setNames() + ")");
  AditParams p;
  p.track_gates = reportGates();
  p.clutter.gate.range = feet(2000.0);
  p.clutter.gate.azimuth = tws::radians(1.4);
  if (name == "marine") makeMarine(p);
  if (name == "airport") makeAirport(p);
  if (name != "nrl7952") return p;
  p.capacity = 256;
  p.filter = FilterKind::kAlphaBeta;
  p.learn_noise = false;
  p.registration.mode = tws::RegistrationMode::kOff;
  p.bifurcation = false;
  p.parting.firm_updates = 3;  // there is no other evidence
  p.gates = GateKind::kFixed;
  p.association = Association::kPasses;
  p.life = TrackLife::kTimers;
  p.alpha_beta.damping = 0.9;
  p.alpha_beta.omega_min = 0.1;
  p.clutter.per_radar = false;
  p.clutter.capacity = 256;
  p.clutter.gate_sigmas = 0.0;
  p.clutter.hits = 1;
  p.clutter.smoothing = 1.0;
  p.clutter.yields_to_tracks = false;
  p.conversion.scans = 8;
  p.operators.page = 32;
  p.stitching.longest_gap = 0.0;
  p.coverage.longest_gap = 0.0;
  p.conversion.speed_sigmas = 0.0;
  p.conversion.over_ground = false;
  p.conversion.from_start = false;
  p.conversion.speed_up = tws::speedFromKnots(45.0);
  p.conversion.speed_down = tws::speedFromKnots(56.0);
  return p;
}

bool joinsSites(const AditParams& params) {
  return params.filter == FilterKind::kTurning && params.gates == GateKind::kStatistical && params.clutter.per_radar;
}

std::size_t radarIndex(const AditParams& params, const std::string& name) {
  for (std::size_t i = 0; i < params.radars.size(); ++i) {
    if (params.radars[i].name == name) return i;
  }
  return params.radars.size() - 1;
}

std::uint16_t AditParams::volumeAt(const VolumePlace& place, std::uint16_t before) const {
  constexpr double kMargin = 300.0;  // [m], some standard deviations of a position
  std::size_t number = 0;            // at most kMostVolumes
  for (const Volume& volume : volumes) {
    if (volume.region.contains(place, ++number == before ? kMargin : 0.0)) return static_cast<std::uint16_t>(number);
  }
  return 0;
}

void check(const AditParams& params) {
  checkRadars(params);
  checkIff(params);
  checkGates(params);
  checkVolumes(params);
  tws::check(params.alpha_beta);
  require(params.capacity >= 2 && params.capacity <= 1000001, "capacity", params.capacity, "[2, 1000001]");
  require(params.clutter.capacity >= 2, "clutter capacity", params.clutter.capacity, "[2, 1000001]");
  require(params.skew_limit >= 0.0, "skew_limit", params.skew_limit, "[0, inf) s");
  require(params.clutter.hits >= 1, "clutter hits", static_cast<double>(params.clutter.hits), "[1, inf)");
  require(params.conversion.scans >= 2, "conversion scans", static_cast<double>(params.conversion.scans), "[2, inf)");
}

}  // namespace adit_tracker
