#pragma once

#include <string>
#include <vector>

#include <tws_core/plot.h>
#include <tws_msgs/ElevationRequests.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "rotating_radar.h"

namespace radar_sim {

class SensorPort;

/// The elevation searches that one rotating radar is told to make: each list answers the mark at which
/// the antenna enters sector 61, and takes effect when it passes north. What is wrong or late of it is counted.
///
/// A tracker that has not sent a list yet, or whose list was late, is not waited for.
class ElevationLoop {
 public:
  /// Bus and radar must outlive it, and it must stay in its place.
  ElevationLoop(SensorPort& port, RotatingRadar& radar);
  ElevationLoop(const ElevationLoop&) = delete;
  ElevationLoop& operator=(const ElevationLoop&) = delete;

  /// Whether the radar may close its next sector: false only when that takes the antenna past north.
  bool isReady() const;
  void stopWaiting();
  /// To be called before the radar closes its next sector.
  void applyCommands();
  /// The mark that closes this sector goes out.
  void onMark(const tws::RadarSector& sector);

 private:
  struct Command {
    double time;  ///< [s of data time]
    std::vector<ElevationOrder> orders;
  };

  void onRequests(const tws_msgs::ElevationRequests& requests);
  std::vector<ElevationOrder> ordersOf(const tws_msgs::ElevationRequests& requests) const;
  void refuse(std::size_t count, const std::string& why) const;

  tws_runtime::Bus& bus_;
  RotatingRadar& radar_;
  tws_runtime::LockStep<Command> loop_;
  std::string topic_;
};

}  // namespace radar_sim
