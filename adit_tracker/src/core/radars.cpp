#include "core/radars.h"

#include <algorithm>

namespace adit_tracker {

Radars::Radars(const AditParams& params) : reference_(radarIndex(params, params.reference_radar)) {
  for (const RadarParams& radar : params.radars) radars_.emplace_back(radar, params.learn_noise);
}

void Radars::place(std::size_t radar, const tws::SiteFrame& frame) {
  radars_[radar].frame = frame;
  radars_[radar].joined = false;
}

bool Radars::join(std::size_t radar) {
  RadarState& state = radars_[radar];
  state.joined = true;
  const auto known = std::find_if(sites_.begin(), sites_.end(),
                                  [&](const tws::SiteFrame& site) { return tws::sameSite(site, state.frame); });
  const bool is_new = known == sites_.end();
  state.site = static_cast<std::size_t>(known - sites_.begin());
  if (is_new) sites_.push_back(state.frame);
  return is_new;
}

std::vector<tws::SiteFrame> Radars::frames() const {
  std::vector<tws::SiteFrame> frames;
  for (const RadarState& each : radars_) frames.push_back(each.joined ? each.frame : tws::SiteFrame{});
  return frames;
}

std::optional<double> leastAgeToConvert(const ConversionParams& params, const tws::Antenna& antenna,
                                        std::int64_t running, long offset) {
  const long scans = params.scans;
  if (running / tws::kSectors % scans != offset) return std::nullopt;
  return 0.5 * static_cast<double>(scans) * antenna.period();
}

}  // namespace adit_tracker
