#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "antenna.h"
#include "clutter/clutter.h"

namespace radar_sim {

/// All clutter that one radar sees, raised as its beam goes on.
class SpokeFeed {
 public:
  /// `beamwidth` [rad]. `start_time` [s of data time].
  SpokeFeed(const Antenna& antenna, double beamwidth, double start_time);

  void add(std::shared_ptr<const ClutterSpec> spec, std::unique_ptr<Clutter> clutter);
  /// Appends the echoes of all spokes that begin before `until`.
  void raise(double until, std::vector<Echo>& echoes);
  bool isEmpty() const { return clutter_.empty(); }

 private:
  struct Entry {
    std::shared_ptr<const ClutterSpec> spec;
    std::unique_ptr<Clutter> clutter;
  };
  Spoke spokeOf(std::int64_t running) const;

  Antenna antenna_;
  double start_time_;
  std::int64_t per_scan_, next_;
  std::vector<Entry> clutter_;
};

}  // namespace radar_sim
