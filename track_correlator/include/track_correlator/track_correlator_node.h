#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace track_correlator {

/// The correlator on its topics: primary tracks, secondary tracks and the sector marks of one radar in,
/// /correlated/tracks out.
class TrackCorrelatorNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit TrackCorrelatorNode(tws_runtime::Bus& bus);
  ~TrackCorrelatorNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace track_correlator
