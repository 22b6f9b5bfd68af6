#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <radar_sim/sensor_topics.h>
#include <ros/message_traits.h>
#include <tws_runtime/bus.h>

namespace radar_sim {

class Sensor;

/// The Bus as one sensor has it: it opens its topics here, and what it opens is listed. Lives while the sensor
/// connects; the Bus lives longer.
class SensorPort {
 public:
  SensorPort(tws_runtime::Bus& bus, const Sensor& sensor);

  /// A topic of the sensor's own: "detections" is <sensor>/detections.
  template <class M>
  tws_runtime::Publisher<M> advertise(const std::string& leaf) {
    return advertiseAs<M>(nameOf(leaf));
  }
  /// A topic that many sensors could have, but one has.
  template <class M>
  tws_runtime::Publisher<M> advertiseAs(const std::string& topic) {
    topics_.published.push_back({topic, typeName<M>()});
    return bus_.advertise<M>(topic);
  }
  /// A command of the sensor's own. Returns the topic's name, for log lines.
  template <class M>
  std::string subscribe(const std::string& leaf, std::function<void(const M&)> handler) {
    topics_.subscribed.push_back({nameOf(leaf), typeName<M>()});
    bus_.subscribe<M>(nameOf(leaf), std::move(handler));
    return nameOf(leaf);
  }
  /// Publishes where the sensor's frame lies in the map; the frame has the sensor's name.
  void publishFrame(const Eigen::Isometry3d& map_to_sensor);

  tws_runtime::Bus& bus() { return bus_; }
  const SensorTopics& topics() const { return topics_; }

 private:
  template <class M>
  static std::string typeName() {
    return ros::message_traits::datatype<M>();
  }
  std::string nameOf(const std::string& leaf) const { return topics_.name + "/" + leaf; }

  tws_runtime::Bus& bus_;
  SensorTopics topics_;
};

/// Connects each of them, in their order.
std::vector<SensorTopics> connect(const std::vector<std::unique_ptr<Sensor>>& sensors, tws_runtime::Bus& bus);

}  // namespace radar_sim
