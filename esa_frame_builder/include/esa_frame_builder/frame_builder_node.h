#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace esa_frame_builder {

/// The frame builder on its topics: /<radar>/dwell_reports in, /<radar>/frames out.
class FrameBuilderNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit FrameBuilderNode(tws_runtime::Bus& bus);
  ~FrameBuilderNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace esa_frame_builder
