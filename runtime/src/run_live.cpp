#include <rosgraph_msgs/Clock.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <algorithm>
#include <optional>

#include "subscriber_wait.h"

namespace tws_runtime {
namespace {

constexpr double kClockPeriod = 0.02;  // [s of wall time]: /clock goes out at least 50 times a second.

constexpr double kMostMadeUp = 0.1;  // [s of wall time]

/// Serves callbacks until the commands are there by which the source's next step goes.
void waitForCommands(RosBus& bus, Source& source, double timeout) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(timeout);
  while (bus.ok() && !source.isReady() && ros::WallTime::now() < end) bus.spinOne(kClockPeriod);
  if (!source.isReady()) source.stopWaiting();
}

/// Data time that runs `rate` times as fast as the wall clock, and publishes it.
class PacedClock {
 public:
  PacedClock(RosBus& bus, double rate)
      : bus_(bus), publisher_(bus.advertise<rosgraph_msgs::Clock>("/clock")), rate_(rate) {}

  /// From here on: it is `time` now.
  void start(ros::Time time) {
    data_start_ = time;
    wall_start_ = ros::WallTime::now();
  }

  /// Spins until it is `time`, telling the time on the way and at the end. When it should have been that time long ago
  /// (a command was awaited, the machine was busy), data time has been held: it is not made up for in a burst, in which
  /// messages of one topic would overtake those of another by seconds of data time.
  void waitUntil(ros::Time time) {
    if (wallUntil(time) < -kMostMadeUp) start(time);
    for (double wait = wallUntil(time); wait > 0.0 && bus_.ok(); wait = wallUntil(time)) {
      bus_.spinFor(std::min(wait, kClockPeriod));
      tell(std::min(time, data_start_ + ros::Duration(rate_ * wallElapsed())));
    }
    tell(time);
  }

 private:
  double wallElapsed() const { return (ros::WallTime::now() - wall_start_).toSec(); }
  double wallUntil(ros::Time time) const {
    return rate_ > 0.0 ? secondsBetween(data_start_, time) / rate_ - wallElapsed() : 0.0;
  }
  void tell(ros::Time time) {
    rosgraph_msgs::Clock message;
    message.clock = time;
    publisher_.publish(message);
  }

  RosBus& bus_;
  Publisher<rosgraph_msgs::Clock> publisher_;
  double rate_;
  ros::Time data_start_;
  ros::WallTime wall_start_;
};

}  // namespace

LiveOptions readLiveOptions(const YAML::Node& tree, const std::string& where) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  LiveOptions options;
  ParameterReader reader(tree, where);
  reader.number("rate", options.rate, 0.0, 1e6);
  reader.number("duration", options.duration, 1e-3, kUnbounded);
  reader.texts("wait_for", options.wait_for);
  reader.number("wait_timeout", options.wait_timeout, 0.0, 3600.0);
  reader.number("command_timeout", options.command_timeout, 0.0, 3600.0);
  reader.number("linger", options.linger, 0.0, 3600.0);
  reader.flag("required", options.required);
  reader.done();
  return options;
}

void runLive(RosBus& bus, Source& source, const LiveOptions& options) {
  const std::optional<ros::Time> start = source.nextTime();
  if (!start) return;
  PacedClock clock(bus, options.rate);
  waitForSubscribers(bus, options);
  clock.start(*start);
  for (auto next = start; next && bus.ok(); next = source.nextTime()) {
    if (secondsBetween(*start, *next) > options.duration) break;
    clock.waitUntil(*next);
    waitForCommands(bus, source, options.command_timeout);
    source.step();
    bus.spinFor(0.0);
  }
  if (bus.ok()) bus.spinFor(options.linger);
}

void runFeed(RosBus& bus, Feed& feed) {
  constexpr double kPollPeriod = 0.005;  // [s]
  Publisher<rosgraph_msgs::Clock> clock = bus.advertise<rosgraph_msgs::Clock>("/clock");
  ros::WallTime published;
  while (bus.ok()) {
    const std::optional<ros::Time> time = feed.poll();
    if (time && (ros::WallTime::now() - published).toSec() >= kClockPeriod) {
      rosgraph_msgs::Clock message;
      message.clock = *time;
      clock.publish(message);
      published = ros::WallTime::now();
    }
    bus.spinFor(kPollPeriod);
  }
}

}  // namespace tws_runtime
