#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tws_core/earth_plane.h>
#include <tws_core/sector_order.h>

#include "adit_params.h"
#include "core/radar_state.h"

namespace adit_tracker {

/// The tracker's radars, and the sites at which they stand. A site has azimuth sectors of its own; there is one from
/// the beginning, the first radar's, and a radar elsewhere brings its own with its first sector.
class Radars {
 public:
  explicit Radars(const AditParams& params);

  std::size_t size() const { return radars_.size(); }
  RadarState& at(std::size_t radar) { return radars_[radar]; }
  const RadarState& at(std::size_t radar) const { return radars_[radar]; }
  const tws::Antenna& antenna(std::size_t radar) const { return radars_[radar].antenna; }
  RadarQuality& quality(std::size_t radar) { return radars_[radar].quality; }
  const RadarQuality& quality(std::size_t radar) const { return radars_[radar].quality; }
  /// Index of the reference radar.
  std::size_t reference() const { return reference_; }

  /// The radar stands there; before its first sector.
  void place(std::size_t radar, const tws::SiteFrame& frame);
  /// The radar's first sector is about to be processed. True: its site is a new one, the last of sites().
  bool join(std::size_t radar);

  /// What earth lies under the plane; before the first join().
  void standOn(const tws::EarthPlane& plane) { plane_ = plane; }
  const tws::EarthPlane& plane() const { return plane_; }

  /// Those whose radars have sent sectors, the first radar's always.
  const std::vector<tws::SiteFrame>& sites() const { return sites_; }
  bool severalSites() const { return sites_.size() > 1; }
  /// What was learned of each radar that has had sectors.
  std::vector<RadarCounts> counts() const;
  /// The same of another run, as if it had been seen on a few looks, less those made already (see
  /// FalsePlotMap and CoverageMap). Throws what check() does, and then nothing is loaded.
  void load(const std::vector<RadarCounts>& counts);
  /// Throws std::invalid_argument that says why they cannot be loaded.
  void check(const std::vector<RadarCounts>& counts) const;
  /// What all ranges and azimuths are counted from: where the radars stand, or, on own ship, where it was a moment ago.
  const PlaneOrigin& origin() const { return origin_; }
  /// Own ship has moved [m]: the plots in hand are seen from there.
  void moveOrigin(double dx, double dy);

  /// Where each radar stands; the first radar's site as long as it has not joined.
  std::vector<tws::SiteFrame> frames() const;

 private:
  std::size_t indexOf(const std::string& name) const;

  std::vector<RadarState> radars_;
  std::vector<std::string> names_;
  tws::EarthPlane plane_;
  std::vector<tws::SiteFrame> sites_{tws::SiteFrame{}};
  PlaneOrigin origin_;
  std::size_t reference_;
};

/// When slow tracks and moving clutter points are converted: on every eighth scan (`conversion.scans`), `offset` scans
/// later for one than for the other. The least age [s] of a stored place for the comparison; nothing: not on this scan.
std::optional<double> leastAgeToConvert(const ConversionParams& params, const tws::Antenna& antenna,
                                        std::int64_t running, long offset);

}  // namespace adit_tracker
