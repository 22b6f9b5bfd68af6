#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace esa_frame_builder {

/// The small frame tracker on its topics: /<radar>/frames in, /<radar>/tracks and /<radar>/track_database out.
class MfaStubNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit MfaStubNode(tws_runtime::Bus& bus);
  ~MfaStubNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace esa_frame_builder
