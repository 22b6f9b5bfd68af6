#include "elevation_loop.h"

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>

#include "sensor_port.h"

namespace radar_sim {
namespace {

constexpr std::int64_t kListSector = 61;  // entered when the list is asked for

bool isGood(const tws_msgs::ElevationRequest& request) {
  return request.azimuth >= 0.0 && request.azimuth < tws::kTwoPi && request.range > 0.0 && std::isfinite(request.range);
}

}  // namespace

// Its steps are those past north alone, so that all lists that answer earlier marks are due there.
ElevationLoop::ElevationLoop(SensorPort& port, RotatingRadar& radar)
    : bus_(port.bus()), radar_(radar), loop_(ros::Duration(0)) {
  loop_.stopWaiting();
  topic_ =
      port.subscribe<tws_msgs::ElevationRequests>("elevation_requests", [this](const auto& list) { onRequests(list); });
}

bool ElevationLoop::isReady() const {
  return !radar_.isNorthNext() || loop_.isReady(tws_runtime::toTime(radar_.nextStamp()));
}

void ElevationLoop::stopWaiting() {
  if (isReady()) return;
  bus_.counter("commands late")
      .add("at " + std::to_string(radar_.nextStamp()) + " s " + radar_.params().name +
           " did not get elevation requests on " + topic_ +
           " in time and continues without searches until they come: is the tracker up?");
  loop_.stopWaiting();
}

void ElevationLoop::applyCommands() {
  if (!radar_.isNorthNext()) return;
  // A list that is a scan late is still of use; one from before an outage leads nowhere.
  const double oldest = radar_.nextStamp() - 2.0 * radar_.params().rotation_period;
  for (const Command& command : loop_.takeDue(tws_runtime::toTime(radar_.nextStamp()))) {
    const std::size_t taken = command.time > oldest ? radar_.setElevationSearches(command.orders) : 0;
    if (taken < command.orders.size())
      refuse(command.orders.size() - taken, "more than " + radar_.params().name + " can make, or too old");
  }
}

void ElevationLoop::onMark(const tws::RadarSector& sector) {
  if ((sector.running + 1) % tws::kSectors == kListSector) loop_.sent(tws_runtime::toTime(sector.leave_time));
}

void ElevationLoop::onRequests(const tws_msgs::ElevationRequests& requests) {
  const ros::Time stamp = requests.header.stamp;
  if (loop_.add(stamp, {tws_runtime::toSeconds(stamp), ordersOf(requests)})) return;
  bus_.counter("commands late")
      .add("elevation requests came late in " + topic_ + " at " + std::to_string(stamp.toSec()));
  loop_.stopWaiting();
}

std::vector<ElevationOrder> ElevationLoop::ordersOf(const tws_msgs::ElevationRequests& requests) const {
  std::vector<ElevationOrder> orders;
  for (const tws_msgs::ElevationRequest& request : requests.requests) {
    if (isGood(request))
      orders.push_back({request.azimuth, request.range});
    else
      refuse(1, "azimuth " + std::to_string(request.azimuth) + ", range " + std::to_string(request.range));
  }
  return orders;
}

void ElevationLoop::refuse(std::size_t count, const std::string& why) const {
  for (std::size_t i = 0; i < count; ++i) bus_.counter("refused elevation requests").add(why + ", in " + topic_);
}

}  // namespace radar_sim
