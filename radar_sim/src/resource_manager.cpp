#include "resource_manager.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace radar_sim {
namespace {

/// Half the power, one way, at this distance from a beam's centre [beamwidths].
constexpr double kHalfPower = 0.5;

std::vector<std::uint32_t> expectedIn(const ArrayParams& array, const BeamPoint& beam,
                                      const std::vector<SteerableTrack>& tracks) {
  std::vector<std::uint32_t> numbers;
  for (const SteerableTrack& track : tracks)
    if (beamwidthsApart(array, beam, track.direction) <= kHalfPower) numbers.push_back(track.number);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Overlapping beams on a grid over the members' extent, those only that are nearest to one of them.
std::vector<BeamPoint> coveringBeams(const ArrayParams& array, const std::vector<BeamPoint>& members) {
  const auto byU = [](const BeamPoint& a, const BeamPoint& b) { return a.u < b.u; };
  const auto byV = [](const BeamPoint& a, const BeamPoint& b) { return a.v < b.v; };
  const auto [left, right] = std::minmax_element(members.begin(), members.end(), byU);
  const auto [low, high] = std::minmax_element(members.begin(), members.end(), byV);
  std::vector<BeamPoint> grid;
  for (const double v : evenCentres(low->v, high->v, array.sequence_spacing * array.beamwidth_v))
    for (const double u : evenCentres(left->u, right->u, array.sequence_spacing * array.beamwidth_u))
      grid.push_back({u, v});
  std::set<std::size_t> needed;
  for (const BeamPoint& member : members) {
    const auto isNearer = [&](const BeamPoint& a, const BeamPoint& b) {
      return beamwidthsApart(array, a, member) < beamwidthsApart(array, b, member);
    };
    needed.insert(static_cast<std::size_t>(std::min_element(grid.begin(), grid.end(), isNearer) - grid.begin()));
  }
  std::vector<BeamPoint> beams;
  beams.reserve(needed.size());
  for (const std::size_t beam : needed) beams.push_back(grid[beam]);
  return beams;
}

}  // namespace

std::vector<std::vector<std::size_t>> closeTogether(const ArrayParams& array,
                                                    const std::vector<SteerableTrack>& tracks) {
  std::vector<std::vector<std::size_t>> sets;
  std::vector<bool> taken(tracks.size(), false);
  for (std::size_t first = 0; first < tracks.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    std::vector<std::size_t> members{first};
    for (std::size_t next = 0; next < members.size(); ++next) {
      for (std::size_t other = first + 1; other < tracks.size(); ++other) {
        const BeamPoint& from = tracks[members[next]].direction;
        if (taken[other] || beamwidthsApart(array, from, tracks[other].direction) >= array.sequence_distance) continue;
        taken[other] = true;
        members.push_back(other);
      }
    }
    sets.push_back(std::move(members));
  }
  return sets;
}

std::optional<double> nextExpectedDwell(const std::vector<SteerableTrack>& tracks, double now) {
  if (tracks.empty()) return std::nullopt;
  double next = std::numeric_limits<double>::infinity();
  for (const SteerableTrack& track : tracks) next = std::min(next, track.last_update + track.revisit);
  return std::max(next, now);
}

ResourceManager::ResourceManager(const ArrayParams& array)
    : array_(array),
      raster_(array),
      // Rounding must not lose a dwell.
      capacity_(static_cast<std::size_t>(std::floor(array.resource_period / array.dwell_time + 1e-9))) {}

std::vector<PlannedDwell> ResourceManager::plan(double time, const std::vector<SteerableTrack>& tracks) {
  forgetOthers(tracks);
  const auto search = static_cast<std::size_t>(std::ceil(array_.search_share * static_cast<double>(capacity_)));
  const std::size_t limit = capacity_ - search;
  std::vector<PlannedDwell> dwells = std::move(rest_);
  rest_.clear();
  for (const Visit& visit : dueVisits(time + array_.resource_period, tracks)) {
    if (dwells.size() >= limit) break;
    for (const PlannedDwell& dwell : sequence(visit, tracks)) dwells.push_back(dwell);
    for (const std::size_t member : visit.members) last_dwells_[tracks[member].number] = time;
  }
  if (dwells.size() > limit) {
    rest_.assign(dwells.begin() + static_cast<std::ptrdiff_t>(limit), dwells.end());
    dwells.resize(limit);
  }
  while (dwells.size() < capacity_) dwells.push_back({raster_.next(), false, {}, PlannedDwell::kNoGroup, 0});
  for (PlannedDwell& dwell : dwells) dwell.expected = expectedIn(array_, dwell.beam, tracks);
  return dwells;
}

double ResourceManager::dueTime(const SteerableTrack& track) const {
  const auto last = last_dwells_.find(track.number);
  return (last == last_dwells_.end() ? track.last_update : last->second) + track.revisit;
}

std::vector<ResourceManager::Visit> ResourceManager::dueVisits(double end,
                                                               const std::vector<SteerableTrack>& tracks) const {
  std::vector<Visit> visits;
  for (std::vector<std::size_t>& members : closeTogether(array_, tracks)) {
    Visit visit{std::move(members), 0, std::numeric_limits<double>::infinity()};
    for (const std::size_t member : visit.members) {
      visit.priority = std::max(visit.priority, tracks[member].priority);
      visit.due = std::min(visit.due, dueTime(tracks[member]));
    }
    if (visit.due < end - 1e-9) visits.push_back(std::move(visit));
  }
  std::stable_sort(visits.begin(), visits.end(), [](const Visit& a, const Visit& b) {
    return a.priority != b.priority ? a.priority > b.priority : a.due < b.due;
  });
  return visits;
}

std::vector<PlannedDwell> ResourceManager::sequence(const Visit& visit, const std::vector<SteerableTrack>& tracks) {
  std::vector<BeamPoint> members;
  for (const std::size_t member : visit.members) members.push_back(tracks[member].direction);
  const std::vector<BeamPoint> beams = coveringBeams(array_, members);
  const std::uint32_t group = beams.size() > 1 ? ++groups_ : PlannedDwell::kNoGroup;
  const auto count = static_cast<std::uint32_t>(beams.size() > 1 ? beams.size() : 0);
  std::vector<PlannedDwell> dwells;
  dwells.reserve(beams.size());
  for (const BeamPoint& beam : beams) dwells.push_back({beam, true, {}, group, count});
  return dwells;
}

void ResourceManager::forgetOthers(const std::vector<SteerableTrack>& tracks) {
  std::set<std::uint32_t> known;
  for (const SteerableTrack& track : tracks) known.insert(track.number);
  for (auto it = last_dwells_.begin(); it != last_dwells_.end();)
    it = known.count(it->first) > 0 ? std::next(it) : last_dwells_.erase(it);
}

}  // namespace radar_sim
