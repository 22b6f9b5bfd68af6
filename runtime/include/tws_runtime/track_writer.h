#pragma once

#include <tws_core/kalman.h>
#include <tws_core/sea_level.h>
#include <tws_msgs/Track.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>
#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>

namespace tws_runtime {

// How every tracker fills tws_msgs/Track. `position.z` is up in header.frame_id, `height` above mean sea level; both
// NaN when unknown. They differ by the earth's curve and by the altitude of the frame's origin: see tws::SeaLevel.

/// Reads the parameter `origin: {latitude_deg, longitude_deg, altitude_m}`: where the frame of positions (`map`) lies,
/// altitude above the sea. All three or none; without it the frame touches a spherical earth at sea level. Whoever
/// starts nodes on a scenario sets it from the scenario's `origin`.
tws::SeaLevel readOrigin(ParameterReader& reader);

/// The same place; nothing: the parameter is not there.
std::optional<tws::Geodetic> readPlace(ParameterReader& reader);

/// Sets latitude, longitude and altitude from the position in a map frame. Where z is unknown, `height` [m] above the
/// ellipsoid is what the position was laid down with, and the altitude stays unknown.
void setGeodetic(tws_msgs::Track& track, const tws::LocalFrame& map, double height = 0.0);

/// A track of which nothing else is known: NaN and CODE_UNKNOWN where the message has them.
tws_msgs::Track blankTrack(std::uint32_t number, std::uint32_t uid);

/// How a track moves as its radar sees it: slant range [m], azimuth [rad] in [0, 2π), and their rates [m/s], [rad/s].
struct PolarMotion {
  double range, azimuth, range_rate, azimuth_rate;
};
void setPolar(tws_msgs::Track& track, const PolarMotion& motion);

/// Place [m] and velocity [m/s] on the ground around a site, x east and y north there. Sets position, velocity, speed
/// and course; leaves z as it is.
void setPlanar(tws_msgs::Track& track, const Eigen::Vector2d& place, const Eigen::Vector2d& velocity, const Site& site);

/// Of a 2-D radar that knows a height above the sea [m] besides: sets the polar state, elevation, position, z, velocity
/// and height. With a height of NaN, or one that no point at this range has, the slant range is laid on the ground.
void setAtHeight(tws_msgs::Track& track, const PolarMotion& motion, double height, const Site& site,
                 const tws::SeaLevel& sea);

/// The covariance of (x, y, vx, vy) on the ground around a site.
void setPlanarCovariance(tws_msgs::Track& track, const Eigen::Matrix4d& covariance, const Site& site);

/// A state in three dimensions in the frame of positions, seen from a radar there. Sets all of polar state, elevation,
/// position, velocity, covariance and height.
void setSpatial(tws_msgs::Track& track, const tws::SpatialState& state, const Eigen::Vector3d& radar,
                const tws::SeaLevel& sea);

/// The topic of a tracker's tracks: numbers its messages.
class TrackWriter {
 public:
  /// `frame`: of positions.
  TrackWriter(Bus& bus, const std::string& topic, std::string frame)
      : name_(bus.name()), frame_(std::move(frame)), topic_(bus.advertise<tws_msgs::Tracks>(topic)) {}

  /// An empty message; `radar` empty: not by sector.
  tws_msgs::Tracks message(ros::Time stamp, const std::string& radar) const;
  /// One of a sector of a rotating radar that its beam entered at `enter_time` [s].
  tws_msgs::Tracks message(double enter_time, const std::string& radar, std::int64_t running_sector) const;
  /// Numbers it and sends it.
  void publish(tws_msgs::Tracks& message);

 private:
  std::string name_;
  std::string frame_;
  Publisher<tws_msgs::Tracks> topic_;
  std::uint32_t sequence_ = 0;
};

}  // namespace tws_runtime
