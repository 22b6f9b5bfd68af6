#include <algorithm>
#include <set>

#include <tws_core/units.h>

#include "array_reader.h"
#include "radar_reader.h"
#include "range_reader.h"
#include "reading.h"
#include "scenario.h"
#include "secondary_reader.h"
#include "target_reader.h"

namespace radar_sim {
namespace {

void readGeneral(ParameterReader& reader, Scenario& scenario) {
  long seed = static_cast<long>(scenario.seed);
  reader.integer("seed", seed, 0, std::numeric_limits<long>::max());
  scenario.seed = static_cast<std::uint64_t>(seed);
  reader.number("duration_s", scenario.duration, 1.0, kLongest);
  reader.number("start_time_s", scenario.start_time, 1.0, kLongest);
  reader.number("truth_period_s", scenario.truth_period, 0.01, 3600.0);
  ParameterReader origin = reader.map("origin");
  scaledNumber(origin, "latitude_deg", scenario.origin.latitude, tws::kRadiansPerDegree, -90.0, 90.0);
  scaledNumber(origin, "longitude_deg", scenario.origin.longitude, tws::kRadiansPerDegree, -360.0, 360.0);
  origin.number("altitude_m", scenario.origin.altitude, -500.0, 9000.0);
  origin.done();
}

/// Names must differ, also those of different lists.
void refuseSecond(std::set<std::string>& names, const std::string& name, const ParameterReader& reader) {
  if (!names.insert(name).second) reader.fail("name", "'" + name + "' is used twice");
}

void readSites(ParameterReader& reader, const ReadingContext& context, Scenario& scenario) {
  std::set<std::string> names;
  for (ParameterReader& entry : reader.list("sites")) {
    Site site;
    readName(entry, site.name);
    refuseSecond(names, site.name, entry);
    site.position = readPlace(entry, context, Eigen::Vector2d(0.0, 0.0));
    entry.done();
    scenario.sites.push_back(site);
  }
  if (scenario.sites.empty()) scenario.sites.push_back({"origin", {0.0, 0.0}});
}

/// Where there is one site only, a radar need not name it.
void settleSite(std::string& site, const Scenario& scenario, const ParameterReader& entry) {
  if (site.empty() && scenario.sites.size() > 1) entry.fail("site", "is required, as there are several sites");
  if (site.empty()) site = scenario.sites.front().name;
  const auto isItsSite = [&](const Site& known) { return known.name == site; };
  if (std::none_of(scenario.sites.begin(), scenario.sites.end(), isItsSite))
    entry.fail("site", "there is no site '" + site + "'");
}

/// Of the range radar just read.
void refuseUnknownTarget(const Scenario& scenario, const ParameterReader& entry) {
  const std::string& target = scenario.range_radars.back().target;
  const auto isIt = [&](const Target& known) { return known.name == target; };
  if (std::none_of(scenario.targets.begin(), scenario.targets.end(), isIt))
    entry.fail("target", "there is no target '" + target + "' in the list targets");
}

void readRadars(ParameterReader& reader, Scenario& scenario) {
  std::set<std::string> names;
  for (ParameterReader& entry : reader.list("radars")) {
    scenario.radars.push_back(readRadar(entry));
    refuseSecond(names, scenario.radars.back().name, entry);
    settleSite(scenario.radars.back().site, scenario, entry);
  }
  for (ParameterReader& entry : reader.list("secondary_radars")) {
    scenario.secondary_radars.push_back(readSecondaryRadar(entry, scenario.radars));
    refuseSecond(names, scenario.secondary_radars.back().name, entry);
    settleSite(scenario.secondary_radars.back().site, scenario, entry);
  }
  for (ParameterReader& entry : reader.list("array_radars")) {
    scenario.array_radars.push_back(readArrayRadar(entry));
    refuseSecond(names, scenario.array_radars.back().name, entry);
    settleSite(scenario.array_radars.back().site, scenario, entry);
  }
  for (ParameterReader& entry : reader.list("range_radars")) {
    scenario.range_radars.push_back(readRangeRadar(entry));
    refuseSecond(names, scenario.range_radars.back().name, entry);
    settleSite(scenario.range_radars.back().site, scenario, entry);
    refuseUnknownTarget(scenario, entry);
  }
}

void readTargets(ParameterReader& reader, const ReadingContext& context, Scenario& scenario) {
  std::set<std::string> names;
  const auto add = [&](Target target, const ParameterReader& entry) {
    refuseSecond(names, target.name, entry);
    scenario.targets.push_back(std::move(target));
  };
  const auto addGroups = [&](const std::string& key, TargetKind kind) {
    for (ParameterReader& entry : reader.list(key)) {
      scenario.groups.push_back(readGroup(entry, kind, context));
      refuseSecond(names, scenario.groups.back().name, entry);
    }
  };
  for (ParameterReader& entry : reader.list("targets")) add(readTarget(entry, context), entry);
  for (ParameterReader& entry : reader.list("clutter")) add(readClutterPoint(entry, context), entry);
  addGroups("random_aircraft", TargetKind::kAircraft);
  addGroups("random_clutter", TargetKind::kClutter);
  addGroups("random_slow_movers", TargetKind::kSlowMover);
}

Fault readFault(ParameterReader& reader, const Scenario& scenario) {
  Fault fault;
  std::string type;
  reader.require("type");
  reader.choice("type", type, {"outage", "missed_scan", "false_alarm_burst"});
  std::vector<std::string> radars;
  for (const RadarParams& radar : scenario.radars) radars.push_back(radar.name);
  // A secondary radar has no false alarms: its FRUIT is a parameter of its own; nor does an array scan.
  if (type != "false_alarm_burst") {
    for (const SecondaryParams& radar : scenario.secondary_radars) radars.push_back(radar.name);
    for (const ArrayParams& radar : scenario.array_radars) radars.push_back(radar.name);
    if (type == "outage")
      for (const RangeRadarParams& radar : scenario.range_radars) radars.push_back(radar.name);
  }
  reader.require("radar");
  reader.choice("radar", fault.radar, radars);
  reader.require("from_s");
  reader.require("to_s");
  reader.number("from_s", fault.from, 0.0, kLongest);
  reader.number("to_s", fault.to, 0.0, kLongest);
  if (fault.to <= fault.from) reader.fail("to_s", "is not later than from_s");
  fault.from += scenario.start_time;
  fault.to += scenario.start_time;
  if (type == "missed_scan") fault.kind = FaultKind::kMissedScan;
  if (type == "false_alarm_burst") {
    fault.kind = FaultKind::kFalseAlarmBurst;
    reader.require("false_alarms_per_scan");
    reader.number("false_alarms_per_scan", fault.false_alarms_per_scan, 0.0, 1e6);
    scaledNumber(reader, "azimuth_from_deg", fault.azimuth_from, tws::kRadiansPerDegree, 0.0, 360.0);
    scaledNumber(reader, "azimuth_to_deg", fault.azimuth_to, tws::kRadiansPerDegree, 0.0, 720.0);
    if (fault.azimuth_to <= fault.azimuth_from)
      reader.fail("azimuth_to_deg", "is not greater than azimuth_from_deg (350 to 370 crosses north)");
  }
  reader.done();
  return fault;
}

void readTrackFeed(ParameterReader& reader, Scenario& scenario) {
  if (!reader.has("track_feed")) return;
  ParameterReader entry = reader.map("track_feed");
  TrackFeedParams feed;
  std::vector<std::string> radars;
  for (const RadarParams& radar : scenario.radars) radars.push_back(radar.name);
  entry.require("clock_radar");
  entry.choice("clock_radar", feed.clock_radar, radars);
  entry.number("position_sigma_m", feed.position_sigma, 0.0, 1e4);
  entry.number("velocity_sigma_mps", feed.velocity_sigma, 0.0, 1e3);
  entry.done();
  scenario.track_feed = feed;
}

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

}  // namespace

Scenario loadScenario(const std::string& path, const ScenarioOverrides& overrides) {
  const YAML::Node tree = tws_runtime::loadParameterFile(path);
  ParameterReader reader(tree, path);
  Scenario scenario;
  readGeneral(reader, scenario);
  const ReadingContext context{tws::LocalFrame(scenario.origin), scenario.start_time, folderOf(path)};
  readSites(reader, context, scenario);
  readTargets(reader, context, scenario);
  readRadars(reader, scenario);
  for (ParameterReader& entry : reader.list("faults")) scenario.faults.push_back(readFault(entry, scenario));
  readTrackFeed(reader, scenario);
  reader.map("trackers");  // throws when it is no map
  if (tree["trackers"] && tree["trackers"].IsMap()) scenario.trackers = tree["trackers"];
  reader.done();
  scenario.seed = overrides.seed.value_or(scenario.seed);
  scenario.duration = overrides.duration.value_or(scenario.duration);
  return scenario;
}

}  // namespace radar_sim
