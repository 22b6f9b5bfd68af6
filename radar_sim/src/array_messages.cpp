#include "array_messages.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <tws_runtime/conversions.h>

#include "conversions.h"

namespace radar_sim {
namespace {

tws_msgs::RuvMeasurement toMeasurement(const ArrayMeasurement& measurement) {
  tws_msgs::RuvMeasurement message;
  message.range = measurement.place.range;
  message.u = measurement.place.u;
  message.v = measurement.place.v;
  for (int i = 0; i < 9; ++i) message.covariance[static_cast<std::size_t>(i)] = measurement.covariance(i / 3, i % 3);
  message.snr = measurement.snr;
  message.rcs = measurement.rcs;
  return message;
}

tws_msgs::DwellReport toDwellReport(const ArrayDwell& dwell, const ArrayParams& array) {
  tws_msgs::DwellReport message;
  message.stamp = tws_runtime::toTime(dwell.time);
  message.dwell = dwell.number;
  message.is_track_dwell = dwell.plan.is_track_dwell;
  message.dwell_group_indices = dwell.plan.expected;
  message.group = dwell.plan.group;
  message.expected_group_dwells = dwell.plan.group_dwells;
  message.u = dwell.plan.beam.u;
  message.v = dwell.plan.beam.v;
  message.beamwidth_u = array.beamwidth_u;
  message.beamwidth_v = array.beamwidth_v;
  message.range_min = array.min_range;
  message.range_max = array.max_range;
  for (const ArrayMeasurement& measurement : dwell.measurements)
    message.measurements.push_back(toMeasurement(measurement));
  return message;
}

template <class M>
Eigen::Vector3d vectorOf(const M& message, const std::string& what) {
  Eigen::Vector3d vector(message.x, message.y, message.z);
  if (!vector.allFinite()) throw std::invalid_argument(what + " is not finite");
  return vector;
}

ArrayTrack toArrayTrack(const tws_msgs::TrackDatabaseEntry& entry, const Eigen::Isometry3d& map_from_frame) {
  const std::string name = "track " + std::to_string(entry.number);
  ArrayTrack track;
  track.number = entry.number;
  track.time = tws_runtime::toSeconds(entry.stamp);
  track.last_update = tws_runtime::toSeconds(entry.last_update);
  track.position = map_from_frame * vectorOf(entry.position, "position of " + name);
  track.velocity = map_from_frame.linear() * vectorOf(entry.velocity, "velocity of " + name);
  track.priority = entry.priority;
  track.revisit = entry.revisit_interval;
  if (!std::isnan(track.revisit) && !(track.revisit > 0.0))
    throw std::invalid_argument("revisit_interval of " + name + " is " + std::to_string(track.revisit));
  return track;
}

}  // namespace

tws_msgs::DwellReports toDwellReports(const ResourcePeriod& period, const ArrayParams& array) {
  tws_msgs::DwellReports message;
  message.header.stamp = tws_runtime::toTime(period.end);
  message.header.frame_id = array.name;
  message.radar = array.name;
  message.resource_period = period.number;
  message.duration = array.resource_period;
  if (period.next_expected_dwell) message.expected_next_dwell = tws_runtime::toTime(*period.next_expected_dwell);
  for (const ArrayDwell& dwell : period.dwells) message.dwells.push_back(toDwellReport(dwell, array));
  return message;
}

std::vector<ArrayTrack> toArrayTracks(const tws_msgs::TrackDatabase& database, const std::string& array,
                                      const Eigen::Isometry3d& map_to_array) {
  if (database.radar != array) throw std::invalid_argument("radar is '" + database.radar + "', not '" + array + "'");
  const std::string& frame = database.header.frame_id;
  if (frame != kMapFrame && frame != array)
    throw std::invalid_argument("frame_id is '" + frame + "', neither '" + kMapFrame + "' nor '" + array + "'");
  const Eigen::Isometry3d map_from_frame = frame == array ? map_to_array.inverse() : Eigen::Isometry3d::Identity();
  std::vector<ArrayTrack> tracks;
  for (const tws_msgs::TrackDatabaseEntry& entry : database.tracks)
    tracks.push_back(toArrayTrack(entry, map_from_frame));
  return tracks;
}

}  // namespace radar_sim
