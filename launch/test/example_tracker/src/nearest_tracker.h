#pragma once

#include <tws_core/kalman.h>

#include <cstdint>
#include <vector>

namespace nearest_tracker {

struct NearestParams {
  double gate_sigmas = 4.0;  // in standard deviations of the innovation
  int confirm_plots = 3;
  double drop = 20.0;  // without a plot [s]
};

/// A plot on the plane.
struct PlanarPlot {
  double time;  // [s]
  tws::PlanarMeasurement place;
};

struct NearestTrack {
  std::uint32_t number;
  double first_time, last_time;  // of its plots [s]
  double time;                   // of the state [s]
  tws::PlanarState state;
  int plots = 1;
  bool deleted = false;
};

/// Each plot goes to the nearest track, or starts one.
class NearestTracker {
 public:
  explicit NearestTracker(const NearestParams& params) : params_(params) {}

  /// The plots of one sector, which the beam left at this time [s]. Returns the tracks that were updated or deleted.
  std::vector<NearestTrack> process(const std::vector<PlanarPlot>& plots, double leave_time);

  bool isConfirmed(const NearestTrack& track) const { return track.plots >= params_.confirm_plots; }

 private:
  NearestTrack& update(const PlanarPlot& plot);
  NearestTrack* nearest(const PlanarPlot& plot);

  NearestParams params_;
  std::uint32_t next_number_ = 1;
  std::vector<NearestTrack> tracks_;
};

}  // namespace nearest_tracker
