#include "array_sensor.h"

#include <stdexcept>

#include <tws_core/sine_space.h>
#include <tws_runtime/conversions.h>

#include "array_messages.h"
#include "array_reader.h"
#include "scenario.h"
#include "sensor_port.h"

namespace radar_sim {
namespace {

/// To the array's frame: x along boresight, y left, z up.
Eigen::Isometry3d mapToArray(const Scenario& scenario, const ArrayParams& array) {
  return tws::enuFromArrayRotation(array.azimuth, array.tilt).transpose() *
         mapToAntenna(scenario, array.name, array.site, array.antenna_height);
}

}  // namespace

std::unique_ptr<SensorSpec> readArraySensor(ParameterReader& reader, const Scenario& scenario) {
  auto spec = std::make_unique<ArraySpec>(readArrayRadar(reader));
  settleSite(spec->params.site, scenario, reader);
  return spec;
}

std::unique_ptr<Sensor> ArraySpec::make(const Scene& scene) const {
  return std::make_unique<ArraySensor>(*this, scene);
}

ArraySensor::ArraySensor(const ArraySpec& spec, const Scene& scene)
    : Sensor(spec),
      targets_(scene.targets),
      radar_(spec.params, mapToArray(scene.scenario, spec.params), scene.targets, faultsOf(scene.scenario, spec.name),
             scene.scenario.seed, scene.scenario.start_time),
      loop_(ros::Duration(spec.params.command_latency)) {}

void ArraySensor::connect(SensorPort& port) {
  bus_ = &port.bus();
  reports_ = port.advertise<tws_msgs::DwellReports>("dwell_reports");
  database_topic_ = port.subscribe<tws_msgs::TrackDatabase>("track_database", [this](const auto& d) { onTracks(d); });
  port.publishFrame(radar_.mapToArray());
}

bool ArraySensor::isReady() const { return loop_.isReady(tws_runtime::toTime(radar_.planTime())); }

void ArraySensor::stopWaiting() {
  if (isReady()) return;
  bus_->counter("commands late")
      .add("at " + std::to_string(radar_.planTime()) + " s " + name() + " did not get the track database on " +
           database_topic_ + " in time and continues with the tracks that it has until one comes: is its tracker up?");
  loop_.stopWaiting();
}

void ArraySensor::step() {
  applyCommands();
  const tws_msgs::DwellReports message = toDwellReports(radar_.runPeriod(), radar_.params());
  loop_.sent(message.header.stamp);
  reports_.publish(message);
}

void ArraySensor::applyCommands() {
  for (std::vector<ArrayTrack>& tracks : loop_.takeDue(tws_runtime::toTime(radar_.planTime())))
    radar_.setTracks(std::move(tracks));
}

Sighting ArraySensor::sightingOf(std::size_t target, double time) const {
  const tws::Polar polar = radar_.polarOf(targets_[target], time);
  return {polar.range, polar.azimuth, radar_.detectionProbability(target, time)};
}

void ArraySensor::onTracks(const tws_msgs::TrackDatabase& database) {
  const std::string place = " in " + database_topic_ + " at " + std::to_string(database.header.stamp.toSec());
  try {
    auto tracks = toArrayTracks(database, name(), radar_.mapToArray());
    if (!loop_.add(database.header.stamp, std::move(tracks)))
      bus_->counter("commands late").add("a track database came late" + place);
  } catch (const std::invalid_argument& error) {
    bus_->counter("refused track databases").add(error.what() + place);
  }
}

}  // namespace radar_sim
