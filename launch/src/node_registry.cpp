#include "node_registry.h"

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

namespace tws_launch {

const NodeRegistry& nodeRegistry() {
  static const NodeRegistry kRegistry{
      sourceRow<radar_sim::RadarSimNode>("radar_sim/radar_sim_node"),
      sourceRow<asterix_bridge::AsterixFileNode>("asterix_bridge/asterix_file_node"),
      nodeRow<adit_tracker::AditNode>("adit_tracker/adit_node"),
      nodeRow<track_correlator::SsrTrackerNode>("track_correlator/ssr_tracker_node"),
      nodeRow<track_correlator::TrackCorrelatorNode>("track_correlator/track_correlator_node"),
      nodeRow<esa_frame_builder::FrameBuilderNode>("esa_frame_builder/frame_builder_node"),
      nodeRow<esa_frame_builder::MfaStubNode>("esa_frame_builder/mfa_stub_node"),
      nodeRow<range_gate_tracker::WindowTrackerNode>("range_gate_tracker/window_tracker_node"),
      nodeRow<range_gate_tracker::RangeGateTrackerNode>("range_gate_tracker/range_gate_tracker_node"),
      nodeRow<track_evaluation::EvaluationNode>("track_evaluation/evaluation_node"),
  };
  return kRegistry;
}

}  // namespace tws_launch
