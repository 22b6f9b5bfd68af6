#include "secondary_messages.h"

#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/track_writer.h>

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

std::uint8_t stateOf(const SecondaryUpdate& update) {
  if (update.event == SecondaryEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!update.track.firm) return tws_msgs::Track::TENTATIVE;
  return update.event == SecondaryEvent::kCoasted ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

tws_runtime::PolarMotion motionOf(const SecondaryTrack& track) {
  const Eigen::Vector2d place = track.state.mean.head<2>(), velocity = track.state.mean.tail<2>();
  const tws::PolarRates rates = tws::polarRates({place.x(), place.y(), 0.0}, {velocity.x(), velocity.y(), 0.0});
  return {place.norm(), tws::azimuthOf(place), rates.range, rates.azimuth};
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

tws_msgs::Track trackMessage(const SecondaryUpdate& update, const Site& site, const tws::SeaLevel& sea,
                             const std::string& radar) {
  const SecondaryTrack& track = update.track;
  tws_msgs::Track message = tws_runtime::blankTrack(track.uid, track.uid);
  message.state = stateOf(update);
  message.stamp = tws_runtime::toTime(track.time);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  tws_runtime::setAtHeight(message, motionOf(track), track.height.value(), site, sea);
  tws_runtime::setPlanarCovariance(message, track.state.covariance, site);
  message.detection_bits =
      update.event == SecondaryEvent::kUpdated ? std::uint16_t{tws_msgs::Track::DETECTED_BY_IFF} : std::uint16_t{0};
  message.radars = {radar};
  message.radar_updates = {message.last_update};
  message.mode_1 = track.mode_1.value();
  message.mode_2 = track.mode_2.value();
  message.mode_3a = track.mode_3a.value();
  message.aircraft_address = track.aircraft_address;
  message.callsign = track.callsign;
  return message;
}

}  // namespace track_correlator
