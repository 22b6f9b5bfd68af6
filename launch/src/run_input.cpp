#include "run_input.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tws_msgs/Detections.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tws_launch {
namespace {

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// "sps12" of "/sps12/detections".
std::string firstPart(const std::string& topic) { return topic.substr(1, topic.find('/', 1) - 1); }

void readScenario(RunInput& input) {
  const YAML::Node scenario = YAML::LoadFile(input.path);
  for (const YAML::Node& radar : scenario["radars"]) input.radars.push_back(radar["name"].as<std::string>());
  // As of a bag, whose topics have no order: the trackers' numbering of radars must be the same for both.
  std::sort(input.radars.begin(), input.radars.end());
  input.length = scenario["duration_s"].as<double>(0.0);
}

void readBag(RunInput& input) {
  const rosbag::Bag bag(input.path);
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::Detections>()));
  std::set<std::string> names;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) names.insert(firstPart(connection->topic));
  input.radars.assign(names.begin(), names.end());
  if (view.size() > 0) input.length = (view.getEndTime() - view.getBeginTime()).toSec();
}

}  // namespace

RunInput inspectInput(const std::string& path) {
  RunInput input;
  input.path = path;
  input.is_bag = endsWith(path, ".bag");
  try {
    input.is_bag ? readBag(input) : readScenario(input);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (input.radars.empty()) throw std::runtime_error(path + ": no rotating radar in it");
  return input;
}

}  // namespace tws_launch
