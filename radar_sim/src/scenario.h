#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/geodesy.h>
#include <yaml-cpp/yaml.h>

#include "array_params.h"
#include "fault.h"
#include "radar_params.h"
#include "random_group.h"
#include "range_radar_params.h"
#include "secondary_params.h"
#include "target.h"
#include "track_feed.h"

namespace radar_sim {

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
  std::vector<RadarParams> radars;
  std::vector<SecondaryParams> secondary_radars;
  std::vector<ArrayParams> array_radars;
  std::vector<RangeRadarParams> range_radars;
  std::vector<Target> targets;  ///< Those that are given one by one.
  std::vector<RandomGroup> groups;
  std::vector<Fault> faults;
  std::optional<TrackFeedParams> track_feed;  ///< Without it nobody but trackers tells tracks.
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

/// The given targets, then those of the random groups; what is to be drawn of their transponders is drawn. Throws
/// std::invalid_argument when a name is used twice.
std::vector<Target> allTargets(const Scenario& scenario);

/// Takes map coordinates to the radar's own east, north, up at its antenna.
Eigen::Isometry3d mapToRadar(const Scenario& scenario, const RadarParams& radar);
Eigen::Isometry3d mapToRadar(const Scenario& scenario, const SecondaryParams& radar);
Eigen::Isometry3d mapToRadar(const Scenario& scenario, const RangeRadarParams& radar);
/// To the array's frame: x along boresight, y left, z up.
Eigen::Isometry3d mapToRadar(const Scenario& scenario, const ArrayParams& radar);

}  // namespace radar_sim
