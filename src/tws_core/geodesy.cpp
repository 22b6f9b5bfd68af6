#include <tws_core/geodesy.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <tws_core/angles.h>

namespace tws {
namespace {

constexpr double kEccentricitySquared = kFlattening * (2.0 - kFlattening);
constexpr double kSecondEccentricitySquared = kEccentricitySquared / (1.0 - kEccentricitySquared);

double primeVerticalRadius(double sin_latitude) {
  return kSemiMajorAxis / std::sqrt(1.0 - kEccentricitySquared * sin_latitude * sin_latitude);
}

// Bowring 1976 (Survey Review 23, 323-327): tan φ = (z + e'²·b·sin³β)/(p − e²·a·cos³β), with tan β = (1 − f)·tan φ.
double bowringLatitude(double axis_distance, double z) {
  double beta = std::atan2(z, axis_distance * (1.0 - kFlattening));
  double latitude = 0.0;
  for (int iteration = 0; iteration < 2; ++iteration) {
    const double sine = std::sin(beta), cosine = std::cos(beta);
    latitude = std::atan2(z + kSecondEccentricitySquared * kSemiMinorAxis * sine * sine * sine,
                          axis_distance - kEccentricitySquared * kSemiMajorAxis * cosine * cosine * cosine);
    beta = std::atan2((1.0 - kFlattening) * std::sin(latitude), std::cos(latitude));
  }
  return latitude;
}

void checkPlace(const Geodetic& place) {
  const bool finite = std::isfinite(place.longitude) && std::isfinite(place.altitude);
  if (finite && std::abs(place.latitude) <= kPi / 2.0) return;
  throw std::invalid_argument("LocalFrame: no place on earth: latitude " + std::to_string(place.latitude) +
                              " rad, longitude " + std::to_string(place.longitude) + " rad, altitude " +
                              std::to_string(place.altitude) + " m");
}

}  // namespace

Eigen::Vector3d ecefFromGeodetic(const Geodetic& geodetic) {
  const double sine = std::sin(geodetic.latitude);
  const double radius = primeVerticalRadius(sine);
  const double axis_distance = (radius + geodetic.altitude) * std::cos(geodetic.latitude);
  return {axis_distance * std::cos(geodetic.longitude), axis_distance * std::sin(geodetic.longitude),
          (radius * (1.0 - kEccentricitySquared) + geodetic.altitude) * sine};
}

Geodetic geodeticFromEcef(const Eigen::Vector3d& ecef) {
  const double axis_distance = std::hypot(ecef.x(), ecef.y());
  const double latitude = bowringLatitude(axis_distance, ecef.z());
  const double sine = std::sin(latitude);
  // This form of the altitude has no weak spot at the equator or the poles.
  const double altitude = axis_distance * std::cos(latitude) + ecef.z() * sine -
                          kSemiMajorAxis * std::sqrt(1.0 - kEccentricitySquared * sine * sine);
  return {latitude, wrapPi(std::atan2(ecef.y(), ecef.x())), altitude};
}

double altitudeOverSphere(const Eigen::Vector3d& enu) {
  return (enu + Eigen::Vector3d(0.0, 0.0, kMeanEarthRadius)).norm() - kMeanEarthRadius;
}

LocalFrame::LocalFrame(const Geodetic& origin) : origin_(origin) {
  checkPlace(origin);
  origin_ecef_ = ecefFromGeodetic(origin);
  const double sin_lat = std::sin(origin.latitude), cos_lat = std::cos(origin.latitude);
  const double sin_lon = std::sin(origin.longitude), cos_lon = std::cos(origin.longitude);
  rotation_.col(0) << -sin_lon, cos_lon, 0.0;
  rotation_.col(1) << -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat;
  rotation_.col(2) << cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;
}

Eigen::Vector3d LocalFrame::toEnu(const Geodetic& geodetic) const {
  return rotation_.transpose() * (ecefFromGeodetic(geodetic) - origin_ecef_);
}

Geodetic LocalFrame::toGeodetic(const Eigen::Vector3d& enu) const {
  return geodeticFromEcef(origin_ecef_ + rotation_ * enu);
}

}  // namespace tws
