#pragma once

#include <string>
#include <vector>

#include <tws_msgs/ElevationRequests.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "simulation.h"

namespace radar_sim {

/// The elevation searches that one rotating radar of a simulation is told to make: each list answers the mark at which
/// the antenna enters sector 61, and takes effect when it passes north. What is wrong or late of it is counted.
///
/// A tracker that has not sent a list yet, or whose list was late, is not waited for.
class ElevationLoop {
 public:
  /// `radar`: index in Simulation::radars(). Bus and simulation must outlive it, and it must stay in its place.
  ElevationLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar);
  ElevationLoop(const ElevationLoop&) = delete;
  ElevationLoop& operator=(const ElevationLoop&) = delete;

  /// Whether the step that takes this radar's antenna past north may be made. Any other step may.
  bool isReady() const;
  void stopWaiting();
  /// To be called before the step of the simulation.
  void prepareStep();
  /// A mark of some radar goes out.
  void hearMark(const SectorReport& report);

 private:
  struct Command {
    double time;  ///< [s of data time]
    std::vector<ElevationOrder> orders;
  };

  bool isNext() const;
  const RotatingRadar& radar() const { return simulation_.radars()[radar_]; }
  void hear(const tws_msgs::ElevationRequests& requests);
  std::vector<ElevationOrder> ordersOf(const tws_msgs::ElevationRequests& requests) const;
  void refuse(std::size_t count, const std::string& why) const;

  tws_runtime::Bus& bus_;
  Simulation& simulation_;
  std::size_t radar_;
  std::string topic_;
  tws_runtime::LockStep<Command> loop_;
};

}  // namespace radar_sim
