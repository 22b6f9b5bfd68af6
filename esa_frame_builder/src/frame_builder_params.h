#pragma once

#include <cstddef>

namespace esa_frame_builder {

/// Section 3's algorithms.
enum class Algorithm {
  kDwellIsFrame = 1,   ///< 3.1
  kWithinPeriod = 2,   ///< 3.2
  kAcrossPeriods = 3,  ///< 3.3
  kSeveralOpen = 4,    ///< Not in order of time: 3.2's topic for continued research.
};

/// Parameters of the frame builder, with the paper's symbols. The paper gives no values.
struct FrameBuilderParams {
  Algorithm algorithm = Algorithm::kAcrossPeriods;
  double gamma_u = 1.0, gamma_v = 1.0;  // γ_U, γ_V of the coarse test (1), (2) [beamwidths], 0..1
  double gamma_theta = 0.5;             // γ_Θ of the fine test (6): overlap that is merged, 0..1
  double alpha_0 = 0.7;                 // α0 of (8); Θ is a full width: 0.5 is the half-power edge
  double max_speed = 1000.0;            // v_max [m/s]
  double range_gate_chi2 = 6.63;        // G0 of (3), (4): χ² with one degree of freedom
  double angle_gate_chi2 = 9.21;        // G0 of (7): χ² with two degrees of freedom
  double max_frame_time = 0.5;          // T_frame^max of (23), (34) [s]
  int least_allowance_periods = 1;      // n1 of (27)
  int greatest_allowance_periods = 10;  // n2
  bool strict_group_rule = true;        // (31): any common index rejects; else the ratio below does
  double group_ratio = 0.2;             // |𝓘|/|Υ| from which on a dwell is not merged
  bool expects_next_dwell = true;       // Part III (34); false: a timer closes stale frames
  std::size_t open_frames = 4;          // at most, algorithm 4
};

}  // namespace esa_frame_builder
