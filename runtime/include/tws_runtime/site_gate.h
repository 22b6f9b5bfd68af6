#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>
#include <Eigen/Geometry>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tws_runtime {

/// Holds what waits for the site transform of a radar on /tf_static, so that the output depends neither on when that
/// comes nor on which radar is first.
///
/// Of several radars all goes on in the order in which it came, once every radar that waits has its site. When more
/// than so many items wait, the sites that are still missing are given up, once for each radar: counted as "unknown
/// sites", with the reason.
class SiteGate {
 public:
  /// `frame`: of positions. `most_waiting`: items, at most.
  SiteGate(Bus& bus, std::string frame, std::size_t most_waiting, std::size_t radars = 1)
      : bus_(bus), frame_(std::move(frame)), most_waiting_(most_waiting), radars_(radars) {}

  /// Calls `use` with the item as soon as the radar's site is known or given up: now, or, with a copy, from a later
  /// add(). `radar_frame` is that of its message; once the site is known, another one changes nothing.
  template <class T, class Use>
  void add(const std::string& radar_frame, T&& item, Use use, std::size_t radar = 0) {
    if (waiting_.empty() && find(radar, radar_frame)) return use(item);
    wait({radar, radar_frame, [item = std::forward<T>(item), use]() mutable { use(item); }});
  }
  /// Looks for the site of a radar without an item that waits. True: it is known or given up.
  bool find(std::size_t radar, const std::string& radar_frame);

  /// Known or given up.
  bool isDecided(std::size_t radar = 0) const { return radars_[radar].decided; }
  /// Where it stands; nothing: not known, or given up.
  const std::optional<Site>& site(std::size_t radar = 0) const { return radars_[radar].site; }
  /// The same as what turns places in the radar's frame into places in the frame of positions.
  const std::optional<Eigen::Isometry3d>& pose(std::size_t radar = 0) const { return radars_[radar].pose; }

  std::size_t waiting() const { return waiting_.size(); }
  /// A new run: forgets what waits. Sites stay.
  void clear() { waiting_.clear(); }

 private:
  struct Radar {
    std::optional<Site> site;
    std::optional<Eigen::Isometry3d> pose;
    bool decided = false;
  };
  struct Item {
    std::size_t radar;
    std::string radar_frame;
    std::function<void()> use;
  };
  void wait(Item item);
  bool find(std::size_t radar, const std::string& radar_frame, bool patient);

  Bus& bus_;
  std::string frame_;
  std::size_t most_waiting_;
  std::vector<Radar> radars_;
  std::deque<Item> waiting_;
};

}  // namespace tws_runtime
