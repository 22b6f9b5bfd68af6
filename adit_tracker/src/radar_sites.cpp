#include "radar_sites.h"

#include <cmath>

namespace adit_tracker {
namespace {

using tws_runtime::Site;

// Radars further apart than this do not see a target in the same polar coordinates.
constexpr double kSameSite = 100.0;  // [m]

}  // namespace

RadarSites::RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars,
                       FrameOf frame_of)
    : bus_(bus), frame_(frame), radars_(radars), frame_of_(std::move(frame_of)), usable_(radars.size()) {}

std::optional<Site> RadarSites::siteOf(std::size_t radar, std::string& why) const {
  // Before its first message a radar's frame is taken to have its name.
  const std::string& heard = frame_of_(radar);
  return tws_runtime::findSite(bus_.transforms(), frame_, heard.empty() ? radars_[radar] : heard, why);
}

/// The first radar's; else, when it is enough of waiting, that of the radar in question.
bool RadarSites::findOrigin(std::size_t radar, bool patient) {
  std::string why;
  origin_ = siteOf(0, why);
  if (origin_ || patient) return origin_.has_value();
  origin_ = siteOf(radar, why);
  if (!origin_) origin_ = Site{};
  return true;
}

bool RadarSites::find(std::size_t radar, bool patient) {
  if (!origin_ && !findOrigin(radar, patient)) return false;
  if (usable_[radar]) return true;
  std::string why;
  const std::optional<Site> site = siteOf(radar, why);
  if (!site && patient) return false;
  const std::string& name = radars_[radar];
  if (!site) bus_.counter("unknown sites").add("no transform from " + name + " to " + frame_ + ": " + why);
  const double distance = site ? std::hypot(site->x - origin_->x, site->y - origin_->y) : 0.0;
  usable_[radar] = distance <= kSameSite;
  if (!*usable_[radar]) {
    bus_.counter("radars at another site")
        .add(name + " stands " + std::to_string(std::lround(distance)) +
             " m from the first radar; its detections are left out");
  }
  return true;
}

}  // namespace adit_tracker
