#include "simulation.h"

#include <algorithm>

#include "truth_sensor.h"

namespace radar_sim {

Simulation::Simulation(const Scenario& scenario) : scenario_(scenario), targets_(allTargets(scenario)) {
  add(TruthSpec());
  for (const auto& spec : scenario_.sensors) add(*spec);
}

void Simulation::add(const SensorSpec& spec) {
  sensors_.push_back(spec.make({scenario_, targets_, sensors_}));
  skipSilence(*sensors_.back());
}

Sensor& Simulation::next() const {
  const auto isEarlier = [](const auto& a, const auto& b) { return a->nextTime() < b->nextTime(); };
  return **std::min_element(sensors_.begin(), sensors_.end(), isEarlier);
}

std::optional<double> Simulation::nextTime() const {
  const double time = next().nextTime();
  return time <= scenario_.endTime() ? std::optional<double>(time) : std::nullopt;
}

bool Simulation::isReady() const { return !nextTime() || next().isReady(); }

void Simulation::stopWaiting() {
  if (nextTime()) next().stopWaiting();
}

void Simulation::step() {
  Sensor& sensor = next();
  sensor.step();
  skipSilence(sensor);
}

// The antenna goes on turning and the sectors are counted, but nothing is published of them.
void Simulation::skipSilence(Sensor& sensor) const {
  while (sensor.nextTime() <= scenario_.endTime() && sensor.isSilentAt(sensor.nextTime())) sensor.skip();
}

}  // namespace radar_sim
