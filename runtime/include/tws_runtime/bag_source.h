#pragma once

#include <tws_runtime/source.h>

#include <memory>
#include <string>
#include <vector>

namespace tws_runtime {

class LocalGraph;

/// The messages of a bag as a source of a LocalGraph, in order of the time at which they were recorded. (Messages
/// recorded at the very same time come as rosbag gives them; who needs another order puts them in it, see RadarInputs.)
///
/// Make the nodes first: a topic is read as the type that they use, other topics are passed on as bytes, so that a new
/// recording holds them too. Node name and latching of the recorded publisher are kept.
class BagSource : public Source {
 public:
  /// `topics` empty: all but those that a node of the graph publishes itself (/tf_static excepted), and never /clock,
  /// /rosout, /rosout_agg and /diagnostics, which are of the run that was recorded. Throws std::runtime_error, one
  /// line that names the file and the topic, when the file is no whole bag (openBag()), a topic is not in it, or
  /// its type has another md5 than the node's.
  BagSource(LocalGraph& graph, const std::string& path, const std::vector<std::string>& topics = {});
  ~BagSource() override;

  std::optional<ros::Time> nextTime() const override;
  /// Throws std::runtime_error, which names file, topic and time, when the message cannot be read.
  void step() override;
  std::optional<ros::Time> endTime() const override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_runtime
