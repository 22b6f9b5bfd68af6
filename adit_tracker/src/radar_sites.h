#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace adit_tracker {

/// Where the radars stand, from /tf_static: all must stand at one site, for only there they see a target in the same
/// polar coordinates.
class RadarSites {
 public:
  /// What frame a radar's messages have; empty: it was not heard yet.
  using FrameOf = std::function<const std::string&(std::size_t radar)>;

  /// `frame` is that of positions.
  RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars, FrameOf frame_of);

  /// Looks for the site of a radar, and for the origin. False: it is not known yet, and
  /// its data should wait; it is not asked to if not `patient`: then an unknown site is counted, and taken for the
  /// first radar's.
  bool find(std::size_t radar, bool patient);

  /// Does the radar stand with the first one? Once find() has said true.
  bool usable(std::size_t radar) const { return *usable_[radar]; }
  /// The first radar's site; of the first one that is heard, when the first radar has none. Once find() has said true.
  const tws_runtime::Site& origin() const { return *origin_; }

 private:
  std::optional<tws_runtime::Site> siteOf(std::size_t radar, std::string& why) const;
  bool findOrigin(std::size_t radar, bool patient);

  tws_runtime::Bus& bus_;
  std::string frame_;
  std::vector<std::string> radars_;
  FrameOf frame_of_;
  std::vector<std::optional<bool>> usable_;
  std::optional<tws_runtime::Site> origin_;
};

}  // namespace adit_tracker
