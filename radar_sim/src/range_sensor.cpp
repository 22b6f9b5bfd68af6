#include "range_sensor.h"

#include <algorithm>

#include <tws_runtime/conversions.h>

#include "range_reader.h"
#include "scenario.h"
#include "sensor_port.h"

namespace radar_sim {
namespace {

void refuseUnknownTarget(const std::string& target, const Scenario& scenario, const ParameterReader& reader) {
  const auto isIt = [&](const Target& known) { return known.name == target; };
  if (std::none_of(scenario.targets.begin(), scenario.targets.end(), isIt))
    reader.fail("target", "there is no target '" + target + "' in the list targets");
}

tws_msgs::RangeProfile toRangeProfile(const AmplitudeProfile& profile, const RangeRadarParams& radar) {
  tws_msgs::RangeProfile message;
  message.header.stamp = tws_runtime::toTime(profile.time);
  message.header.frame_id = message.radar = radar.name;
  message.profile = profile.number;
  message.range_min = profile.range_min;
  message.bin_size = radar.bin_size;
  message.azimuth = profile.azimuth;
  message.bins = static_cast<std::uint32_t>(profile.amplitude.size());
  message.amplitude = profile.amplitude;
  return message;
}

}  // namespace

std::unique_ptr<SensorSpec> readRangeSensor(ParameterReader& reader, const Scenario& scenario) {
  auto spec = std::make_unique<RangeSpec>(readRangeRadar(reader));
  settleSite(spec->params.site, scenario, reader);
  refuseUnknownTarget(spec->params.target, scenario, reader);
  return spec;
}

std::unique_ptr<Sensor> RangeSpec::make(const Scene& scene) const {
  return std::make_unique<RangeSensor>(*this, scene);
}

RangeSensor::RangeSensor(const RangeSpec& spec, const Scene& scene)
    : MastSensor(spec, scene), loop_(ros::Duration(spec.params.latency)) {}

void RangeSensor::connect(SensorPort& port) {
  bus_ = &port.bus();
  profiles_ = port.advertise<tws_msgs::RangeProfile>("range_profile");
  gate_topic_ = port.subscribe<tws_msgs::RangeGate>("range_gate", [this](const auto& gate) { onGate(gate); });
  port.publishFrame(mapToSite());
}

bool RangeSensor::isReady() const { return loop_.isReady(tws_runtime::toTime(radar().nextProfile())); }

void RangeSensor::stopWaiting() {
  if (isReady()) return;
  bus_->counter("commands late")
      .add("at " + std::to_string(radar().nextProfile()) + " s " + name() + " did not get a range gate on " +
           gate_topic_ + " in time and leaves its gate where it is until one comes: is its tracker up?");
  loop_.stopWaiting();
}

void RangeSensor::step() {
  applyCommands();
  const tws_msgs::RangeProfile message = toRangeProfile(radar().takeProfile(), radar().params());
  loop_.sent(message.header.stamp);
  profiles_.publish(message);
}

void RangeSensor::applyCommands() {
  for (const tws_msgs::RangeGate& gate : loop_.takeDue(tws_runtime::toTime(radar().nextProfile()))) {
    if (radar().setGate({gate.range_min, gate.range_max})) continue;
    bus_->counter("refused range gates")
        .add("from " + std::to_string(gate.range_min) + " m to " + std::to_string(gate.range_max) + " m in " +
             gate_topic_ + " at " + std::to_string(gate.header.stamp.toSec()));
  }
}

void RangeSensor::onGate(const tws_msgs::RangeGate& gate) {
  if (loop_.add(gate.header.stamp, gate)) return;
  bus_->counter("commands late")
      .add("a range gate came late in " + gate_topic_ + " at " + std::to_string(gate.header.stamp.toSec()));
}

}  // namespace radar_sim
