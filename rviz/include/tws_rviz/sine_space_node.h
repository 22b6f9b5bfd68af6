#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace tws_rviz {

/// Draws the dwells, frames and tracks of an electronically scanned array in its sine space with RViz markers. It draws
/// on wall time, so offline it only publishes the fixed picture.
class SineSpaceNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit SineSpaceNode(tws_runtime::Bus& bus);
  ~SineSpaceNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_rviz
