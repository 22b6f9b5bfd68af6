#pragma once

#include <utility>
#include <vector>

#include "epoch.h"
#include "metric_list.h"

namespace track_evaluation {

inline PlanarState still(double x, double y) { return {{x, y}, {0.0, 0.0}}; }

inline TruthState truthAt(std::uint32_t id, double x, double y) {
  TruthState truth;
  truth.id = id;
  truth.ground = truth.slant = still(x, y);
  return truth;
}

inline TrackState trackAt(std::uint32_t id, double x, double y) {
  TrackState track;
  track.id = id;
  track.state = still(x, y);
  return track;
}

inline double valueOf(const MetricList& metrics, const std::string& name) {
  for (const auto& [known, value] : metrics)
    if (known == name) return value;
  throw std::out_of_range("no metric " + name);
}

}  // namespace track_evaluation
