#pragma once

#include <rosbag/bag.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/GraphDescription.h>
#include <tws_msgs/SectorMark.h>

#include <string>

#include <tws_core/temporary_folder_test_helpers.h>
#include "graph_resolver.h"
#include "run_input.h"

namespace tws_launch {

using tws::TemporaryFolder;

inline const GraphFile& graphFile() {
  static const GraphFile kFile = readGraphFile(TWS_LAUNCH_FOLDER "/graph.yaml");
  return kFile;
}

/// A message of some radar.
template <class M>
M of(const std::string& radar) {
  M message;
  message.radar = radar;
  return message;
}

/// A bag that is written message by message, one a second.
class BagUnderTest {
 public:
  explicit BagUnderTest(const std::string& path) : bag_(path, rosbag::bagmode::Write) {}
  template <class M>
  BagUnderTest& with(const std::string& topic, const M& message) {
    bag_.write(topic, ros::Time(time_), message);
    time_ += 1.0;
    return *this;
  }
  BagUnderTest& withRadar(const std::string& space, const std::string& radar) {
    with(space + radar + "/detections", of<tws_msgs::Detections>(radar));
    return with(space + radar + "/sector_marks", of<tws_msgs::SectorMark>(radar));
  }
  void close() { bag_.close(); }

 private:
  rosbag::Bag bag_;
  double time_ = 100.0;
};

inline RunOptions options(const std::vector<std::pair<std::string, std::string>>& said) {
  RunOptions options;
  for (const auto& [name, value] : said) options.set(name, value);
  return options;
}

/// The graph of an input.
inline GraphDescription graphOf(const std::string& path, const RunOptions& options = {}, bool live = false) {
  return resolveGraph(graphFile(), inspectInput(path, graphFile(), options), options, live);
}

inline std::vector<std::string> namesOf(const GraphDescription& graph) {
  std::vector<std::string> names;
  for (const NodeDescription& node : graph.nodes) names.push_back(node.name);
  return names;
}

template <class Call>
std::string reasonOf(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace tws_launch
