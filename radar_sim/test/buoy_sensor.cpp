#include "buoy_sensor.h"

#include <tws_core/geometry.h>
#include <tws_runtime/conversions.h>

#include "radar_reader.h"
#include "scenario.h"
#include "sensor_port.h"

namespace radar_sim {

std::unique_ptr<SensorSpec> readBuoy(ParameterReader& reader, const Scenario& scenario) {
  std::string name;
  readRadarName(reader, name);
  auto buoy = std::make_unique<BuoySpec>(name);
  reader.text("site", buoy->site);
  reader.number("period_s", buoy->period, 0.1, 3600.0);
  reader.number("reach_m", buoy->reach, 10.0, kFarthest);
  reader.done();
  settleSite(buoy->site, scenario, reader);
  return buoy;
}

std::unique_ptr<Sensor> BuoySpec::make(const Scene& scene) const { return std::make_unique<BuoySensor>(*this, scene); }

BuoySensor::BuoySensor(const BuoySpec& spec, const Scene& scene)
    : Sensor(spec),
      spec_(spec),
      targets_(scene.targets),
      faults_(faultsOf(scene.scenario, spec.name)),
      start_time_(scene.scenario.start_time),
      map_to_site_(mapToAntenna(scene.scenario, spec.name, spec.site, 0.0)) {}

void BuoySensor::connect(SensorPort& port) {
  detections_ = port.advertise<tws_msgs::Detections>("detections");
  port.publishFrame(map_to_site_);
}

void BuoySensor::step() {
  const double time = nextTime();
  tws_msgs::Detections message;
  message.header.stamp = tws_runtime::toTime(time);
  message.header.frame_id = message.radar = name();
  message.running_sector = count_++;
  for (const Target& target : targets_) {
    if (!target.trajectory->existsAt(time)) continue;
    const tws::Polar place = tws::polarFromEnu(map_to_site_ * target.trajectory->at(time).position);
    if (place.range > spec_.reach) continue;
    tws_msgs::Detection detection;
    detection.stamp = message.header.stamp;
    detection.range = place.range;
    detection.azimuth = place.azimuth;
    message.detections.push_back(detection);
  }
  detections_.publish(message);
}

}  // namespace radar_sim
