#pragma once

#include <tf2_msgs/TFMessage.h>
#include <tws_core/plot.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/north_sectors.h"
#include "core/own_ship.h"

namespace adit_tracker {

/// Where own ship comes from.
struct OwnShipParams {
  std::string frame;  // its frame on /tf; empty: the radars stand
  double wait = 1.0;  // for a pose, in data time [s]
};

/// Where the radars' ship is, from /tf. A sector waits for the pose at its end, so that what comes out does not depend
/// on how the two interleave; after `wait` it goes on with what is known by then (see OwnShip), and is counted. One for
/// which own ship's place is not known is left out and counted.
class OwnShipGate {
 public:
  /// Sectors that wait, at most, for the place of a radar on the ship: two turns. Then it is counted, and taken for
  /// that of the ship's frame.
  static constexpr std::size_t kMostWaiting = 128;
  using Use = std::function<void(std::size_t radar, tws::RadarSector sector, const Passage& ship)>;

  /// `frame` is that of positions. `use` gets the sectors against north, plots as measured.
  OwnShipGate(tws_runtime::Bus& bus, const std::string& frame, const OwnShipParams& params,
              const std::vector<std::string>& radars, Use use);

  bool isOn() const { return !params_.frame.empty(); }
  /// `radar_frame`: of the radar's messages. A frame that hangs on the ship's by /tf_static, or the ship's itself.
  void add(std::size_t radar, const std::string& radar_frame, tws::RadarSector sector);
  /// A new run, at that time [s]: forgets what waits, and poses of the old run.
  void beginNewRun(double time);
  std::size_t waiting() const { return waiting_.size(); }

 private:
  struct Item {
    std::size_t radar;
    std::string radar_frame;
    tws::RadarSector sector;
  };
  void onTransforms(const tf2_msgs::TFMessage& message);
  void take(const geometry_msgs::TransformStamped& transform);
  void release();
  bool isDue(const Item& item) const;
  bool findMount(const Item& item);
  void handOver(Item& item);
  std::optional<Passage> passageOf(std::size_t radar, const tws::RadarSector& sector) const;
  void give(std::size_t radar, tws::RadarSector sector);
  void lose(std::size_t radar, const tws::RadarSector& sector);

  tws_runtime::Bus& bus_;
  std::string frame_;
  OwnShipParams params_;
  std::vector<std::string> radars_;
  Use use_;
  OwnShip ship_;
  std::vector<std::optional<tws_runtime::Site>> mounts_;  // where each radar is on the ship
  std::vector<NorthSectors> north_;
  std::deque<Item> waiting_;
  double newest_ = 0.0;  // time up to which sectors have come [s]
};

}  // namespace adit_tracker
