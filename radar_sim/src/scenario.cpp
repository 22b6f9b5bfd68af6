#include "scenario.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

#include "trajectory.h"

namespace radar_sim {
namespace {

const Site& siteOf(const Scenario& scenario, const std::string& sensor, const std::string& name) {
  const auto isIt = [&](const Site& site) { return site.name == name; };
  const auto site = std::find_if(scenario.sites.begin(), scenario.sites.end(), isIt);
  if (site == scenario.sites.end()) throw std::invalid_argument("radar '" + sensor + "' has no site '" + name + "'");
  return *site;
}

tws::Geodetic antennaPlace(const Site& site, double height, const tws::LocalFrame& map) {
  const Eigen::Vector2d at_rest(0.0, 0.0);
  tws::Geodetic place = map.toGeodetic(overTheSea(site.position, at_rest, height, 0.0, map.origin().altitude).position);
  // The sea of overTheSea() is a sphere; on the ellipsoid the antenna stands exactly as high as it says.
  place.altitude = height;
  return place;
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

std::vector<Fault> faultsOf(const Scenario& scenario, const std::string& sensor) {
  std::vector<Fault> faults;
  const auto isItsOwn = [&](const Fault& fault) { return fault.radar == sensor; };
  std::copy_if(scenario.faults.begin(), scenario.faults.end(), std::back_inserter(faults), isItsOwn);
  return faults;
}

Eigen::Isometry3d mapToAntenna(const Scenario& scenario, const std::string& sensor, const std::string& site,
                               double height) {
  const tws::LocalFrame map(scenario.origin);
  const tws::LocalFrame antenna(antennaPlace(siteOf(scenario, sensor, site), height, map));
  Eigen::Isometry3d map_to_antenna = Eigen::Isometry3d::Identity();
  map_to_antenna.linear() = antenna.ecefFromEnuRotation().transpose() * map.ecefFromEnuRotation();
  map_to_antenna.translation() = antenna.toEnu(map.origin());
  return map_to_antenna;
}

}  // namespace radar_sim
