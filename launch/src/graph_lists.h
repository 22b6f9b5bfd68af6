#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "graph_description.h"
#include "run_input.h"

namespace tws_launch {

/// What follows from a graph whose nodes are all known: who waits for whom, what is played, recorded and scored.
class GraphLists {
 public:
  /// `sensor_topics`: what the input's sensors say, whoever says it.
  GraphLists(const GraphDescription& graph, const RunInput& input, std::map<std::string, std::string> sensor_topics)
      : graph_(graph), input_(input), sensor_topics_(std::move(sensor_topics)) {}

  /// Topics of a type ("tws_msgs/Tracks", or "Tracks" of whatever package) that are said in this graph.
  std::vector<std::string> topicsOfType(const std::string& type) const;
  /// NAME of each topic NAME/tracks of that type.
  std::vector<std::string> namesOfType(const std::string& type) const;
  /// Each topic that is said here as often as there are nodes that hear it: what is said before they are connected is
  /// lost to them. Without the topics of one role's nodes ("": of no role).
  std::vector<std::string> waitedFor(const std::string& but_of = "") const;
  /// A player waits until all that it plays is heard: so it plays nothing that nobody hears. As the bag has the names.
  std::vector<std::string> played() const;
  /// Outputs first, so that nothing of them is missed.
  std::vector<std::string> recorded() const;
  /// What operators asked of the trackers, as the bag has it.
  std::vector<std::string> requests() const;
  /// From each of these to where its tracker takes them in a replay.
  std::map<std::string, std::string> requestRemaps() const;

 private:
  bool isSaidHere(const std::string& topic) const;
  std::string requestsTo(const NodeDescription& node) const;
  std::string whereItIs(const std::string& topic) const;

  const GraphDescription& graph_;
  const RunInput& input_;
  const std::map<std::string, std::string> sensor_topics_;
};

}  // namespace tws_launch
