// How Adit works with its clutter maps.
#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "core/adit.h"

namespace adit_tracker {

void Adit::mapClutter(std::size_t index, std::int64_t running) {
  RadarState& radar = radars_[index];
  const double now = radar.antenna.timeAt(tws::Antenna::startOf(running + 1));
  // A common map is judged by the scans of the reference radar, a radar's own map by its own.
  const bool judges = params_.clutter.per_radar || index == reference_;
  const auto judge_after = judges ? judgeAfter(index, running, 0) : std::nullopt;
  for (const ClutterPoint& point : clutterOf(index).process(index, radar, running, now, judge_after)) {
    tws::Plot plot;
    plot.time = point.last_update;
    plot.range = point.range;
    plot.azimuth = point.azimuth;
    Track* const track = startTrack(index, plot);
    if (track == nullptr) continue;
    track->updated = point.updated;  // with one map for all, another radar may have seen it last
    ++counts_.to_track;
  }
}

std::size_t Adit::loadClutter(const std::vector<ClutterPlace>& places) {
  ClutterLimits limits(params_);
  for (const ClutterPlace& place : places) {
    const std::string problem = limits.add(place);
    if (!problem.empty()) throw std::invalid_argument(problem);
  }
  std::size_t refused = 0;
  for (std::size_t map = 0; map < clutter_.size(); ++map) {
    const bool common = !params_.clutter.per_radar;
    std::vector<ClutterPlace>& awaited = awaited_clutter_[map];
    std::copy_if(places.begin(), places.end(), std::back_inserter(awaited), [&](const ClutterPlace& place) {
      return common || place.radar.empty() || place.radar == params_.radars[map].name;
    });
    if (common ? counts_.sectors > 0 : radars_[map].antenna.known()) refused += loadClutterInto(map, awaited);
  }
  return refused;
}

/// The sectors that the map is too late for, because it runs ahead, are mapped now.
void Adit::loadAwaitedClutter(const tws::SectorRef& turn) {
  const std::size_t map = clutterIndex(turn.radar);
  if (awaited_clutter_[map].empty()) return;
  loadClutterInto(map, awaited_clutter_[map]);
  for (std::int64_t ahead = 0; ahead < kClutterAhead; ++ahead) mapClutter(turn.radar, turn.running + ahead);
}

/// One radar's places after the other's: each radar may know the same points.
std::size_t Adit::loadClutterInto(std::size_t map, std::vector<ClutterPlace>& awaited) {
  const std::vector<ClutterPlace> places = std::exchange(awaited, {});
  std::vector<std::string> groups = {""};
  for (const RadarParams& radar : params_.radars) groups.push_back(radar.name);
  std::size_t refused = 0;
  const bool elsewhere = !tws::sameSite(radars_[map].frame, sites_.front());  // and sees no place of all radars there
  for (const std::string& group : groups) {
    if (elsewhere && group.empty()) continue;
    std::vector<ClutterPlace> own;
    std::copy_if(places.begin(), places.end(), std::back_inserter(own),
                 [&](const auto& p) { return p.radar == group; });
    refused += clutter_[map].load(own, report_.enter_time, radars_[map].quality);
  }
  counts_.refused_clutter += refused;
  return refused;
}

std::vector<ClutterPlace> Adit::clutterPlaces() const {
  std::vector<ClutterPlace> places;
  for (std::size_t map = 0; map < clutter_.size(); ++map) {
    const auto begin = static_cast<std::ptrdiff_t>(places.size());
    const std::string radar = params_.clutter.per_radar ? params_.radars[map].name : "";
    for (const ClutterPoint& point : clutter_[map].points())
      if (clutter_[map].known(point)) places.push_back({radar, point.range, point.azimuth});
    std::sort(places.begin() + begin, places.end(), [](const ClutterPlace& a, const ClutterPlace& b) {
      return std::tie(a.azimuth, a.range) < std::tie(b.azimuth, b.range);
    });
  }
  return places;
}

}  // namespace adit_tracker
