#include "clutter/clutter_maps.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace adit_tracker {

ClutterMaps::ClutterMaps(const AditParams& params, Radars& radars, AditCounts& counts)
    : params_(params), radars_(radars), counts_(counts) {
  const std::size_t maps = params.clutter.per_radar ? radars.size() : 1;
  for (std::size_t i = 0; i < maps; ++i) maps_.emplace_back(params);
  awaited_.resize(maps);
}

std::vector<ClutterPoint> ClutterMaps::process(const tws::SectorRef& sector) {
  RadarState& radar = radars_.at(sector.radar);
  const double now = radar.antenna.timeAt(tws::Antenna::startOf(sector.running + 1));
  // A common map is judged by the scans of the reference radar, a radar's own map by its own.
  const bool judges = params_.clutter.per_radar || sector.radar == radars_.reference();
  const auto judge_after =
      judges ? leastAgeToConvert(params_.conversion, radar.antenna, sector.running, 0) : std::nullopt;
  return mapOf(sector.radar).process(sector.radar, radar, sector.running, now, judge_after);
}

void ClutterMaps::initiate(const tws::Plot& plot, std::size_t radar) {
  if (!mapOf(radar).initiate(plot, radar)) ++counts_.refused_clutter;
}

bool ClutterMaps::adopt(double range, double azimuth, double time, std::size_t radar) {
  const bool adopted = mapOf(radar).adopt(range, azimuth, time, radar);
  if (!adopted) ++counts_.refused_clutter;
  return adopted;
}

void ClutterMaps::moveOrigin(double dx, double dy) {
  for (ClutterMap& map : maps_) map.moveOrigin(dx, dy);
}

std::size_t ClutterMaps::load(const std::vector<ClutterPlace>& places, double time) {
  ClutterLimits limits(params_);
  for (const ClutterPlace& place : places) {
    const std::string problem = limits.add(place);
    if (!problem.empty()) throw std::invalid_argument(problem);
  }
  std::size_t refused = 0;
  for (std::size_t map = 0; map < maps_.size(); ++map) {
    const bool common = !params_.clutter.per_radar;
    std::copy_if(places.begin(), places.end(), std::back_inserter(awaited_[map]), [&](const ClutterPlace& place) {
      return common || place.radar.empty() || place.radar == params_.radars[map].name;
    });
    if (common ? counts_.sectors > 0 : radars_.antenna(map).known()) refused += loadInto(map, time);
  }
  return refused;
}

bool ClutterMaps::loadAwaited(std::size_t radar, double time) {
  const std::size_t map = indexOf(radar);
  if (awaited_[map].empty()) return false;
  loadInto(map, time);
  return true;
}

/// One radar's places after the other's: each radar may know the same points.
std::size_t ClutterMaps::loadInto(std::size_t map, double time) {
  const std::vector<ClutterPlace> places = std::exchange(awaited_[map], {});
  std::vector<std::string> groups = {""};
  for (const RadarParams& radar : params_.radars) groups.push_back(radar.name);
  std::size_t refused = 0;
  // A radar elsewhere sees no place of all radars there.
  const bool elsewhere = !tws::sameSite(radars_.at(map).frame, radars_.sites().front());
  for (const std::string& group : groups) {
    if (elsewhere && group.empty()) continue;
    std::vector<ClutterPlace> own;
    std::copy_if(places.begin(), places.end(), std::back_inserter(own),
                 [&](const auto& p) { return p.radar == group; });
    refused += maps_[map].load(own, time, radars_.quality(map));
  }
  counts_.refused_clutter += refused;
  return refused;
}

std::uint64_t ClutterMaps::absorbed() const {
  std::uint64_t sum = 0;
  for (const ClutterMap& map : maps_) sum += map.absorbed();
  return sum;
}

std::vector<ClutterPlace> ClutterMaps::places() const {
  std::vector<ClutterPlace> places;
  for (std::size_t map = 0; map < maps_.size(); ++map) {
    const auto begin = static_cast<std::ptrdiff_t>(places.size());
    const std::string radar = params_.clutter.per_radar ? params_.radars[map].name : "";
    for (const ClutterPoint& point : maps_[map].points())
      if (maps_[map].known(point)) places.push_back({radar, point.range, point.azimuth});
    std::sort(places.begin() + begin, places.end(), [](const ClutterPlace& a, const ClutterPlace& b) {
      return std::tie(a.azimuth, a.range) < std::tie(b.azimuth, b.range);
    });
  }
  return places;
}

}  // namespace adit_tracker
