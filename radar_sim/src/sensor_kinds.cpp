#include "sensor_kinds.h"

#include "array_sensor.h"
#include "range_sensor.h"
#include "rotating_sensor.h"
#include "secondary_sensor.h"
#include "track_feed_sensor.h"

namespace radar_sim {

const std::vector<SensorKind>& sensorKinds() {
  using Form = SensorKind::Form;
  static const std::vector<SensorKind> kinds{
      {"radars", Form::kList, readRotatingSensor},     {"secondary_radars", Form::kList, readSecondarySensor},
      {"array_radars", Form::kList, readArraySensor},  {"range_radars", Form::kList, readRangeSensor},
      {"track_feed", Form::kOne, readTrackFeedSensor},
  };
  return kinds;
}

}  // namespace radar_sim
