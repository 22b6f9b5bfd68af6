#include "elevation/elevation_interface.h"

#include <tws_runtime/conversions.h>

namespace adit_tracker {

ElevationInterface::ElevationInterface(tws_runtime::Bus& bus, const AditParams& params)
    : radar_(params.radars[ElevationHandler::radarOf(params)].name),
      requests_(bus.advertise<tws_msgs::ElevationRequests>(radar_ + "/elevation_requests")) {}

void ElevationInterface::afterSector(Adit& adit, const SectorReport& report) {
  const auto list = handler_->afterSector(adit, report);
  if (!list) return;
  tws_msgs::ElevationRequests message;
  message.header.stamp = tws_runtime::toTime(list->time);
  message.header.frame_id = message.radar = radar_;
  for (const ElevationSearch& search : list->searches) {
    tws_msgs::ElevationRequest& request = message.requests.emplace_back();
    request.track = search.track;
    request.azimuth = search.azimuth;
    request.range = search.range;
  }
  requests_.publish(message);
}

}  // namespace adit_tracker
