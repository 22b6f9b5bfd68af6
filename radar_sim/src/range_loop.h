#pragma once

#include <string>

#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "simulation.h"

namespace radar_sim {

/// The topics of one range radar of a simulation: its profiles go out, the commands that move its gate come in. What is
/// wrong or late of the latter is counted.
class RangeLoop {
 public:
  /// `radar`: index in Simulation::rangeRadars(). Bus and simulation must outlive it, and it must stay in its place.
  RangeLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar);
  RangeLoop(const RangeLoop&) = delete;
  RangeLoop& operator=(const RangeLoop&) = delete;

  /// Whether the step that makes this radar's profile may be made. Any other step may.
  bool isReady() const;
  void stopWaiting();
  /// To be called before the step of the simulation: the gate of a profile is the one that is due.
  void prepareStep();
  void publish(const AmplitudeProfile& profile);

 private:
  bool isNext() const;
  const RangeRadar& radar() const { return simulation_.rangeRadars()[radar_]; }

  tws_runtime::Bus& bus_;
  Simulation& simulation_;
  std::size_t radar_;
  tws_runtime::LockStep<tws_msgs::RangeGate> loop_;
  tws_runtime::Publisher<tws_msgs::RangeProfile> profiles_;
  std::string gate_topic_;
};

}  // namespace radar_sim
