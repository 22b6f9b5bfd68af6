#pragma once

#include <ros/time.h>

#include <optional>

namespace tws_runtime {

/// Something that makes messages in order of data time: a simulator, a bag, an ASTERIX file. Of several sources the one
/// with the earliest next time goes first. Only the runtime paces them and publishes /clock; a source never waits and
/// never asks a clock.
class Source {
 public:
  virtual ~Source() = default;
  /// Data time of what step() will publish next; nothing: the source has ended. Never goes back.
  virtual std::optional<ros::Time> nextTime() const = 0;
  /// Publishes everything that happens at nextTime().
  virtual void step() = 0;
  /// Whether all commands have come by which the next step goes: false only in closed loops (lock_step.h). Live, the
  /// runtime waits for them, for so long in wall time; then it calls stopWaiting() and steps. In one process they have
  /// come, as all that is queued is delivered between steps.
  virtual bool isReady() const { return true; }
  virtual void stopWaiting() {}
  /// Data time at which the source will end, for progress; nothing: unknown.
  virtual std::optional<ros::Time> endTime() const { return std::nullopt; }
};

/// Something that brings messages when they come, on a clock of its own: a live radar.
class Feed {
 public:
  virtual ~Feed() = default;
  /// Publishes what has come since the last call, without waiting. Returns the data time now; nothing: not known yet.
  virtual std::optional<ros::Time> poll() = 0;
};

}  // namespace tws_runtime
