#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scenario.h"
#include "sensor.h"
#include "target.h"

namespace radar_sim {

/// Runs a scenario: what happens next, in order of time. At equal times truth comes first, then the sensors in the
/// scenario's order. The same scenario with the same commands gives the same messages, bit for bit.
class Simulation {
 public:
  /// Throws std::invalid_argument when the scenario contradicts itself.
  explicit Simulation(const Scenario& scenario);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const std::vector<Target>& targets() const { return targets_; }
  /// The truth, then those of the scenario.
  const std::vector<std::unique_ptr<Sensor>>& sensors() const { return sensors_; }

  /// Time of what the next step() publishes [s of data time]; nothing: the scenario has ended.
  std::optional<double> nextTime() const;
  /// Whether all commands have come by which it goes.
  bool isReady() const;
  /// It goes without them.
  void stopWaiting();
  /// The sensors must be connected (sensor_port.h). Must not be called after the end.
  void step();

 private:
  void add(const SensorSpec& spec);
  /// Lets the sensor go on to the end of an outage.
  void skipSilence(Sensor& sensor) const;
  /// The sensor that reports first, of equal ones the first.
  Sensor& next() const;

  Scenario scenario_;
  std::vector<Target> targets_;
  std::vector<std::unique_ptr<Sensor>> sensors_;
};

}  // namespace radar_sim
