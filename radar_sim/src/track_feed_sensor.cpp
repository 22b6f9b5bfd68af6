#include "track_feed_sensor.h"

#include <stdexcept>
#include <string>

#include "scenario.h"
#include "sensor_port.h"
#include "track_feed_messages.h"

namespace radar_sim {
namespace {

RotatingSensor& rotatingRadar(const std::string& name, const Scene& scene) {
  for (const std::unique_ptr<Sensor>& sensor : scene.sensors) {
    auto* radar = dynamic_cast<RotatingSensor*>(sensor.get());
    if (radar != nullptr && radar->name() == name) return *radar;
  }
  throw std::invalid_argument("there is no rotating radar '" + name + "' for the track feed's clock");
}

}  // namespace

std::unique_ptr<SensorSpec> readTrackFeedSensor(ParameterReader& reader, const Scenario& scenario) {
  TrackFeedParams feed;
  std::vector<std::string> radars;
  for (const auto& sensor : scenario.sensors)
    if (dynamic_cast<const RotatingSpec*>(sensor.get()) != nullptr) radars.push_back(sensor->name);
  reader.require("clock_radar");
  reader.choice("clock_radar", feed.clock_radar, radars);
  reader.number("position_sigma_m", feed.position_sigma, 0.0, 1e4);
  reader.number("velocity_sigma_mps", feed.velocity_sigma, 0.0, 1e3);
  reader.done();
  return std::make_unique<TrackFeedSpec>(feed);
}

std::unique_ptr<Sensor> TrackFeedSpec::make(const Scene& scene) const {
  return std::make_unique<TrackFeedSensor>(*this, scene);
}

TrackFeedSensor::TrackFeedSensor(const TrackFeedSpec& spec, const Scene& scene)
    : Sensor(spec),
      targets_(scene.targets),
      sea_(scene.scenario.origin),
      clock_(rotatingRadar(spec.params.clock_radar, scene)) {
  for (const FeedKind kind : {FeedKind::kPrimary, FeedKind::kSecondary})
    feeds_.push_back({TrackFeed(kind, spec.params, clock_.mapToSite(), scene.targets, scene.scenario.seed)});
}

void TrackFeedSensor::connect(SensorPort& port) {
  for (Feed& feed : feeds_) feed.topic = port.advertiseAs<tws_msgs::Tracks>(nameOf(feed.tracks.kind()) + "/tracks");
  clock_.onSector([this](const tws::RadarSector& sector) { publish(sector); });
}

void TrackFeedSensor::publish(const tws::RadarSector& sector) {
  for (Feed& feed : feeds_) {
    tws_msgs::Tracks message = toTracks(feed.tracks, feed.tracks.tracksOf(sector), sector, targets_, sea_);
    message.sequence = feed.sequence++;
    feed.topic.publish(message);
  }
}

}  // namespace radar_sim
