#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace range_gate_tracker {

/// Track-while-scan windows on one rotating radar: /<radar>/detections and /<radar>/sector_marks in, the operator's
/// /clicked_point and service /tws/drop_track; out /tws/tracks, /tws/windows and /window_tracker/operator_requests.
class WindowTrackerNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit WindowTrackerNode(tws_runtime::Bus& bus);
  ~WindowTrackerNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace range_gate_tracker
