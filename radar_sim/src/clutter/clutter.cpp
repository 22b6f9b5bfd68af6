#include "clutter/clutter.h"

#include <algorithm>

namespace radar_sim {

bool ClutterSpec::isSeenBy(const std::string& radar) const {
  return radars.empty() || std::find(radars.begin(), radars.end(), radar) != radars.end();
}

}  // namespace radar_sim
