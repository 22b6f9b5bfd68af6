#pragma once

#include <string>
#include <vector>

#include <tws_msgs/DwellReports.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "simulation.h"

namespace radar_sim {

/// The topics of one array radar of a simulation: its dwell reports go out, the track database that its dwells are
/// planned by comes in. What is wrong or late of the latter is counted.
class ArrayLoop {
 public:
  /// `radar`: index in Simulation::arrayRadars(). Bus and simulation must outlive it, and it must stay in its place.
  ArrayLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar);
  ArrayLoop(const ArrayLoop&) = delete;
  ArrayLoop& operator=(const ArrayLoop&) = delete;

  /// Whether the step that ends this array's resource period may be made. Any other step may.
  bool isReady() const;
  void stopWaiting();
  /// To be called before the step of the simulation: the period is planned by what is due.
  void prepareStep();
  void publish(const ResourcePeriod& period);

 private:
  bool isNext() const;
  const ArrayRadar& radar() const { return simulation_.arrayRadars()[radar_]; }
  void hear(const tws_msgs::TrackDatabase& database);

  tws_runtime::Bus& bus_;
  Simulation& simulation_;
  std::size_t radar_;
  tws_runtime::LockStep<std::vector<ArrayTrack>> loop_;
  tws_runtime::Publisher<tws_msgs::DwellReports> reports_;
  std::string database_topic_;
};

}  // namespace radar_sim
