#pragma once

#include <vector>

#include "array_beam.h"

namespace radar_sim {

/// The beams of an array's search: row by row over its part of sine space, one after the other and over again. The grid
/// is spread evenly, no wider than the wanted spacing, and its outer beams cover the edges to within half of it.
class SearchRaster {
 public:
  /// Throws std::invalid_argument when no beam of the search can be steered.
  explicit SearchRaster(const ArrayParams& array);

  const BeamPoint& next();
  const std::vector<BeamPoint>& beams() const { return beams_; }

 private:
  std::vector<BeamPoint> beams_;
  std::size_t next_ = 0;
};

/// Centres of intervals of equal width, at most `widest` [> 0], that fill [from, to]; one centre when it is empty.
std::vector<double> evenCentres(double from, double to, double widest);

}  // namespace radar_sim
