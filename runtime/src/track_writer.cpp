#include <tws_runtime/track_writer.h>

#include <tws_core/earth_plane.h>
#include <tws_core/geometry.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include <cmath>
#include <limits>

namespace tws_runtime {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Eigen::Vector2d turned(const Eigen::Vector2d& v, double c, double s) {
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// How far up a track is, relative to its radar [m]; NaN: unknown.
double upOf(const PolarMotion& motion, double height, const Site& site, const tws::SeaLevel& sea) {
  const Eigen::Vector2d direction = tws::planarFromPolar(1.0, motion.azimuth);
  const auto z = sea.upAtRange({site.x, site.y, site.z}, turned(direction, std::cos(site.turn), std::sin(site.turn)),
                               motion.range, height);
  return z ? *z - site.z : kUnknown;
}

}  // namespace

tws::SeaLevel readOrigin(ParameterReader& reader) {
  const std::optional<tws::Geodetic> origin = readPlace(reader);
  return origin ? tws::SeaLevel(*origin) : tws::SeaLevel();
}

std::optional<tws::Geodetic> readPlace(ParameterReader& reader) {
  if (!reader.has("origin")) return std::nullopt;
  ParameterReader own = reader.map("origin");
  tws::Geodetic origin;
  for (const char* key : {"latitude_deg", "longitude_deg", "altitude_m"}) own.require(key);
  scaledNumber(own, "latitude_deg", origin.latitude, tws::radians(1.0), -90.0, 90.0);
  scaledNumber(own, "longitude_deg", origin.longitude, tws::radians(1.0), -180.0, 180.0);
  own.number("altitude_m", origin.altitude, -1000.0, 10000.0);
  own.done();
  return origin;
}

void setGeodetic(tws_msgs::Track& track, const tws::LocalFrame& map, double height) {
  const bool flat = std::isnan(track.position.z);
  const double x = track.position.x, y = track.position.y;
  const double z = flat ? tws::EarthPlane(map.origin()).zAt(x, y, height) : track.position.z;
  const tws::Geodetic place = map.toGeodetic({x, y, z});
  track.latitude = place.latitude;
  track.longitude = place.longitude;
  if (!flat) track.altitude = place.altitude;
}

tws_msgs::Track blankTrack(std::uint32_t number, std::uint32_t uid) {
  tws_msgs::Track track;
  track.number = number;
  track.uid = uid;
  track.elevation = track.position.z = track.velocity.z = track.course = kUnknown;
  track.mode_1 = track.mode_2 = track.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  track.height = track.height_sigma = track.plot_range = track.plot_azimuth = kUnknown;
  track.latitude = track.longitude = track.altitude = kUnknown;
  track.existence = std::numeric_limits<float>::quiet_NaN();
  return track;
}

void setPolar(tws_msgs::Track& track, const PolarMotion& motion) {
  track.range = motion.range;
  track.azimuth = motion.azimuth;
  track.range_rate = motion.range_rate;
  track.azimuth_rate = motion.azimuth_rate;
}

void setPlanar(tws_msgs::Track& track, const Eigen::Vector2d& place, const Eigen::Vector2d& velocity,
               const Site& site) {
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  const Eigen::Vector2d v = turned(velocity, c, s);
  track.position.x = site.x + c * place.x() - s * place.y();
  track.position.y = site.y + s * place.x() + c * place.y();
  track.velocity.x = v.x();
  track.velocity.y = v.y();
  track.velocity.z = kUnknown;
  track.speed = velocity.norm();
  track.course = track.speed > 0.0 ? tws::azimuthOf(v) : kUnknown;
}

void setAtHeight(tws_msgs::Track& track, const PolarMotion& motion, double height, const Site& site,
                 const tws::SeaLevel& sea) {
  setPolar(track, motion);
  track.height = height;
  const double up = upOf(motion, height, site, sea);
  const bool is_known = !std::isnan(up);
  const double ground = is_known ? tws::groundRange(motion.range, up) : motion.range;
  setPlanar(track, tws::planarFromPolar(ground, motion.azimuth),
            tws::planarVelocity(ground, motion.azimuth, motion.range_rate * motion.range / ground, motion.azimuth_rate),
            site);
  track.elevation = is_known ? std::asin(up / motion.range) : kUnknown;
  track.position.z = is_known ? site.z + up : kUnknown;
}

void setPlanarCovariance(tws_msgs::Track& track, const Eigen::Matrix4d& covariance, const Site& site) {
  Eigen::Matrix2d turn;
  turn << std::cos(site.turn), -std::sin(site.turn), std::sin(site.turn), std::cos(site.turn);
  Eigen::Matrix4d both = Eigen::Matrix4d::Zero();
  both.topLeftCorner<2, 2>() = both.bottomRightCorner<2, 2>() = turn;
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> turned = both * covariance * both.transpose();
  track.covariance.assign(turned.data(), turned.data() + turned.size());
}

void setSpatial(tws_msgs::Track& track, const tws::SpatialState& state, const Eigen::Vector3d& radar,
                const tws::SeaLevel& sea) {
  const Eigen::Vector3d place = state.mean.head<3>(), velocity = state.mean.tail<3>();
  const tws::Polar polar = tws::polarFromEnu(place - radar);
  const tws::PolarRates rates = tws::polarRates(place - radar, velocity);
  setPolar(track, {polar.range, polar.azimuth, rates.range, rates.azimuth});
  track.elevation = polar.elevation;
  track.position.x = place.x();
  track.position.y = place.y();
  track.position.z = place.z();
  track.height = sea.heightOf(place);
  track.velocity.x = velocity.x();
  track.velocity.y = velocity.y();
  track.velocity.z = velocity.z();
  track.speed = velocity.head<2>().norm();
  track.course = track.speed > 0.0 ? tws::azimuthOf(velocity.head<2>()) : kUnknown;
  track.covariance.clear();
  for (const int row : {0, 1, 3, 4})
    for (const int column : {0, 1, 3, 4}) track.covariance.push_back(state.covariance(row, column));
}

tws_msgs::Tracks TrackWriter::message(ros::Time stamp, const std::string& radar) const {
  tws_msgs::Tracks message;
  message.header.stamp = stamp;
  message.header.frame_id = frame_;
  message.tracker = name_;
  message.radar = radar;
  return message;
}

tws_msgs::Tracks TrackWriter::message(double enter_time, const std::string& radar, std::int64_t running_sector) const {
  tws_msgs::Tracks message = this->message(toTime(enter_time), radar);
  message.running_sector = static_cast<std::uint32_t>(running_sector);
  message.sector = static_cast<std::uint8_t>(running_sector % tws::kSectors);
  return message;
}

void TrackWriter::publish(tws_msgs::Tracks& message) {
  message.sequence = sequence_++;
  topic_.publish(message);
}

}  // namespace tws_runtime
