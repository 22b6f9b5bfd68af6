#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "range_profile.h"

namespace range_gate_tracker {

/// What is subtracted from the power in the window.
enum class Background {
  kNone,
  kLocal,   ///< The mean of the two windows beside it, eqs. (3) and (4).
  kGlobal,  ///< s times the mean power of the whole gate.
};

/// The window of s bins that holds most power above the background.
struct WindowReading {
  std::size_t first_bin = 0;  ///< r_max
  double power = 0.0;         ///< S0(r_max) [m²]
  double total_power = 0.0;   ///< C0(r_max) [m²]
  double rest_power = 0.0;    ///< In all bins of the profile outside the window [m²].
  double range = 0.0;         ///< R, eq. (7) [m]. NaN when S0 is not positive.
};

/// Positions of the window that are looked at: those that begin in [first, last].
struct BinSpan {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
};

/// Finds the target in one profile: eqs. (1) to (7) of T. Sams, S. M. Lewis and J. H. Hviid, "Range tracking for the
/// MRS radar", DDRE A-5/2005. Bin r stands for its centre, range_min + (r + 1/2)·Δr. The cost of a bin does not depend
/// on s: the sums (1) and (3) are differences of one running sum; (2) and (4) are only needed at r_max.
///
/// Where a neighbouring window of (3) is cut off by an end of the profile, the report is silent: the background is then
/// s times the mean power of the bins that are left of both, taken as flat over the window. (Without the rescaling the
/// window would look brighter there, and false maxima appear.) Where none is left there is no background.
class DetectionWindow {
 public:
  /// `bins`: s, at least 1, else std::invalid_argument.
  DetectionWindow(std::size_t bins, Background background);

  std::size_t bins() const { return bins_; }

  /// Of equal maxima the nearest one. Throws std::invalid_argument, naming what is wrong, when the profile is shorter
  /// than the window or holds an amplitude that is not finite.
  WindowReading search(const RangeProfile& profile, BinSpan span = {});

 private:
  double sum(std::size_t from, std::size_t to) const { return power_sums_[to] - power_sums_[from]; }
  double backgroundAt(std::size_t window) const;
  std::size_t brightestWindow(BinSpan span);
  void addLocal(BinSpan span);
  double momentAbove(const RangeProfile& profile, std::size_t window, double background) const;

  std::size_t bins_;
  Background background_;
  std::size_t profile_bins_ = 0;
  std::vector<double> power_sums_;  // [r]: the power in all bins before r
  std::vector<double> net_power_;   // S0 of each window looked at
};

}  // namespace range_gate_tracker
