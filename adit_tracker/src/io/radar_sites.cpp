#include "io/radar_sites.h"

#include <cmath>

namespace adit_tracker {

using tws_runtime::Site;

RadarSites::RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars,
                       bool joins, FrameOf frame_of)
    : bus_(bus),
      frame_(frame),
      radars_(radars),
      joins_(joins),
      frame_of_(std::move(frame_of)),
      frames_(radars.size()),
      usable_(radars.size()) {}

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

tws::SiteFrame RadarSites::onPlane(const Site& site) const {
  const double c = std::cos(origin_->turn), s = std::sin(origin_->turn);
  const double dx = site.x - origin_->x, dy = site.y - origin_->y;
  return {c * dx + s * dy, c * dy - s * dx, site.turn - origin_->turn};
}

bool RadarSites::find(std::size_t radar, bool patient) {
  if (!origin_ && !findOrigin(radar, patient)) return false;
  if (frames_[radar]) return true;
  std::string why;
  const std::optional<Site> site = siteOf(radar, why);
  if (!site && patient) return false;
  const std::string& name = radars_[radar];
  if (!site) bus_.counter("unknown sites").add("no transform from " + name + " to " + frame_ + ": " + why);
  frames_[radar] = site ? onPlane(*site) : tws::SiteFrame{};
  usable_[radar] = joins_ || tws::sameSite(*frames_[radar], tws::SiteFrame{});
  if (!usable_[radar]) {
    bus_.counter("radars at another site")
        .add(name + " stands " + std::to_string(std::lround(std::hypot(frames_[radar]->x, frames_[radar]->y))) +
             " m from the first radar; its detections are left out: to join them takes filter: turning, gates: "
             "statistical, clutter/per_radar: true");
  }
  return true;
}

}  // namespace adit_tracker
