#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/number_file.h>
#include <tws_core/sector_file.h>
#include <tws_core/sectors.h>

#include "adit_params.h"
#include "clutter/clutter_places.h"
#include "core/radar_state.h"
#include "core/track.h"

namespace adit_tracker {

/// A stationary or very slowly moving reflector.
struct ClutterPoint {
  std::uint32_t number = 0;           // NC
  double range = 0.0, azimuth = 0.0;  // RPC, APC
  double first_time = 0.0;
  double last_update = 0.0;
  std::array<double, kMaxRadars> updated;  // TC12, TC39; kNever
  std::int32_t hits = 1;                   // detections so far
  std::int32_t volume = 0;                 // by whose parameters it goes: AditParams::in; -1: nobody knows yet
  ReferencePlace reference;                // RC
};

/// The report's CLUTTER MAP: takes the detections of clutter points and of slowly moving targets out of the detection
/// file before any track sees them. Cost of a sector: its points × logarithm of the detections in three sectors.
class ClutterMap {
 public:
  explicit ClutterMap(const AditParams& params);

  /// The points of the running sector against the detections of it and its neighbours, at `now` (MRK of the sector
  /// after). With `judge_after`, the points there are also tested for movement since a place stored at least so long
  /// ago [s], and those that move are returned.
  std::vector<ClutterPoint> process(std::size_t radar_index, RadarState& radar, std::int64_t running, double now,
                                    std::optional<double> judge_after);

  /// The origin of ranges and azimuths moves [m], the points do not.
  void moveOrigin(double dx, double dy);

  /// A new point; false: the map is full.
  bool initiate(const tws::Plot& plot, std::size_t radar);
  /// A point from a track that has become slow: it takes detections at once.
  bool adopt(double range, double azimuth, double time, std::size_t radar);

  /// Clutter is known to stand at these places: points that take detections at once, as if updated last at `time` [s].
  /// A point of the map that is there already (each serves one place) counts as known in place of a new one. `quality`
  /// is that of the map's radar. Returns for how many there was no number.
  std::size_t load(const std::vector<ClutterPlace>& places, double time, const RadarQuality& quality);

  /// A firm track has used the detection that this point on probation was after: it was an aircraft. Unknown numbers
  /// are ignored.
  void disclaim(std::uint32_t number);

  std::uint32_t size() const { return size_; }
  bool absorbing(const ClutterPoint& point) const { return point.hits >= paramsOf(point).clutter.hits; }
  /// Absorbing, and not from a single detection: the report's points absorb from the start, whatever they are.
  bool known(const ClutterPoint& point) const { return point.hits >= hitsWhenKnown(); }
  /// All points, by sector.
  std::vector<ClutterPoint> points() const;
  std::uint64_t absorbed() const { return absorbed_; }

 private:
  bool insert(ClutterPoint point);
  std::int32_t hitsWhenKnown() const { return std::max(2, most_hits_); }
  const LocalParams& paramsOf(const ClutterPoint& point) const;
  Gate regionAround(double range, const RadarQuality& quality) const;
  std::array<std::vector<std::uint32_t>, tws::kSectors> byRange() const;
  void drop(std::uint32_t number);
  Detection* nearest(const ClutterPoint& point, RadarState& radar, std::int64_t running) const;
  void take(ClutterPoint& point, Detection& detection, std::size_t radar);
  void place(ClutterPoint& point, const tws::SiteFrame& site) const;
  bool moves(ClutterPoint& point, double judge_after) const;
  bool wouldPass(int from, int to) const;

  AditParams params_;
  std::int32_t most_hits_;  // with which a point absorbs wherever it is
  tws::NumberFile numbers_;
  tws::SectorFile sectors_;
  std::vector<ClutterPoint> points_;  // by number
  int front_ = 0;                     // sector to be processed next
  std::uint32_t size_ = 0;
  std::uint64_t absorbed_ = 0;
};

}  // namespace adit_tracker
