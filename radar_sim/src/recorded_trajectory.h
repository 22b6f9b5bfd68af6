#pragma once

#include <vector>

#include <tws_core/geodesy.h>

#include "recording.h"
#include "trajectory.h"

namespace radar_sim {

struct RecordingWindow {
  double from = 0.0;       ///< Recording time that falls on `at` [s].
  double to = 1e12;        ///< The rest of the recording is left out [s].
  double at = 0.0;         ///< [s of data time]
  double smoothing = 5.0;  ///< Half width of the fit [s], > 0.
  double max_gap = 30.0;   ///< Over longer silences the target does not exist [s].
};

/// A recorded aircraft. Receivers stamp fixes late by up to a second, which makes a jumpy track: each knot (one a
/// `smoothing`) is a least-squares line through the fixes around it, and cubic Hermite pieces join the knots with their
/// velocities. A fix that repeats the position before is taken for stale and left out.
class RecordedTrajectory : public Trajectory {
 public:
  /// Throws std::invalid_argument when the window holds fewer than two fixes that are not more than `max_gap` apart.
  RecordedTrajectory(const std::vector<RecordedFix>& fixes, const RecordingWindow& window, const tws::LocalFrame& map);

  TargetState at(double time) const override;

 private:
  /// Value and slope of position and height at a time; cubic Hermite pieces join them.
  struct Knot {
    double time;
    Eigen::Vector4d value;
    Eigen::Vector4d slope;
  };
  struct Sample;
  using SampleRange = std::pair<std::vector<Sample>::const_iterator, std::vector<Sample>::const_iterator>;

  RecordedTrajectory(const std::vector<Sample>& samples, const RecordingWindow& window);
  static std::vector<Sample> samplesOf(const std::vector<RecordedFix>& fixes, const RecordingWindow& window,
                                       const tws::LocalFrame& map);
  static std::vector<SampleRange> stretchesOf(const std::vector<Sample>& samples, double max_gap);
  static Knot fitKnot(const SampleRange& stretch, double time, double half_width);
  static std::vector<TimeSpan> spansOf(const std::vector<SampleRange>& stretches);

  std::vector<Knot> knots_;
};

}  // namespace radar_sim
