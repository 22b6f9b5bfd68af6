#include "clutter/clutter_places.h"

#include <algorithm>
#include <cstdio>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace adit_tracker {
namespace {

std::string unfit(const char* what, double value) {
  char text[80];
  std::snprintf(text, sizeof text, "%s: %.10g", what, value);
  return text;
}

std::string problemOf(const ClutterPlace& place) {
  if (!(place.range > 0.0 && place.range <= kFarthest)) return unfit("range_m is not in (0, 1e7]", place.range);
  if (!(place.azimuth >= 0.0 && place.azimuth < tws::kTwoPi))
    return unfit("az_deg is not in [0, 360)", tws::degrees(place.azimuth));
  return "";
}

}  // namespace

ClutterLimits::ClutterLimits(const AditParams& params)
    : per_radar_(params.clutter.per_radar), most_(params.clutter.capacity - 1) {
  for (const RadarParams& radar : params.radars) radars_.push_back(radar.name);
  used_.resize(per_radar_ ? radars_.size() : 1);
}

std::string ClutterLimits::add(const ClutterPlace& place) {
  std::string problem = problemOf(place);
  if (!problem.empty()) return problem;
  const auto radar = std::find(radars_.begin(), radars_.end(), place.radar);
  if (!place.radar.empty() && radar == radars_.end()) return "there is no radar '" + place.radar + "'";
  const bool one_map = per_radar_ && !place.radar.empty();
  const std::size_t begin = one_map ? static_cast<std::size_t>(radar - radars_.begin()) : 0;
  const std::size_t end = one_map ? begin + 1 : used_.size();
  for (std::size_t map = begin; map < end; ++map) {
    if (++used_[map] > most_) return "more than " + std::to_string(most_) + " points in one map (clutter.capacity)";
  }
  return "";
}

}  // namespace adit_tracker
