#include "secondary_messages.h"

#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_runtime/conversions.h>

namespace track_correlator {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint16_t kGreatestCode = 07777;

CodeReply codeOf(std::uint16_t code, bool garbled, std::vector<std::string>& faults) {
  if (code == tws_msgs::SsrPlot::CODE_UNKNOWN) return {};
  if (code <= kGreatestCode) return {code, garbled};
  faults.push_back("code is " + std::to_string(code));
  return {};
}

double heightOf(double height, std::vector<std::string>& faults) {
  if (std::isnan(height) || (height > -1000.0 && height < 50e3)) return height;
  faults.push_back("height is " + std::to_string(height));
  return kUnknown;
}

SecondaryPlot plotOf(const tws_msgs::SsrPlot& message, std::vector<std::string>& faults) {
  using tws_msgs::SsrPlot;
  SecondaryPlot plot;
  plot.time = tws_runtime::toSeconds(message.stamp);
  plot.range = message.range;
  plot.azimuth = message.azimuth;
  plot.height = heightOf(message.height, faults);
  plot.height_garbled = (message.garbled & SsrPlot::GARBLED_MODE_C) != 0;
  plot.mode_1 = codeOf(message.mode_1, (message.garbled & SsrPlot::GARBLED_MODE_1) != 0, faults);
  plot.mode_2 = codeOf(message.mode_2, (message.garbled & SsrPlot::GARBLED_MODE_2) != 0, faults);
  plot.mode_3a = codeOf(message.mode_3a, (message.garbled & SsrPlot::GARBLED_MODE_3A) != 0, faults);
  plot.aircraft_address = message.aircraft_address;
  plot.callsign = message.callsign;
  return plot;
}

std::uint8_t stateOf(const SecondaryWord& word) {
  if (word.event == SecondaryEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!word.track.firm) return tws_msgs::Track::TENTATIVE;
  return word.event == SecondaryEvent::kCoasted ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

void setMotion(tws_msgs::Track& message, const SecondaryTrack& track, const Site& site) {
  const Eigen::Vector2d place = track.state.mean.head<2>(), velocity = track.state.mean.tail<2>();
  const tws::PolarRates rates = tws::polarRates({place.x(), place.y(), 0.0}, {velocity.x(), velocity.y(), 0.0});
  message.range = place.norm();
  message.azimuth = tws::azimuthOf(place);
  message.range_rate = rates.range;
  message.azimuth_rate = rates.azimuth;

  const double height = track.height.value();
  const bool high = !std::isnan(height) && message.range > std::abs(height - site.z);
  const double ground = high ? tws::groundRange(message.range, height - site.z) : message.range;
  const Eigen::Vector2d at = tws::planarFromPolar(ground, message.azimuth);
  const Eigen::Vector2d v =
      tws::planarVelocity(ground, message.azimuth, rates.range * message.range / ground, rates.azimuth);
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  message.elevation = high ? std::asin((height - site.z) / message.range) : kUnknown;
  message.position.x = site.x + c * at.x() - s * at.y();
  message.position.y = site.y + s * at.x() + c * at.y();
  message.position.z = high ? height : kUnknown;
  message.velocity.x = c * v.x() - s * v.y();
  message.velocity.y = s * v.x() + c * v.y();
  message.velocity.z = kUnknown;
  message.speed = v.norm();
  message.course = message.speed > 0.0 ? tws::azimuthOf({message.velocity.x, message.velocity.y}) : kUnknown;
}

void setCovariance(tws_msgs::Track& message, const Eigen::Matrix4d& own, const Site& site) {
  Eigen::Matrix2d turn;
  turn << std::cos(site.turn), -std::sin(site.turn), std::sin(site.turn), std::cos(site.turn);
  Eigen::Matrix4d both = Eigen::Matrix4d::Zero();
  both.topLeftCorner<2, 2>() = both.bottomRightCorner<2, 2>() = turn;
  const Eigen::Matrix4d turned = both * own * both.transpose();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) message.covariance.push_back(turned(row, column));
}

}  // namespace

SecondarySector sectorOf(const tws_msgs::SsrPlots& message, std::vector<std::string>& faults) {
  SecondarySector sector{message.running_sector, tws_runtime::toSeconds(message.header.stamp), {}};
  for (const tws_msgs::SsrPlot& plot : message.plots) {
    const std::string fault = tws_runtime::faultOf(plot, sector.leave_time);
    if (fault.empty())
      sector.plots.push_back(plotOf(plot, faults));
    else
      faults.push_back(fault);
  }
  return sector;
}

tws_msgs::Track trackMessage(const SecondaryWord& word, const Site& site, const std::string& radar) {
  const SecondaryTrack& track = word.track;
  tws_msgs::Track message;
  message.number = message.uid = track.uid;
  message.state = stateOf(word);
  message.stamp = tws_runtime::toTime(track.time);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  setMotion(message, track, site);
  setCovariance(message, track.state.covariance, site);
  message.detection_bits =
      word.event == SecondaryEvent::kUpdated ? std::uint16_t{tws_msgs::Track::DETECTED_BY_IFF} : std::uint16_t{0};
  message.radars = {radar};
  message.radar_updates = {message.last_update};
  message.mode_1 = track.mode_1.value();
  message.mode_2 = track.mode_2.value();
  message.mode_3a = track.mode_3a.value();
  message.aircraft_address = track.aircraft_address;
  message.callsign = track.callsign;
  message.height = track.height.value();
  message.height_sigma = kUnknown;
  return message;
}

}  // namespace track_correlator
