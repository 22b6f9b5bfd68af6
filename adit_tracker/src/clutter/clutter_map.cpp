#include "clutter/clutter_map.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/quantisation.h>

namespace adit_tracker {
namespace {
// A point updated so recently has been met on this scan already and has changed its sector since. The report's second
// is longer than a scan of a fast radar: then half a scan counts.
constexpr double kSameScan = 1.0;  // [s]
// Memory follows the highest number. Nobody asks for a point that so many others have been dropped after.
constexpr std::uint32_t kRestingNumbers = 4096;
constexpr std::int32_t kUnplaced = -1;

/// One that no radar has seen yet.
ClutterPoint pointAt(double range, double azimuth, double time) {
  ClutterPoint point;
  point.range = range;
  point.azimuth = azimuth;
  point.first_time = point.last_update = time;
  point.updated.fill(kNever);
  return point;
}

using NumbersBySector = std::array<std::vector<std::uint32_t>, tws::kSectors>;

/// Takes the nearest point out of `there` that lies within the region round the place.
std::optional<std::uint32_t> claimNearest(NumbersBySector& there, const std::vector<ClutterPoint>& points,
                                          const ClutterPlace& place, const Gate& region) {
  std::optional<std::uint32_t> nearest;
  double least = 0.0;
  std::vector<std::uint32_t>* home = nullptr;
  for (int offset = -1; offset <= 1; ++offset) {
    auto& numbers = there[static_cast<std::size_t>(tws::wrapSector(tws::sectorOf(place.azimuth) + offset))];
    auto n = std::lower_bound(numbers.begin(), numbers.end(), place.range - region.range,
                              [&](std::uint32_t number, double range) { return points[number].range < range; });
    for (; n != numbers.end() && points[*n].range <= place.range + region.range; ++n) {
      const double away = std::abs(tws::angularDifference(points[*n].azimuth, place.azimuth));
      const double distance = effectiveDistance(region, std::abs(points[*n].range - place.range), away);
      if (away > region.azimuth || (nearest && distance >= least)) continue;
      nearest = *n;
      least = distance;
      home = &numbers;
    }
  }
  if (nearest) home->erase(std::find(home->begin(), home->end(), *nearest));
  return nearest;
}

}  // namespace

ClutterMap::ClutterMap(const AditParams& params)
    : params_(params),
      most_hits_(static_cast<std::int32_t>(params.clutter.hits)),
      numbers_(params.clutter.capacity, kRestingNumbers),
      sectors_(params.clutter.capacity) {
  for (const Volume& volume : params.volumes)
    most_hits_ = std::max(most_hits_, static_cast<std::int32_t>(volume.params.clutter.hits));
}

const LocalParams& ClutterMap::paramsOf(const ClutterPoint& point) const {
  return point.volume == kUnplaced ? params_ : params_.in(static_cast<std::uint16_t>(point.volume));
}

/// It hardly moves: once is enough.
void ClutterMap::place(ClutterPoint& point, const tws::SiteFrame& site) const {
  const double azimuth = site.onPlane(point.azimuth);
  const tws::PlanarView seen =
      tws::SiteFrame{}.view(site.x + point.range * std::sin(azimuth), site.y + point.range * std::cos(azimuth));
  point.volume = params_.volumeAt({seen.distance, seen.azimuth});
}

Gate ClutterMap::regionAround(double range, const RadarQuality& quality) const {
  const ClutterParams& clutter = params_.clutter;
  Gate region = clutter.gate;
  if (clutter.gate_sigmas > 0.0) {
    region.range = std::min(region.range, clutter.gate_sigmas * quality.rangeSigma());
    // Close by, where a reflector is larger than the beam's error, the region is as wide as it is deep.
    region.azimuth =
        std::min(region.azimuth, std::max(clutter.gate_sigmas * quality.azimuthSigma(), region.range / range));
  }
  return region;
}

Detection* ClutterMap::nearest(const ClutterPoint& point, RadarState& radar, std::int64_t running) const {
  const Gate region = regionAround(point.range, radar.quality);
  Detection* best = nullptr;
  double least = 0.0;
  const auto closest = [&](Detection& detection, double range_difference, double azimuth_difference) {
    const double distance = effectiveDistance(params_.clutter.gate, range_difference, azimuth_difference);
    if (best != nullptr && distance >= least) return;
    best = &detection;
    least = distance;
  };
  for (std::int64_t sector = running - 1; sector <= running + 1; ++sector) {
    radar.detections.at(sector).near(point.range, point.azimuth, region.range, region.azimuth, closest);
  }
  return best;
}

void ClutterMap::take(ClutterPoint& point, Detection& detection, std::size_t radar) {
  const tws::Plot& plot = detection.plot;
  // Smoothing 1 is the report's: the point takes over the detection's position.
  const double weight = std::max(params_.clutter.smoothing, 1.0 / (point.hits + 1));
  point.range += weight * (plot.range - point.range);
  point.azimuth = tws::wrapTwoPi(point.azimuth + weight * tws::angularDifference(plot.azimuth, point.azimuth));
  point.last_update = plot.time;
  point.updated[radar] = plot.time;
  const bool absorbs = absorbing(point);
  ++point.hits;
  if (absorbs) {
    detection.use();
    detection.absorbed = true;
    ++absorbed_;
  } else {
    detection.claim = point.number;
  }
}

/// Compares the place with the one stored eight scans ago, and stores the present one.
bool ClutterMap::moves(ClutterPoint& point, double judge_after) const {
  const auto rates = point.reference.compare(point.last_update, point.range, point.azimuth, judge_after);
  const ConversionParams& limits = paramsOf(point).conversion;
  return rates && isFaster(rates->range, rates->azimuth, point.range, limits.speed_up, limits);
}

std::vector<ClutterPoint> ClutterMap::process(std::size_t radar_index, RadarState& radar, std::int64_t running,
                                              double now, std::optional<double> judge_after) {
  std::vector<ClutterPoint> moving;
  const int sector = tws::wrapSector(static_cast<int>(running % tws::kSectors));
  front_ = tws::wrapSector(sector + 1);
  const double same_scan = std::min(kSameScan, 0.5 * radar.antenna.period());
  std::uint32_t next = 0;
  for (std::uint32_t n = sectors_.first(sector); n != tws::SectorFile::kNone; n = next) {
    next = sectors_.next(n);
    ClutterPoint& point = points_[n];
    if (point.volume == kUnplaced) place(point, radar.frame);
    if (now - point.last_update > paramsOf(point).clutter.drop_time) {
      drop(n);
      continue;
    }
    if (now - point.updated[radar_index] < same_scan) continue;
    Detection* const detection = nearest(point, radar, running);
    if (detection != nullptr) take(point, *detection, radar_index);
    if (judge_after && absorbing(point) && moves(point, *judge_after)) {
      moving.push_back(point);
      drop(n);
      continue;
    }
    const int place = tws::sectorOf(point.azimuth);
    if (place == sector) continue;
    sectors_.remove(n);
    sectors_.addLast(n, place);
  }
  return moving;
}

/// Would a point that moves to another sector miss its turn?
bool ClutterMap::wouldPass(int from, int to) const {
  return tws::sectorDifference(from, front_) >= 0 && tws::sectorDifference(to, front_) < 0 &&
         std::abs(tws::sectorDifference(to, from)) < tws::kSectors / 4;
}

void ClutterMap::moveOrigin(double dx, double dy) {
  std::vector<std::uint32_t> all;
  for (int sector = 0; sector < tws::kSectors; ++sector)
    for (auto n = sectors_.first(sector); n != tws::SectorFile::kNone; n = sectors_.next(n)) all.push_back(n);
  for (const std::uint32_t n : all) {
    ClutterPoint& point = points_[n];
    adit_tracker::moveOrigin(point.range, point.azimuth, dx, dy);
    if (point.reference.time != kNever)
      adit_tracker::moveOrigin(point.reference.range, point.reference.azimuth, dx, dy);
    const int from = sectors_.sector(n), to = tws::sectorOf(point.azimuth);
    if (from == to || wouldPass(from, to)) continue;
    sectors_.remove(n);
    sectors_.addLast(n, to);
  }
}

bool ClutterMap::insert(ClutterPoint point) {
  const auto number = numbers_.take();
  if (!number) return false;
  point.number = *number;
  point.volume = params_.volumes.empty() ? 0 : kUnplaced;
  if (points_.size() <= *number) points_.resize(*number + 1);
  points_[*number] = point;
  sectors_.addLast(*number, tws::sectorOf(point.azimuth));
  ++size_;
  return true;
}

bool ClutterMap::initiate(const tws::Plot& plot, std::size_t radar) {
  ClutterPoint point = pointAt(plot.range, plot.azimuth, plot.time);
  point.updated[radar] = plot.time;
  return insert(point);
}

bool ClutterMap::adopt(double range, double azimuth, double time, std::size_t radar) {
  ClutterPoint point = pointAt(range, azimuth, time);
  point.hits = most_hits_;
  point.updated[radar] = time;
  return insert(point);
}

/// Numbers of the points in each sector, by range.
std::array<std::vector<std::uint32_t>, tws::kSectors> ClutterMap::byRange() const {
  std::array<std::vector<std::uint32_t>, tws::kSectors> sorted;
  const auto nearer = [&](std::uint32_t a, std::uint32_t b) { return points_[a].range < points_[b].range; };
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    auto& numbers = sorted[static_cast<std::size_t>(sector)];
    for (auto n = sectors_.first(sector); n != tws::SectorFile::kNone; n = sectors_.next(n)) numbers.push_back(n);
    std::stable_sort(numbers.begin(), numbers.end(), nearer);
  }
  return sorted;
}

std::size_t ClutterMap::load(const std::vector<ClutterPlace>& places, double time, const RadarQuality& quality) {
  auto there = byRange();  // those that no place has claimed
  std::size_t refused = 0;
  for (const ClutterPlace& place : places) {
    const auto claimed = claimNearest(there, points_, place, regionAround(place.range, quality));
    if (claimed) {
      ClutterPoint& point = points_[*claimed];
      point.hits = std::max(point.hits, hitsWhenKnown());
      point.last_update = std::max(point.last_update, time);
      continue;
    }
    ClutterPoint point = pointAt(place.range, place.azimuth, time);
    point.hits = hitsWhenKnown();
    if (!insert(point)) ++refused;
  }
  return refused;
}

void ClutterMap::drop(std::uint32_t number) {
  sectors_.remove(number);
  numbers_.drop(number);
  --size_;
}

void ClutterMap::disclaim(std::uint32_t number) {
  if (numbers_.used(number) && !absorbing(points_[number])) drop(number);
}

std::vector<ClutterPoint> ClutterMap::points() const {
  std::vector<ClutterPoint> all;
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (auto n = sectors_.first(sector); n != tws::SectorFile::kNone; n = sectors_.next(n)) all.push_back(points_[n]);
  }
  return all;
}

}  // namespace adit_tracker
