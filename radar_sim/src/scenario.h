#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/geodesy.h>
#include <yaml-cpp/yaml.h>

#include "fault.h"
#include "random_group.h"
#include "sensor.h"
#include "target.h"

namespace radar_sim {

struct ClutterSpec;
struct SensorKind;

struct Site {
  std::string name;
  Eigen::Vector2d position{0.0, 0.0};  ///< East, north in the map frame [m].
};

/// All that a run is made of. The map frame is east, north, up at the origin.
struct Scenario {
  std::uint64_t seed = 1;
  double start_time = 1000.0;  ///< Data time of the beginning [s]; 0 would mean "unset" in ROS.
  double duration = 300.0;     ///< [s]
  double truth_period = 1.0;   ///< [s]
  tws::Geodetic origin;        ///< Altitude above the sea [m].
  std::vector<Site> sites;
  std::vector<std::shared_ptr<const SensorSpec>> sensors;  ///< What happens at one time happens in their order.
  std::vector<Target> targets;                             ///< Those that are given one by one.
  std::vector<RandomGroup> groups;
  std::vector<Fault> faults;
  std::vector<std::shared_ptr<const ClutterSpec>> clutter_fields;  ///< Clutter that has a place and a history.
  /// A map, tracker name → its parameters, as it stands in the file: whoever starts the trackers reads it.
  YAML::Node trackers{YAML::NodeType::Map};

  double endTime() const { return start_time + duration; }
};

/// What a user may set without touching the file.
struct ScenarioOverrides {
  std::optional<std::uint64_t> seed;
  std::optional<double> duration;  ///< [s]
};

/// Throws tws_runtime::ParameterError, with file, line and reason, for what cannot be read, is unknown, out of range or
/// contradicts itself. Files that the scenario names are looked for from its own folder.
Scenario loadScenario(const std::string& path, const ScenarioOverrides& overrides = {});
/// The same with other kinds of sensors than sensorKinds().
Scenario loadScenario(const std::string& path, const ScenarioOverrides& overrides,
                      const std::vector<SensorKind>& kinds);

/// The given targets, then those of the random groups; what is to be drawn of their transponders is drawn. Throws
/// std::invalid_argument when a name is used twice.
std::vector<Target> allTargets(const Scenario& scenario);

/// Those of one sensor.
std::vector<Fault> faultsOf(const Scenario& scenario, const std::string& sensor);

/// Takes map coordinates to the east, north, up of a sensor's antenna, `height` above the sea [m]. Throws
/// std::invalid_argument when there is no such site.
Eigen::Isometry3d mapToAntenna(const Scenario& scenario, const std::string& sensor, const std::string& site,
                               double height);

}  // namespace radar_sim
