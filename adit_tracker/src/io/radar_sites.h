#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/site_frame.h>

namespace adit_tracker {

/// Where the radars stand, from /tf_static.
class RadarSites {
 public:
  /// What frame a radar's messages have; empty: it was not heard yet.
  using FrameOf = std::function<const std::string&(std::size_t radar)>;

  /// `frame` is that of positions. `joins`: may radars stand at other sites than the first one? Else these are left
  /// out.
  RadarSites(tws_runtime::Bus& bus, const std::string& frame, const std::vector<std::string>& radars, bool joins,
             FrameOf frame_of);

  /// Looks for the site of a radar, and for the origin. False: it is not known yet, and
  /// its data should wait; it is not asked to if not `patient`: then an unknown site is counted, and taken for the
  /// first radar's.
  bool find(std::size_t radar, bool patient);

  /// Is the radar to take part? Once find() has said true.
  bool usable(std::size_t radar) const { return usable_[radar]; }
  /// Where it stands on the plane of the origin. Once find() has said true.
  const tws::SiteFrame& frame(std::size_t radar) const { return *frames_[radar]; }
  /// Any place as it lies on that plane. Once find() has said true.
  tws::SiteFrame onPlane(const tws_runtime::Site& site) const;
  /// The first radar's site; of the first one that is heard, when the first radar has none. Once find() has said true.
  const tws_runtime::Site& origin() const { return *origin_; }

 private:
  std::optional<tws_runtime::Site> siteOf(std::size_t radar, std::string& why) const;
  bool findOrigin(std::size_t radar, bool patient);

  tws_runtime::Bus& bus_;
  std::string frame_;
  std::vector<std::string> radars_;
  bool joins_;
  FrameOf frame_of_;
  std::vector<std::optional<tws::SiteFrame>> frames_;
  std::vector<bool> usable_;
  std::optional<tws_runtime::Site> origin_;
};

}  // namespace adit_tracker
