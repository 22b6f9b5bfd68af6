#include <radar_sim/radar_sim_node.h>

#include <limits>
#include <stdexcept>
#include <string>

#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>

#include "scenario.h"
#include "sensor_kinds.h"
#include "sensor_port.h"
#include "simulation.h"

namespace radar_sim {
namespace {

Scenario readParameters(tws_runtime::Bus& bus, const std::vector<SensorKind>& kinds) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  std::string file;
  long seed = 0;
  double duration = 0.0;
  reader.require("scenario");
  reader.text("scenario", file);
  reader.integer("seed", seed, 0, std::numeric_limits<long>::max());
  reader.number("duration", duration, 1.0, 1e6);
  reader.done();
  ScenarioOverrides overrides;
  if (reader.has("seed")) overrides.seed = static_cast<std::uint64_t>(seed);
  if (reader.has("duration")) overrides.duration = duration;
  return loadScenario(file, overrides, kinds);
}

std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const std::string& file) {
  try {
    return std::make_unique<Simulation>(scenario);
  } catch (const std::invalid_argument& error) {
    throw tws_runtime::ParameterError(file + ": " + error.what());
  }
}

}  // namespace

RadarSimNode::RadarSimNode(tws_runtime::Bus& bus) : RadarSimNode(bus, sensorKinds()) {}

RadarSimNode::RadarSimNode(tws_runtime::Bus& bus, const std::vector<SensorKind>& kinds)
    : scenario_(std::make_unique<Scenario>(readParameters(bus, kinds))),
      simulation_(makeSimulation(*scenario_, bus.parameters()["scenario"].as<std::string>())),
      topics_(connect(simulation_->sensors(), bus)) {}

RadarSimNode::~RadarSimNode() = default;

std::optional<ros::Time> RadarSimNode::nextTime() const {
  const std::optional<double> time = simulation_->nextTime();
  return time ? std::optional<ros::Time>(tws_runtime::toTime(*time)) : std::nullopt;
}

std::optional<ros::Time> RadarSimNode::endTime() const { return tws_runtime::toTime(scenario_->endTime()); }

void RadarSimNode::step() { simulation_->step(); }

bool RadarSimNode::isReady() const { return simulation_->isReady(); }

void RadarSimNode::stopWaiting() { simulation_->stopWaiting(); }

const tws::Geodetic& RadarSimNode::origin() const { return scenario_->origin; }

double RadarSimNode::duration() const { return scenario_->duration; }

YAML::Node RadarSimNode::trackers() const { return scenario_->trackers; }

}  // namespace radar_sim
