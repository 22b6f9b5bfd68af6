#pragma once

#include <cstdint>
#include <vector>

#include <tws_core/plot.h>

#include "window_motion.h"
#include "window_params.h"

namespace range_gate_tracker {

/// The volume in which a track's next detection is looked for: a piece of a ring (Henery 1985, figure 2.4).
struct TrackWindow {
  bool tracking = false;      ///< false: an acquisition window
  double time = 0.0;          ///< The beam is expected on its middle [s].
  double range = 0.0;         ///< Of its middle [m].
  double azimuth = 0.0;       ///< The same [rad], [0, 2π).
  double half_range = 0.0;    ///< [m]
  double half_azimuth = 0.0;  ///< [rad]
  std::int64_t open = 0;      ///< Running numbers of the first and
  std::int64_t close = -1;    ///< the last sector that can hold a detection in it.

  bool isOpenIn(std::int64_t running) const { return running >= open && running <= close; }
  bool contains(const tws::Plot& plot) const;
  /// The detection's distance from the middle, in half windows.
  double distance(const tws::Plot& plot) const;
};

/// Half sizes of a window.
struct WindowSize {
  double range;    ///< [m]
  double azimuth;  ///< [rad]
};

/// What errors do to the size of a track's window: mean squared differences of measured and predicted place.
struct PredictionError {
  double range = 0.0;   ///< [m²]
  double across = 0.0;  ///< Across the line of sight [m²].
};

/// Holds a target that manoeuvres at its greatest speed and acceleration for dt [s] (section 2.4.2), as a detection
/// with these errors shows it.
WindowSize acquisitionSize(double range, double dt, const PlotSigmas& sigmas, const WindowParams& params);

/// Of a track with that prediction error whose last `misses` scans brought nothing; no larger than the acquisition
/// window.
WindowSize trackingSize(double range, double dt, const PlotSigmas& sigmas, const PredictionError& error, int misses,
                        const WindowParams& params);

/// What to expect of the first prediction of a track after two detections: six times the variance of one, and a
/// manoeuvre of the usual size in between.
PredictionError firstError(double range, double dt, const PlotSigmas& sigmas, const WindowParams& params);

/// The mean after one more prediction, which was wrong by the difference of the two places.
void learnError(PredictionError& error, const tws::Plot& measured, const WindowKinematics& predicted, double weight);

/// The one detection that the plots in a window stand for (section 2.5.1). There must be at least one.
tws::Plot resolved(const std::vector<tws::Plot>& plots, const TrackWindow& window, Ambiguity rule);

}  // namespace range_gate_tracker
