#include "elevation_loop.h"

#include <cmath>

#include <tws_core/angles.h>
#include <tws_runtime/conversions.h>

namespace radar_sim {
namespace {

constexpr std::int64_t kListSector = 61;  // entered when the list is asked for

bool isGood(const tws_msgs::ElevationRequest& request) {
  return request.azimuth >= 0.0 && request.azimuth < tws::kTwoPi && request.range > 0.0 && std::isfinite(request.range);
}

}  // namespace

// Its steps are those past north alone, so that all lists that answer earlier marks are due there.
ElevationLoop::ElevationLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar)
    : bus_(bus),
      simulation_(simulation),
      radar_(radar),
      topic_("/" + this->radar().params().name + "/elevation_requests"),
      loop_(ros::Duration(0)) {
  loop_.stopWaiting();
  bus.subscribe<tws_msgs::ElevationRequests>(topic_, [this](const auto& requests) { hear(requests); });
}

bool ElevationLoop::isNext() const {
  const auto next = simulation_.nextTime();
  return next && radar().isNorthNext() && radar().nextMark() <= *next;
}

bool ElevationLoop::isReady() const { return !isNext() || loop_.isReady(tws_runtime::toTime(radar().nextMark())); }

void ElevationLoop::stopWaiting() {
  if (isReady()) return;
  bus_.counter("commands late")
      .add("no list on " + topic_ + " in time: " + radar().params().name +
           " turns on without elevation searches until one comes");
  loop_.stopWaiting();
}

void ElevationLoop::prepareStep() {
  if (!isNext()) return;
  // A list that is a turn late is still of use; one from before an outage leads nowhere.
  const double oldest = radar().nextMark() - 2.0 * radar().params().rotation_period;
  for (const Command& command : loop_.takeDue(tws_runtime::toTime(radar().nextMark()))) {
    const std::size_t taken = command.time > oldest ? simulation_.setElevationSearches(radar_, command.orders) : 0;
    if (taken < command.orders.size())
      refuse(command.orders.size() - taken, "more than " + radar().params().name + " can make, or too old");
  }
}

void ElevationLoop::hearMark(const SectorReport& report) {
  if (report.radar == radar_ && (report.sector.running + 1) % tws::kSectors == kListSector)
    loop_.sent(tws_runtime::toTime(report.sector.leave_time));
}

void ElevationLoop::hear(const tws_msgs::ElevationRequests& requests) {
  const ros::Time stamp = requests.header.stamp;
  if (loop_.hear(stamp, {tws_runtime::toSeconds(stamp), ordersOf(requests)})) return;
  bus_.counter("commands late").add("a late list in " + topic_ + " at " + std::to_string(stamp.toSec()));
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
