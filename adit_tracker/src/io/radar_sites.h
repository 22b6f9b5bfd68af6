#pragma once

#include <tws_core/plot.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/site_gate.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tws_core/earth_plane.h>
#include <tws_core/sectors.h>
#include <tws_core/site_frame.h>

namespace adit_tracker {

/// Where the radars stand, from /tf_static. Their sectors wait for it, in the order in which they came: what comes out
/// does not depend on when a transform arrives, nor on which radar is heard first.
class RadarSites {
 public:
  /// Sectors that wait, at most: two turns of one radar. Then an unknown site is counted, and taken for the first
  /// radar's.
  static constexpr std::size_t kMostWaiting = std::size_t{2} * tws::kSectors;
  /// What frame a radar's messages have; empty: it was not heard yet.
  using FrameOf = std::function<const std::string&(std::size_t radar)>;

  /// `frame` is that of positions. `joins`: may radars stand at other sites than the first one? Else these are left
  /// out. `map`: where that frame lies on earth, if that is known.
  RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars, bool joins,
             const std::optional<tws::LocalFrame>& map, FrameOf frame_of);

  /// Calls `use(sector)` once the origin and the sites of this radar and of those that wait are known or given up: now
  /// or from a later call. Left out: the sectors of a radar that is not to take part.
  template <class Use>
  void add(std::size_t radar, tws::RadarSector sector, Use use) {
    findSoon(radar);
    const std::size_t first = firstSlot(radar);
    gate_.add(
        frameOf(first), std::move(sector),
        [this, radar, use](tws::RadarSector& placed) {
          gate_.add(
              frameOf(radar), std::move(placed),
              [this, radar, use](tws::RadarSector& ready) {
                if (place(radar)) use(std::move(ready));
              },
              radar);
        },
        first);
  }
  /// A new run: forgets what waits. Sites stay.
  void beginNewRun() { gate_.clear(); }
  /// How many sectors wait.
  std::size_t waiting() const { return gate_.waiting(); }

  /// Where a radar stands on the plane of the origin. Once one of its sectors was given, as the next two.
  const tws::SiteFrame& frame(std::size_t radar) const { return *frames_[radar]; }
  /// Any place as it lies on that plane.
  tws::SiteFrame onPlane(const tws_runtime::Site& site) const;
  /// That plane over the earth.
  const tws::EarthPlane& plane() const { return plane_; }
  /// The first radar's site; of the first one that is heard, when the first radar has none.
  const tws_runtime::Site& origin() const { return *origin_; }

 private:
  const std::string& frameOf(std::size_t slot) const;
  std::size_t firstSlot(std::size_t radar) const;
  void findSoon(std::size_t radar);
  void findOrigin(std::size_t radar);
  bool place(std::size_t radar);

  tws_runtime::Bus& bus_;
  std::vector<std::string> radars_;
  bool joins_;
  FrameOf frame_of_;
  tws_runtime::SiteGate gate_;
  std::vector<std::optional<tws::SiteFrame>> frames_;
  std::vector<bool> usable_;
  std::optional<tws_runtime::Site> origin_;
  std::optional<tws::LocalFrame> map_;
  tws::EarthPlane plane_;
};

}  // namespace adit_tracker
