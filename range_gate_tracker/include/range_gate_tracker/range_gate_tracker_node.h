#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace range_gate_tracker {

/// The range-gate tracker on its topics: /<radar>/range_profile in; /<radar>/range_gate, which moves the gate, and
/// /<radar>/tracks out.
class RangeGateTrackerNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit RangeGateTrackerNode(tws_runtime::Bus& bus);
  ~RangeGateTrackerNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace range_gate_tracker
