#include "array_loop.h"

#include <stdexcept>

#include <tws_runtime/conversions.h>

#include "array_messages.h"

namespace radar_sim {

ArrayLoop::ArrayLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar)
    : bus_(bus),
      simulation_(simulation),
      radar_(radar),
      loop_(ros::Duration(simulation.arrayRadars()[radar].params().command_latency)),
      reports_(bus.advertise<tws_msgs::DwellReports>("/" + this->radar().params().name + "/dwell_reports")),
      database_topic_("/" + this->radar().params().name + "/track_database") {
  bus.subscribe<tws_msgs::TrackDatabase>(database_topic_, [this](const auto& database) { hear(database); });
}

bool ArrayLoop::isNext() const {
  const auto next = simulation_.nextTime();
  return next && radar().nextReport() <= *next;
}

bool ArrayLoop::isReady() const { return !isNext() || loop_.isReady(tws_runtime::toTime(radar().planTime())); }

void ArrayLoop::stopWaiting() {
  if (isReady()) return;
  bus_.counter("commands late")
      .add("no answer on " + database_topic_ + " in time: " + radar().params().name +
           " goes on without until one comes");
  loop_.stopWaiting();
}

void ArrayLoop::prepareStep() {
  if (!isNext()) return;
  for (std::vector<ArrayTrack>& tracks : loop_.takeDue(tws_runtime::toTime(radar().planTime())))
    simulation_.setTracks(radar_, std::move(tracks));
}

void ArrayLoop::publish(const ResourcePeriod& period) {
  const tws_msgs::DwellReports message = toDwellReports(period, radar().params());
  loop_.sent(message.header.stamp);
  reports_.publish(message);
}

void ArrayLoop::hear(const tws_msgs::TrackDatabase& database) {
  const std::string place = " in " + database_topic_ + " at " + std::to_string(database.header.stamp.toSec());
  try {
    auto tracks = toArrayTracks(database, radar().params().name, radar().mapToArray());
    if (!loop_.hear(database.header.stamp, std::move(tracks)))
      bus_.counter("commands late").add("a late answer" + place);
  } catch (const std::invalid_argument& error) {
    bus_.counter("refused track databases").add(error.what() + place);
  }
}

}  // namespace radar_sim
