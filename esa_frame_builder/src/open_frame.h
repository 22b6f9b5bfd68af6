#pragma once

#include <vector>

#include "beam_tests.h"

namespace esa_frame_builder {

/// The frame that is being filled, with the tests whether one more dwell fits.
class OpenFrame {
 public:
  OpenFrame(std::uint32_t number, const FrameBuilderParams& params) : number_(number), params_(&params) {}

  void add(SpannedDwell dwell);

  std::uint32_t number() const { return number_; }
  const std::vector<SpannedDwell>& dwells() const { return dwells_; }
  /// (24): t_min [s]; infinite while empty.
  double startTime() const { return start_time_; }
  /// (9): r_min over all measurements [m]; nothing measured: infinite.
  double leastRange() const { return least_range_; }
  /// (9): θ̇_max = v_max/r_min [1/s]; nothing measured: 0.
  double greatestAngularRate() const;

  /// (23), Part I: the frame would stay open too long for a dwell at `time` [s].
  bool isTooOldFor(double time) const { return time > start_time_ + params_->max_frame_time; }
  /// (34), Part III: no dwell is expected [s] in time.
  bool willGrowStale(double next_dwell) const { return next_dwell > start_time_ + params_->max_frame_time; }
  /// (25)–(27): T_bpa [s], within [n1, n2] resource periods; n2 of them while nothing is measured.
  double beamPointAllowance(double resource_period) const;
  /// (28): the targets have hardly moved by `time`.
  bool beamPointsHold(double time, double resource_period) const {
    return time < start_time_ + beamPointAllowance(resource_period);
  }
  /// Test 1 and 2 against every dwell of the frame.
  bool beamPointTestRejects(const SpannedDwell& dwell) const;
  /// (29)–(31): a track expected in the dwell, or by the ratio rule too many of them, were expected in the frame
  /// before.
  bool dwellGroupTestRejects(const Dwell& dwell) const;
  /// A target could be in the dwell and in the frame.
  bool mayShareTargets(const SpannedDwell& dwell) const;

 private:
  std::uint32_t number_;
  const FrameBuilderParams* params_;
  std::vector<SpannedDwell> dwells_;
  std::vector<std::uint32_t> group_indices_;  // (29): Υ_{1:K'}, ascending
  double start_time_ = std::numeric_limits<double>::infinity();
  double least_range_ = std::numeric_limits<double>::infinity();
  double widest_ = 0.0;  // (26): Θ_max
};

}  // namespace esa_frame_builder
