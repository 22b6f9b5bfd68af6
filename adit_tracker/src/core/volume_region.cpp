#include "core/volume_region.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {

bool VolumeRegion::contains(const VolumePlace& place, double margin) const {
  constexpr double kInHeight = 0.1;
  if (place.range < least_range - margin || place.range > greatest_range + margin) return false;
  if (std::isnan(place.height)) {
    if (!holds_unknown_height) return false;
  } else if (place.height < least_height - kInHeight * margin || place.height > greatest_height + kInHeight * margin) {
    return false;
  }
  if (azimuths >= tws::kTwoPi) return true;
  const double aside = margin / std::max(place.range, 1.0);
  return tws::wrapTwoPi(place.azimuth - first_azimuth + aside) <= azimuths + 2.0 * aside;
}

}  // namespace adit_tracker
