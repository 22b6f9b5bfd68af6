#include "rotating_sensor.h"

#include <tws_runtime/conversions.h>

#include "radar_reader.h"
#include "scenario.h"
#include "sensor_port.h"

namespace radar_sim {

std::unique_ptr<SensorSpec> readRotatingSensor(ParameterReader& reader, const Scenario& scenario) {
  auto spec = std::make_unique<RotatingSpec>(readRadar(reader, scenario.start_time));
  settleSite(spec->params.site, scenario, reader);
  return spec;
}

std::unique_ptr<Sensor> RotatingSpec::make(const Scene& scene) const {
  return std::make_unique<RotatingSensor>(*this, scene);
}

RotatingSensor::RotatingSensor(const RotatingSpec& spec, const Scene& scene)
    : MastSensor(spec, scene), targets_(scene.targets), marks_(*this, scene) {
  for (const auto& clutter : scene.scenario.clutter_fields)
    if (clutter->isSeenBy(name())) radar().addClutter(clutter);
}

void RotatingSensor::connect(SensorPort& port) {
  detections_ = port.advertise<tws_msgs::Detections>("detections");
  marks_.connect(port);
  port.publishFrame(mapToSite());
  if (params().elevation_search) elevation_.emplace(port, radar());
}

void RotatingSensor::step() {
  if (elevation_) elevation_->applyCommands();
  const double now = radar().nextMark();
  const tws::RadarSector sector = radar().closeSector();
  detections_.publish(tws_runtime::toDetections(sector, name(), name()));
  if (on_sector_) on_sector_(sector);
  if (elevation_) elevation_->onMark(sector);
  marks_.publish(
      {sector.running, now, sector.leave_time, sector.plots.size(), radar().rotationPeriod(sector.running + 1)});
}

void RotatingSensor::stopWaiting() {
  if (elevation_) elevation_->stopWaiting();
}

std::optional<double> RotatingSensor::beamAt(double time) const {
  if (radar().isSilentAt(time)) return std::nullopt;
  return tws::wrapTwoPi(radar().antenna().measuredAngleAt(time));
}

Sighting RotatingSensor::sightingOf(std::size_t target, double time) const {
  const tws::Polar polar = radar().polarOf(targets_[target], time);
  return {polar.range, polar.azimuth, radar().detectionProbability(target, time)};
}

}  // namespace radar_sim
