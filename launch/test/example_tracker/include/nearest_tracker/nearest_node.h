#pragma once

#include <tws_runtime/bus.h>

#include <memory>

namespace nearest_tracker {

/// Tracks of all its rotating radars on ~tracks. Parameters: config/nearest.yaml.
class NearestNode {
 public:
  explicit NearestNode(tws_runtime::Bus& bus);
  ~NearestNode();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nearest_tracker
