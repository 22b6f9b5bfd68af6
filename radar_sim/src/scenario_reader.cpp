#include <limits>
#include <memory>
#include <set>

#include <tws_core/units.h>

#include "clutter/clutter_kinds.h"
#include "reading.h"
#include "scenario.h"
#include "sensor_kinds.h"
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

std::vector<ParameterReader> entriesOf(ParameterReader& reader, const SensorKind& kind) {
  if (kind.form == SensorKind::Form::kList) return reader.list(kind.key);
  if (!reader.has(kind.key)) return {};
  return {reader.map(kind.key)};
}

void readSensors(ParameterReader& reader, const std::vector<SensorKind>& kinds, Scenario& scenario) {
  std::set<std::string> names;
  for (const SensorKind& kind : kinds) {
    for (ParameterReader& entry : entriesOf(reader, kind)) {
      std::shared_ptr<SensorSpec> sensor = kind.read(entry, scenario);
      sensor->kind = kind.key;
      refuseSecond(names, sensor->name, entry);
      scenario.sensors.push_back(std::move(sensor));
    }
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

FaultKind readFaultKind(ParameterReader& reader) {
  std::string type;
  reader.require("type");
  reader.choice("type", type, {"outage", "missed_scan", "false_alarm_burst"});
  if (type == "outage") return FaultKind::kOutage;
  return type == "missed_scan" ? FaultKind::kMissedScan : FaultKind::kFalseAlarmBurst;
}

/// Names of the sensors that can have such a fault.
std::vector<std::string> sensorsFor(FaultKind fault, const Scenario& scenario) {
  std::vector<std::string> names;
  for (const auto& sensor : scenario.sensors)
    if (sensor->canHave(fault)) names.push_back(sensor->name);
  return names;
}

void readBurst(ParameterReader& reader, Fault& fault) {
  reader.require("false_alarms_per_scan");
  reader.number("false_alarms_per_scan", fault.false_alarms_per_scan, 0.0, 1e6);
  scaledNumber(reader, "azimuth_from_deg", fault.azimuth_from, tws::kRadiansPerDegree, 0.0, 360.0);
  scaledNumber(reader, "azimuth_to_deg", fault.azimuth_to, tws::kRadiansPerDegree, 0.0, 720.0);
  if (fault.azimuth_to <= fault.azimuth_from)
    reader.fail("azimuth_to_deg", "is not greater than azimuth_from_deg (350 to 370 crosses north)");
}

Fault readFault(ParameterReader& reader, const Scenario& scenario) {
  Fault fault;
  fault.kind = readFaultKind(reader);
  reader.require("radar");
  reader.choice("radar", fault.radar, sensorsFor(fault.kind, scenario));
  reader.require("from_s");
  reader.require("to_s");
  reader.number("from_s", fault.from, 0.0, kLongest);
  reader.number("to_s", fault.to, 0.0, kLongest);
  if (fault.to <= fault.from) reader.fail("to_s", "is not later than from_s");
  fault.from += scenario.start_time;
  fault.to += scenario.start_time;
  if (fault.kind == FaultKind::kFalseAlarmBurst) readBurst(reader, fault);
  reader.done();
  return fault;
}

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

}  // namespace

Scenario loadScenario(const std::string& path, const ScenarioOverrides& overrides) {
  return loadScenario(path, overrides, sensorKinds());
}

Scenario loadScenario(const std::string& path, const ScenarioOverrides& overrides,
                      const std::vector<SensorKind>& kinds) {
  const YAML::Node tree = tws_runtime::loadParameterFile(path);
  ParameterReader reader(tree, path);
  Scenario scenario;
  readGeneral(reader, scenario);
  const ReadingContext context{tws::LocalFrame(scenario.origin), scenario.start_time, folderOf(path)};
  readSites(reader, context, scenario);
  readTargets(reader, context, scenario);
  readSensors(reader, kinds, scenario);
  readClutterFields(reader, context, scenario);
  for (ParameterReader& entry : reader.list("faults")) scenario.faults.push_back(readFault(entry, scenario));
  reader.map("trackers");  // throws when it is no map
  if (tree["trackers"] && tree["trackers"].IsMap()) scenario.trackers = tree["trackers"];
  reader.done();
  scenario.seed = overrides.seed.value_or(scenario.seed);
  scenario.duration = overrides.duration.value_or(scenario.duration);
  return scenario;
}

}  // namespace radar_sim
