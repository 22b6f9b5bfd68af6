#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace tws_rviz {

/// Draws a PPI (plan position indicator) with RViz markers from detections, sector marks, tracks, clutter map and
/// truth. It draws on wall time, so offline it only publishes the fixed picture.
class PpiNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit PpiNode(tws_runtime::Bus& bus);
  ~PpiNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_rviz
