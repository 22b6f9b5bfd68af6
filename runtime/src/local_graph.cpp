#include <tws_runtime/local_graph.h>

#include <ostream>
#include <stdexcept>

#include "local_bus.h"
#include "local_core.h"

namespace tws_runtime {

LocalGraph::LocalGraph(std::ostream& log) : core_(std::make_unique<LocalCore>(log)) {}

LocalGraph::~LocalGraph() {
  try {
    finishRecording();
  } catch (const std::exception& error) {
    core_->log() << error.what() << std::endl;
  }
}

Bus& LocalGraph::addNode(const std::string& name, const YAML::Node& parameters,
                         const std::map<std::string, std::string>& remaps) {
  for (const auto& node : core_->nodes())
    if (node->name() == name) throw std::invalid_argument("two nodes are named " + name);
  return *core_->nodes().emplace_back(std::make_unique<LocalBus>(*core_, name, parameters, remaps));
}

void LocalGraph::record(const std::string& path, const std::vector<std::string>& topics) {
  core_->recorder() = std::make_unique<BagRecorder>(path, topics);
}

void LocalGraph::finishRecording() {
  if (!core_->recorder()) return;
  const auto recorder = std::move(core_->recorder());
  recorder->close();
}

void LocalGraph::drain() { core_->drain(); }
void LocalGraph::advanceTo(ros::Time time) { core_->advanceTo(time); }
ros::Time LocalGraph::now() const { return core_->now(); }

std::vector<CounterReading> LocalGraph::counters() const {
  std::vector<CounterReading> all;
  for (const auto& node : core_->nodes()) {
    const auto readings = node->counters().readings();
    all.insert(all.end(), readings.begin(), readings.end());
  }
  return all;
}

const MessageType* LocalGraph::typeOf(const std::string& topic) const { return core_->typeOf(topic); }
bool LocalGraph::isPublished(const std::string& topic) const { return core_->isPublished(topic); }

std::shared_ptr<Channel> LocalGraph::openChannel(const std::string& node, const std::string& topic, bool latched,
                                                 const MessageType& type) {
  return core_->openChannel(node, topic, latched, type);
}

bool LocalGraph::call(const std::string& service, const std::type_info& type, void* request, void* response) {
  return core_->call(service, type, request, response);
}

}  // namespace tws_runtime
