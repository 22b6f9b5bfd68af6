#include "truth_sensor.h"

#include <cmath>

#include <tws_core/plot.h>
#include <tws_msgs/SsrPlot.h>
#include <tws_runtime/conversions.h>

#include "clutter/clutter.h"
#include "conversions.h"
#include "scenario.h"
#include "sensor_port.h"

namespace radar_sim {
namespace {

std::uint8_t toKind(TargetKind kind) {
  switch (kind) {
    case TargetKind::kAircraft:
      return tws_msgs::TruthTarget::AIRCRAFT;
    case TargetKind::kShip:
      return tws_msgs::TruthTarget::SHIP;
    case TargetKind::kClutter:
      return tws_msgs::TruthTarget::CLUTTER;
    case TargetKind::kSlowMover:
      break;
  }
  return tws_msgs::TruthTarget::SLOW_MOVER;
}

std::uint16_t codeOf(int code) {
  return code >= 0 ? static_cast<std::uint16_t>(code) : std::uint16_t{tws_msgs::SsrPlot::CODE_UNKNOWN};
}

}  // namespace

std::unique_ptr<Sensor> TruthSpec::make(const Scene& scene) const {
  return std::make_unique<TruthSensor>(*this, scene);
}

void TruthSensor::connect(SensorPort& port) { topic_ = port.advertiseAs<tws_msgs::Truth>("truth"); }

double TruthSensor::nextTime() const {
  return scene_.scenario.start_time + static_cast<double>(count_) * scene_.scenario.truth_period;
}

void TruthSensor::step() {
  const double time = nextTime();
  ++count_;
  tws_msgs::Truth truth;
  truth.header.stamp = tws_runtime::toTime(time);
  truth.header.frame_id = kMapFrame;
  for (const std::unique_ptr<Sensor>& sensor : scene_.sensors)
    if (sensor->hasSightings()) truth.radars.push_back(sensor->name());
  for (std::size_t target = 0; target < scene_.targets.size(); ++target)
    if (scene_.targets[target].trajectory->existsAt(time)) truth.targets.push_back(stateOf(target, time));
  addClutter(time, truth);
  topic_.publish(truth);
}

// Points of its outline: nothing that a tracker is asked for.
void TruthSensor::addClutter(double time, tws_msgs::Truth& truth) const {
  std::size_t first_id = scene_.targets.size();
  for (const auto& clutter : scene_.scenario.clutter_fields) {
    const auto outline = clutter->existsAt(time) ? clutter->outlineAt(time) : std::vector<Eigen::Vector2d>();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      tws_msgs::TruthTarget point;
      point.id = static_cast<std::uint32_t>(first_id + i);
      point.name = clutter->name + "/" + std::to_string(i);
      point.kind = tws_msgs::TruthTarget::CLUTTER;
      point.position.x = outline[i].x();
      point.position.y = outline[i].y();
      point.rcs = tws::Plot::kUnknown;
      point.mode_3a = tws_msgs::SsrPlot::CODE_UNKNOWN;
      point.slant_range.assign(truth.radars.size(), tws::Plot::kUnknown);
      point.azimuth = point.slant_range;
      point.detection_probability.assign(truth.radars.size(), 0.0);
      truth.targets.push_back(std::move(point));
    }
    first_id += kMostOutlinePoints;
  }
}

tws_msgs::TruthTarget TruthSensor::stateOf(std::size_t number, double time) const {
  const Target& target = scene_.targets[number];
  const TargetState state = target.trajectory->at(time);
  tws_msgs::TruthTarget message;
  message.id = static_cast<std::uint32_t>(number);
  message.name = target.name;
  message.kind = toKind(target.kind);
  message.position = toXyz<geometry_msgs::Point>(state.position);
  message.velocity = toXyz<geometry_msgs::Vector3>(state.velocity);
  const bool is_stated = !std::isnan(target.reflection.detection_probability);
  message.rcs = is_stated ? tws::Plot::kUnknown : target.reflection.rcs;
  message.mode_3a = codeOf(target.transponder.codes[index(Mode::k3A)]);
  for (const std::unique_ptr<Sensor>& sensor : scene_.sensors) {
    if (!sensor->hasSightings()) continue;
    const Sighting sighting = sensor->sightingOf(number, time);
    message.slant_range.push_back(sighting.slant_range);
    message.azimuth.push_back(sighting.azimuth);
    message.detection_probability.push_back(sighting.detection_probability);
  }
  return message;
}

}  // namespace radar_sim
