#include "io/radar_sites.h"

#include <cmath>

namespace adit_tracker {

using tws_runtime::Site;

// In the gate, one more than the radars: the first radar's before it is heard, which may have another frame then.
RadarSites::RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars,
                       bool joins, const std::optional<tws::LocalFrame>& map, FrameOf frame_of)
    : bus_(bus),
      radars_(radars),
      joins_(joins),
      frame_of_(std::move(frame_of)),
      gate_(bus, frame, kMostWaiting, radars.size() + 1),
      frames_(radars.size()),
      usable_(radars.size()),
      map_(map) {}

/// Before its first message a radar's frame is taken to have its name.
const std::string& RadarSites::frameOf(std::size_t slot) const {
  const std::size_t radar = slot < radars_.size() ? slot : 0;
  const std::string& heard = frame_of_(radar);
  return heard.empty() ? radars_[radar] : heard;
}

/// Whose site a sector needs before that of its own radar: the origin's, until there is one.
std::size_t RadarSites::firstSlot(std::size_t radar) const {
  if (origin_) return radar;
  return frame_of_(0).empty() ? radars_.size() : 0;
}

/// By the frames of the latest messages; what waits has those of its own time.
void RadarSites::findSoon(std::size_t radar) {
  if (!origin_) gate_.find(radars_.size(), frameOf(0));
  gate_.find(radar, frameOf(radar));
}

/// The first radar's; else, as that was given up, that of the radar in question.
void RadarSites::findOrigin(std::size_t radar) {
  if (origin_) return;
  for (const std::size_t slot : {radars_.size(), std::size_t{0}, radar})
    if (!origin_) origin_ = gate_.site(slot);
  if (!origin_) origin_ = Site{};
  const Eigen::Vector3d at(origin_->x, origin_->y, origin_->z);
  plane_ = tws::EarthPlane(map_ ? map_->origin() : tws::kSomewhere, at, origin_->turn);
}

tws::SiteFrame RadarSites::onPlane(const Site& site) const {
  const double c = std::cos(origin_->turn), s = std::sin(origin_->turn);
  const double dx = site.x - origin_->x, dy = site.y - origin_->y;
  return {c * dx + s * dy, c * dy - s * dx, site.turn - origin_->turn, site.z - origin_->z};
}

/// Whether the radar takes part. Its site is known or given up.
bool RadarSites::place(std::size_t radar) {
  findOrigin(radar);
  if (frames_[radar]) return usable_[radar];
  const std::optional<Site>& site = gate_.site(radar);
  frames_[radar] = site ? onPlane(*site) : tws::SiteFrame{};
  usable_[radar] = joins_ || tws::sameSite(*frames_[radar], tws::SiteFrame{});
  if (!usable_[radar]) {
    bus_.counter("radars at another site")
        .add(radars_[radar] + " stands " +
             std::to_string(std::lround(std::hypot(frames_[radar]->x, frames_[radar]->y))) +
             " m from the first radar; its detections are left out: to join them takes filter: turning, gates: "
             "statistical, clutter/per_radar: true");
  }
  return usable_[radar];
}

}  // namespace adit_tracker
