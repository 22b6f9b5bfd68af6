#pragma once

#include <string>
#include <vector>

namespace radar_sim {

/// One topic, as the simulator gives its name to the Bus.
struct SensorTopic {
  std::string name;  ///< "sps12/detections"
  std::string type;  ///< "tws_msgs/Detections"
};

/// The topics of one sensor of a scenario.
struct SensorTopics {
  std::string kind;  ///< The scenario's key under which it stands; "truth".
  std::string name;  ///< The sensor's, also of its tf frame.
  std::vector<SensorTopic> published;
  std::vector<SensorTopic> subscribed;  ///< Commands that close a loop (tws_runtime/lock_step.h).
};

}  // namespace radar_sim
