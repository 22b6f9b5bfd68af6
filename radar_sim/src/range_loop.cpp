#include "range_loop.h"

#include <tws_runtime/conversions.h>

#include "conversions.h"

namespace radar_sim {

RangeLoop::RangeLoop(tws_runtime::Bus& bus, Simulation& simulation, std::size_t radar)
    : bus_(bus),
      simulation_(simulation),
      radar_(radar),
      loop_(ros::Duration(this->radar().params().latency)),
      profiles_(bus.advertise<tws_msgs::RangeProfile>("/" + this->radar().params().name + "/range_profile")),
      gate_topic_("/" + this->radar().params().name + "/range_gate") {
  bus.subscribe<tws_msgs::RangeGate>(gate_topic_, [this](const tws_msgs::RangeGate& gate) {
    if (loop_.hear(gate.header.stamp, gate)) return;
    bus_.counter("commands late")
        .add("a late answer in " + gate_topic_ + " at " + std::to_string(gate.header.stamp.toSec()));
  });
}

bool RangeLoop::isNext() const {
  const auto next = simulation_.nextTime();
  return next && radar().nextProfile() <= *next;
}

bool RangeLoop::isReady() const { return !isNext() || loop_.isReady(tws_runtime::toTime(radar().nextProfile())); }

void RangeLoop::stopWaiting() {
  if (isReady()) return;
  bus_.counter("commands late")
      .add("no answer on " + gate_topic_ + " in time: the gate of " + radar().params().name +
           " stays where it is until one comes");
  loop_.stopWaiting();
}

void RangeLoop::prepareStep() {
  if (!isNext()) return;
  for (const tws_msgs::RangeGate& gate : loop_.takeDue(tws_runtime::toTime(radar().nextProfile()))) {
    if (simulation_.setGate(radar_, {gate.range_min, gate.range_max})) continue;
    bus_.counter("refused range gates")
        .add("from " + std::to_string(gate.range_min) + " m to " + std::to_string(gate.range_max) + " m in " +
             gate_topic_ + " at " + std::to_string(gate.header.stamp.toSec()));
  }
}

void RangeLoop::publish(const AmplitudeProfile& profile) {
  const tws_msgs::RangeProfile message = toRangeProfile(profile, radar().params());
  loop_.sent(message.header.stamp);
  profiles_.publish(message);
}

}  // namespace radar_sim
