#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace esa_frame_builder {

/// One measurement of an electronically scanned array. Sine space as in tws_core/sine_space.h.
struct Measurement {
  double range = 0.0;                                     // r [m], > 0
  double u = 0.0, v = 0.0;                                // U, V
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();   // of (range, u, v); its (u, v) block is R
  double snr = 0.0;                                       // linear power ratio
  double rcs = std::numeric_limits<double>::quiet_NaN();  // [m²]; NaN: unknown
};

/// One dwell: a beam and what it saw, which may be nothing.
struct Dwell {
  double time = 0.0;  // t_k, its centre [s]
  std::uint32_t number = 0;
  bool is_track_dwell = false;
  std::vector<std::uint32_t> group_indices;  // ι: numbers of the tracks expected in it, ascending
  std::uint32_t group = 0;                   // the sequence of overlapping beams that it is part of; 0: none
  std::uint32_t expected_group_dwells = 0;
  double u = 0.0, v = 0.0;                      // beam point Ū, V̄
  double beamwidth_u = 0.0, beamwidth_v = 0.0;  // Θ_U, Θ_V, full width at half power, > 0
  double range_min = 0.0, range_max = 0.0;      // receive window [m]
  std::vector<Measurement> measurements;
};

/// A frame: each target is in it at most once, and its dwells are its field of view over time.
struct Frame {
  std::uint32_t number = 0;
  bool closed = false;        // false: partial, an early look at a frame that is still open
  std::vector<Dwell> dwells;  // in order of time; their measurements are those that selection kept
  std::size_t discarded = 0;  // measurements that selection left out
};

}  // namespace esa_frame_builder
