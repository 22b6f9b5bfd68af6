#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/counters.h>

#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

namespace tws_runtime {

class LocalCore;

/// All nodes of a graph in one process, without a master: one queue, one thread, messages shared and never copied. The
/// same nodes, sources and parameters give the same messages in every run.
///
///   LocalGraph graph(std::cerr);
///   RadarSim simulator(graph.addNode("radar_sim", parameters));   // a Source
///   AditNode tracker(graph.addNode("adit", other_parameters));
///   graph.record("run.bag");
///   runOffline(graph, {&simulator});
///   printCounters(std::cout, graph.counters());
class LocalGraph {
 public:
  /// Log lines go to `log`, which must outlive the graph.
  explicit LocalGraph(std::ostream& log);
  LocalGraph(const LocalGraph&) = delete;
  LocalGraph& operator=(const LocalGraph&) = delete;
  ~LocalGraph();

  /// The Bus of one more node, which lives as long as the graph. `name` may stand in a namespace: "siteA/adit".
  /// `remaps` go from name to name, as the node would say them. Throws std::invalid_argument when the name is taken.
  Bus& addNode(const std::string& name, const YAML::Node& parameters = YAML::Node(),
               const std::map<std::string, std::string>& remaps = {});

  /// Writes what is published from now on into a bag: the `topics` given, or all. A message's record time is the data
  /// time at which it was published, as in a live run. Throws std::runtime_error when the file cannot be written.
  void record(const std::string& path, const std::vector<std::string>& topics = {});
  /// Closes the bag; the destructor does it too, but keeps errors to itself.
  void finishRecording();

  /// Delivers all that is queued, and what that causes. Not from within a handler.
  void drain();
  /// Moves data time on to `time` (never back): the data timers whose deadline lies before it are called one by one,
  /// each followed by drain().
  void advanceTo(ros::Time time);
  ros::Time now() const;

  /// Calls a service from outside of all nodes, then drains. Throws std::runtime_error when no node offers it with that
  /// type.
  template <class S>
  bool call(const std::string& service, typename S::Request& request, typename S::Response& response) {
    return call(service, typeid(S), &request, &response);
  }

  /// The counters of all nodes, in the order in which the nodes were added.
  std::vector<CounterReading> counters() const;

  /// For sources of messages whose type is known only at run time: the type that the nodes use on an (absolute) topic,
  /// null when no node has opened it; whether a node publishes it; a channel to publish on it under the name `node`.
  const MessageType* typeOf(const std::string& topic) const;
  bool isPublished(const std::string& topic) const;
  std::shared_ptr<Channel> openChannel(const std::string& node, const std::string& topic, bool latched,
                                       const MessageType& type);

 private:
  bool call(const std::string& service, const std::type_info& type, void* request, void* response);

  std::unique_ptr<LocalCore> core_;
};

}  // namespace tws_runtime
