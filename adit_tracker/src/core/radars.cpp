#include "core/radars.h"

#include <algorithm>
#include <stdexcept>

namespace adit_tracker {

Radars::Radars(const AditParams& params) : reference_(radarIndex(params, params.reference_radar)) {
  for (const RadarParams& radar : params.radars) {
    radars_.emplace_back(radar, params.learn_noise);
    names_.push_back(radar.name);
  }
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

void Radars::moveOrigin(double dx, double dy) {
  origin_.x += dx;
  origin_.y += dy;
  for (RadarState& radar : radars_) radar.detections.moveOrigin(dx, dy);
}

std::vector<tws::SiteFrame> Radars::frames() const {
  std::vector<tws::SiteFrame> frames;
  for (const RadarState& each : radars_) frames.push_back(each.joined ? each.frame : tws::SiteFrame{});
  return frames;
}

/// size(): there is none of that name.
std::size_t Radars::indexOf(const std::string& name) const {
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

std::vector<RadarCounts> Radars::counts() const {
  std::vector<RadarCounts> counts;
  for (std::size_t radar = 0; radar < size(); ++radar) {
    if (!antenna(radar).known()) continue;
    counts.push_back(quality(radar).counts());
    counts.back().radar = names_[radar];
  }
  return counts;
}

void Radars::check(const std::vector<RadarCounts>& counts) const {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string& radar = counts[i].radar;
    if (indexOf(radar) == size()) throw std::invalid_argument("there is no radar '" + radar + "'");
    if (const std::string problem = problemOf(counts[i]); !problem.empty()) throw std::invalid_argument(problem);
    if (i >= size()) throw std::invalid_argument("more maps than radars");
  }
}

void Radars::load(const std::vector<RadarCounts>& counts) {
  check(counts);
  for (const RadarCounts& each : counts) quality(indexOf(each.radar)).load(each);
}

std::optional<double> leastAgeToConvert(const ConversionParams& params, const tws::Antenna& antenna,
                                        std::int64_t running, long offset) {
  const long scans = params.scans;
  if (running / tws::kSectors % scans != offset) return std::nullopt;
  return 0.5 * static_cast<double>(scans) * antenna.period();
}

}  // namespace adit_tracker
