#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace track_correlator {

/// The secondary tracker on its topics: /<radar>/plots in, /ssr/tracks out.
class SsrTrackerNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit SsrTrackerNode(tws_runtime::Bus& bus);
  ~SsrTrackerNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace track_correlator
