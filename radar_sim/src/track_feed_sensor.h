#pragma once

#include <cstdint>
#include <vector>

#include <tws_core/plot.h>
#include <tws_core/sea_level.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/bus.h>

#include "reading.h"
#include "rotating_sensor.h"
#include "sensor.h"
#include "track_feed.h"

namespace radar_sim {

/// Primary and secondary tracks of a scenario, in place of trackers.
struct TrackFeedSpec : SensorSpec {
  explicit TrackFeedSpec(TrackFeedParams feed) : SensorSpec("track_feed"), params(std::move(feed)) {}
  bool canHave(FaultKind) const override { return false; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  TrackFeedParams params;
};

/// The scenario's map `track_feed`.
std::unique_ptr<SensorSpec> readTrackFeedSensor(ParameterReader& reader, const Scenario& scenario);

/// Publishes the fed tracks of each sector of the clock radar, before its mark.
class TrackFeedSensor : public Sensor {
 public:
  /// Throws std::invalid_argument when the clock radar is not among the sensors.
  TrackFeedSensor(const TrackFeedSpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;

 private:
  struct Feed {
    TrackFeed tracks;
    std::uint32_t sequence = 0;
    tws_runtime::Publisher<tws_msgs::Tracks> topic = {};
  };

  void publish(const tws::RadarSector& sector);

  const std::vector<Target>& targets_;
  tws::SeaLevel sea_;  // under the map
  RotatingSensor& clock_;
  std::vector<Feed> feeds_;
};

}  // namespace radar_sim
