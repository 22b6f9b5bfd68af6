#include "offline_graph.h"

#include <adit_tracker/adit_node.h>
#include <asterix_bridge/asterix_node.h>
#include <esa_frame_builder/frame_builder_node.h>
#include <esa_frame_builder/mfa_stub_node.h>
#include <radar_sim/radar_sim_node.h>
#include <range_gate_tracker/range_gate_tracker_node.h>
#include <range_gate_tracker/window_tracker_node.h>
#include <track_correlator/ssr_tracker_node.h>
#include <track_correlator/track_correlator_node.h>
#include <track_evaluation/evaluation_node.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tws_launch {
namespace {

const std::set<std::string> kLiveOnly{"rosbag/play", "rosbag/record", "rviz/rviz", "tws_rviz/ppi_node",
                                      "tws_rviz/sine_space_node"};

}  // namespace

OfflineGraph::OfflineGraph(const std::vector<NodeDescription>& nodes, std::ostream& log) : log_(log), graph_(log) {
  for (const NodeDescription& node : nodes) add(node);
}

void OfflineGraph::add(const NodeDescription& node) {
  const std::string program = node.package + "/" + node.type;
  if (kLiveOnly.count(program) > 0) return;
  tws_runtime::Bus& bus = graph_.addNode(node.name, node.parameters, node.remaps);
  if (program == "radar_sim/radar_sim_node")
    sources_.push_back(std::make_unique<radar_sim::RadarSimNode>(bus));
  else if (program == "asterix_bridge/asterix_file_node")
    sources_.push_back(std::make_unique<asterix_bridge::AsterixFileNode>(bus));
  else if (program == "adit_tracker/adit_node")
    nodes_.push_back(std::make_shared<adit_tracker::AditNode>(bus));
  else if (program == "track_correlator/ssr_tracker_node")
    nodes_.push_back(std::make_shared<track_correlator::SsrTrackerNode>(bus));
  else if (program == "track_correlator/track_correlator_node")
    nodes_.push_back(std::make_shared<track_correlator::TrackCorrelatorNode>(bus));
  else if (program == "esa_frame_builder/frame_builder_node")
    nodes_.push_back(std::make_shared<esa_frame_builder::FrameBuilderNode>(bus));
  else if (program == "esa_frame_builder/mfa_stub_node")
    nodes_.push_back(std::make_shared<esa_frame_builder::MfaStubNode>(bus));
  else if (program == "range_gate_tracker/window_tracker_node")
    nodes_.push_back(std::make_shared<range_gate_tracker::WindowTrackerNode>(bus));
  else if (program == "range_gate_tracker/range_gate_tracker_node")
    nodes_.push_back(std::make_shared<range_gate_tracker::RangeGateTrackerNode>(bus));
  else if (program == "track_evaluation/evaluation_node")
    nodes_.push_back(std::make_shared<track_evaluation::EvaluationNode>(bus));
  else if (program == "tws_launch/progress_node")
    progress_ = std::make_unique<ProgressNode>(bus, log_);
  else
    throw std::runtime_error("node /" + node.name + ": the offline runner does not know " + program);
}

std::vector<tws_runtime::Source*> OfflineGraph::sources() const {
  std::vector<tws_runtime::Source*> sources;
  std::transform(sources_.begin(), sources_.end(), std::back_inserter(sources), [](const auto& s) { return s.get(); });
  return sources;
}

ProgressNode& OfflineGraph::progress() {
  if (!progress_) throw std::runtime_error("the launch file has no progress node");
  return *progress_;
}

}  // namespace tws_launch
