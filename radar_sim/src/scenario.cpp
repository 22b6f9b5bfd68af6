#include "scenario.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <tws_core/sine_space.h>

#include "trajectory.h"

namespace radar_sim {
namespace {

template <class Radar>
tws::Geodetic antennaPlace(const Scenario& scenario, const Radar& radar, const tws::LocalFrame& map) {
  const auto hasItsName = [&](const Site& site) { return site.name == radar.site; };
  const auto site = std::find_if(scenario.sites.begin(), scenario.sites.end(), hasItsName);
  if (site == scenario.sites.end())
    throw std::invalid_argument("radar '" + radar.name + "' has no site '" + radar.site + "'");
  const Eigen::Vector2d at_rest(0.0, 0.0);
  tws::Geodetic place =
      map.toGeodetic(overTheSea(site->position, at_rest, radar.antenna_height, 0.0, scenario.origin.altitude).position);
  // The sea of overTheSea() is a sphere; on the ellipsoid the antenna stands exactly as high as it says.
  place.altitude = radar.antenna_height;
  return place;
}

template <class Radar>
Eigen::Isometry3d mapToAntenna(const Scenario& scenario, const Radar& radar) {
  const tws::LocalFrame map(scenario.origin);
  const tws::LocalFrame site(antennaPlace(scenario, radar, map));
  Eigen::Isometry3d map_to_radar = Eigen::Isometry3d::Identity();
  map_to_radar.linear() = site.ecefFromEnuRotation().transpose() * map.ecefFromEnuRotation();
  map_to_radar.translation() = site.toEnu(map.origin());
  return map_to_radar;
}

}  // namespace

std::vector<Target> allTargets(const Scenario& scenario) {
  std::vector<Target> targets = scenario.targets;
  for (Target& target : targets) target.transponder = drawCodes(target.transponder, scenario.seed, target.name);
  for (const RandomGroup& group : scenario.groups) {
    for (Target& target :
         drawGroup(group, scenario.seed, scenario.origin.altitude, scenario.start_time, scenario.endTime())) {
      targets.push_back(std::move(target));
    }
  }
  std::set<std::string> names;
  for (const Target& target : targets) {
    if (!names.insert(target.name).second)
      throw std::invalid_argument("target name '" + target.name + "' is used twice");
  }
  return targets;
}

Eigen::Isometry3d mapToRadar(const Scenario& scenario, const RadarParams& radar) {
  return mapToAntenna(scenario, radar);
}

Eigen::Isometry3d mapToRadar(const Scenario& scenario, const SecondaryParams& radar) {
  return mapToAntenna(scenario, radar);
}

Eigen::Isometry3d mapToRadar(const Scenario& scenario, const RangeRadarParams& radar) {
  return mapToAntenna(scenario, radar);
}

Eigen::Isometry3d mapToRadar(const Scenario& scenario, const ArrayParams& radar) {
  return tws::enuFromArrayRotation(radar.azimuth, radar.tilt).transpose() * mapToAntenna(scenario, radar);
}

}  // namespace radar_sim
