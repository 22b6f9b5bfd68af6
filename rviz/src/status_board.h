#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drawing.h"
#include "ppi_style.h"

namespace tws_rviz {

struct RadarStatus {
  std::string name;
  Rgba color;
  double rotation_period = 0.0;  // [s]; NaN: unknown
  bool turning = false;          // its beam is drawn
  std::string alignment;         // what is taken out of its plots; empty: nothing
};

struct TrackerStatus {
  std::string name;
  std::array<int, 3> counts{};  // tentative, firm, coasting
};

struct PpiStatus {
  double time = 0.0;     // data time [s]
  double spacing = 0.0;  // of the range rings [m]
  std::vector<RadarStatus> radars;
  std::vector<TrackerStatus> trackers;
  std::optional<std::ptrdiff_t> clutter;  // points that absorb; nothing: there is no map
};

/// Time of day, e.g. "00:02:05", from seconds since midnight or the epoch.
std::string clockText(double time);

/// The text in the upper corners outside of the circle: on the left time, scale and radars in their colours, with what
/// is taken out of their plots as far as there is room (a star: there is more to say), on the right the number of
/// tracks of each state in its colour.
Drawing drawStatus(const PpiStyle& style, const PpiStatus& status);

}  // namespace tws_rviz
