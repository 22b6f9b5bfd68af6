#include "search_raster.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace radar_sim {

std::vector<double> evenCentres(double from, double to, double widest) {
  // Rounding must not add an interval.
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / widest - 1e-9)));
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) centres.push_back(from + (to - from) * (i + 0.5) / count);
  return centres;
}

SearchRaster::SearchRaster(const ArrayParams& array) {
  const double step = array.search_spacing;
  for (const double v : evenCentres(array.search_v_from, array.search_v_to, step * array.beamwidth_v))
    for (const double u : evenCentres(array.search_u_from, array.search_u_to, step * array.beamwidth_u))
      if (canSteer(array, {u, v})) beams_.push_back({u, v});
  if (beams_.empty()) throw std::invalid_argument("array radar '" + array.name + "' can steer no beam of its search");
}

const BeamPoint& SearchRaster::next() {
  const BeamPoint& beam = beams_[next_];
  next_ = (next_ + 1) % beams_.size();
  return beam;
}

}  // namespace radar_sim
