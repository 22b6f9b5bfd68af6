#pragma once

#include <Eigen/Geometry>

#include "mast.h"
#include "scenario.h"
#include "sensor.h"

namespace radar_sim {

/// A sensor whose antenna stands on a mast of a site: its `Radar` is made of the parameters in its spec, the antenna's
/// place, and what the scenario says of targets, faults and random numbers.
template <class Radar>
class MastSensor : public Sensor {
 public:
  bool isSilentAt(double time) const override { return radar_.isSilentAt(time); }
  const Eigen::Isometry3d& mapToSite() const { return map_to_site_; }

 protected:
  template <class Spec>
  MastSensor(const Spec& spec, const Scene& scene)
      : Sensor(spec),
        map_to_site_(mapToAntenna(scene.scenario, spec.name, spec.params.site, spec.params.antenna_height)),
        radar_(spec.params, map_to_site_, scene.targets, faultsOf(scene.scenario, spec.name), scene.scenario.seed,
               scene.scenario.start_time) {}

  Radar& radar() { return radar_; }
  const Radar& radar() const { return radar_; }

 private:
  Eigen::Isometry3d map_to_site_;
  Radar radar_;
};

}  // namespace radar_sim
