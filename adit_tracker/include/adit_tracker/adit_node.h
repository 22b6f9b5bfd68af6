#pragma once

#include <memory>

#include <tws_runtime/bus.h>

namespace adit_tracker {

/// The ADIT tracker on its topics: /<radar>/detections and /<radar>/sector_marks in, /adit/tracks and /adit/clutter_map
/// out.
class AditNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit AditNode(tws_runtime::Bus& bus);
  ~AditNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adit_tracker
