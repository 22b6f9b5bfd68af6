#include "sensor_port.h"

#include "conversions.h"
#include "sensor.h"

namespace radar_sim {

SensorPort::SensorPort(tws_runtime::Bus& bus, const Sensor& sensor) : bus_(bus) {
  topics_.kind = sensor.kind();
  topics_.name = sensor.name();
}

void SensorPort::publishFrame(const Eigen::Isometry3d& map_to_sensor) {
  bus_.publishStaticTransform(toTransform(map_to_sensor, topics_.name));
}

std::vector<SensorTopics> connect(const std::vector<std::unique_ptr<Sensor>>& sensors, tws_runtime::Bus& bus) {
  std::vector<SensorTopics> topics;
  for (const std::unique_ptr<Sensor>& sensor : sensors) {
    SensorPort port(bus, *sensor);
    sensor->connect(port);
    topics.push_back(port.topics());
  }
  return topics;
}

}  // namespace radar_sim
