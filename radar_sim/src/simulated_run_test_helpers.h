#pragma once

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <tws_msgs/Detections.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/local_graph.h>

#include "sensor_port.h"
#include "simulation.h"

namespace radar_sim {

/// A simulation on a bus of its own, and what it published so far.
class SimulatedRun {
 public:
  explicit SimulatedRun(const Scenario& scenario) : simulation(scenario), graph_(std::cerr) {
    tws_runtime::Bus& ear = graph_.addNode("ear");
    for (const SensorTopics& sensor : connect(simulation.sensors(), graph_.addNode("radar_sim"))) {
      for (const SensorTopic& topic : sensor.published) {
        hear(ear, sensor.name, topic, detections);
        hear(ear, sensor.name, topic, marks);
        hear(ear, sensor.name, topic, plots);
        hear(ear, sensor.name, topic, profiles);
        hear(ear, sensor.name, topic, truths_);
      }
    }
  }

  void step() {
    times.push_back(*simulation.nextTime());
    simulation.step();
    graph_.drain();
  }
  void toEnd() {
    while (simulation.nextTime()) step();
  }
  const std::vector<tws_msgs::Truth>& truths() { return truths_["truth"]; }

  Simulation simulation;
  std::vector<double> times;                                            // of the steps
  std::vector<std::string> topics;                                      // of the messages
  std::map<std::string, std::vector<tws_msgs::Detections>> detections;  // by the sensor's name
  std::map<std::string, std::vector<tws_msgs::SectorMark>> marks;
  std::map<std::string, std::vector<tws_msgs::SsrPlots>> plots;
  std::map<std::string, std::vector<tws_msgs::RangeProfile>> profiles;

 private:
  template <class M>
  void hear(tws_runtime::Bus& ear, const std::string& sensor, const SensorTopic& topic,
            std::map<std::string, std::vector<M>>& messages) {
    if (topic.type != ros::message_traits::datatype<M>()) return;
    ear.subscribe<M>(topic.name, [this, name = topic.name, &heard = messages[sensor]](const M& message) {
      topics.push_back(name);
      heard.push_back(message);
    });
  }

  tws_runtime::LocalGraph graph_;
  std::map<std::string, std::vector<tws_msgs::Truth>> truths_;
};

}  // namespace radar_sim
