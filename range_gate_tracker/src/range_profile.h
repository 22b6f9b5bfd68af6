#pragma once

#include <cstddef>
#include <vector>

namespace range_gate_tracker {

/// One amplitude range profile in the open range gate.
struct RangeProfile {
  double time = 0.0;             ///< [s of data time]
  double range_min = 0.0;        ///< Start of the first bin [m].
  double bin_size = 1.0;         ///< Δr [m], > 0.
  std::vector<float> amplitude;  ///< |A(r, t)|, one a bin; its square is radar cross-section [m²].

  double rangeMax() const { return range_min + bin_size * static_cast<double>(amplitude.size()); }
};

}  // namespace range_gate_tracker
