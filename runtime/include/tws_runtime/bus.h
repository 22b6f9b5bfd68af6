#pragma once

#include <ros/message_traits.h>
#include <ros/service_traits.h>
#include <ros/time.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <yaml-cpp/yaml.h>

#include <tws_runtime/channel.h>

namespace tws_runtime {

/// Sends messages of type M on one topic. Cheap to copy.
template <class M>
class Publisher {
 public:
  Publisher() = default;
  explicit Publisher(std::shared_ptr<Channel> channel) : channel_(std::move(channel)) {}

  void publish(const M& message) { publish(boost::make_shared<const M>(message)); }
  void publish(const boost::shared_ptr<const M>& message) { channel_->publish(message); }

 private:
  std::shared_ptr<Channel> channel_;
};

/// A named count of something that happened, shown in the diagnostics: live on /diagnostics, offline at the end of the
/// run. `what` is said once in the log at the first occurrence and then at most every few seconds.
class Counter {
 public:
  virtual ~Counter() = default;
  virtual void add(std::uint64_t n = 1) = 0;
  /// Counts one and says why, e.g. "azimuth is NaN in /sps12/detections at 12.375".
  virtual void add(const std::string& reason) = 0;
  virtual std::uint64_t value() const = 0;
};

/// The state of a part of a node, as /diagnostics shows it.
struct Diagnosis {
  enum class Level { kOk, kWarning, kError };
  Level level = Level::kOk;
  std::string summary;                                      ///< In short.
  std::vector<std::pair<std::string, std::string>> values;  ///< In the order in which they are shown.
};

/// All that a node needs from ROS. The same node class runs on roscpp, as a nodelet, and in one process without a
/// master.
///
/// One callback at a time: handlers, timers and services of one Bus never overlap. In one process, what is published is
/// queued first in, first out and delivered after the current handler returns.
///
/// Topics and services have ROS names: "sps12/detections" belongs to the node's namespace, so that a whole graph can be
/// moved into one; "~tracks" is the node's own (of the node "adit", /adit/tracks); "/clock" is absolute. All of them
/// can be remapped. Two types on one topic throw std::runtime_error.
class Bus {
 public:
  virtual ~Bus() = default;

  /// The node's name without a leading slash: "adit", or "siteA/adit" in the namespace /siteA.
  virtual const std::string& name() const = 0;

  /// This node's private parameters as one tree, without the sub-tree `live`, which is the runtime's own (run.h). Read
  /// them with ParameterReader (parameters.h).
  virtual YAML::Node parameters() const = 0;

  /// A latched topic repeats its last message to every later subscriber.
  template <class M>
  Publisher<M> advertise(const std::string& topic, bool latched = false) {
    return Publisher<M>(openChannel(topic, latched, messageType<M>()));
  }

  template <class M>
  void subscribe(const std::string& topic, std::function<void(const M&)> handler) {
    openSubscription(topic, messageType<M>(),
                     [handler = std::move(handler)](const boost::shared_ptr<const void>& message) {
                       handler(*static_cast<const M*>(message.get()));
                     });
  }

  /// The handler fills the response; false: the call failed.
  template <class S>
  void serve(const std::string& service, std::function<bool(typename S::Request&, typename S::Response&)> handler) {
    openService(service, serviceType<S>(std::move(handler)));
  }

  /// Transforms from /tf_static. Site frames are static.
  virtual const tf2::BufferCore& transforms() const = 0;
  /// Publishes a static, latched transform; several calls add up.
  virtual void publishStaticTransform(const geometry_msgs::TransformStamped& transform) = 0;

  /// Is this a run in which work may fall behind what arrives? False in one process, where the source waits.
  virtual bool live() const = 0;
  /// Calls `handler` once, after all that has arrived by now has been handed over: where work is done bit by bit, what
  /// arrives meanwhile is known in between.
  virtual void whenDrained(std::function<void()> handler) = 0;

  /// Shows a diagnosis of that name in /diagnostics once a second of wall time; never called offline.
  virtual void diagnose(const std::string& name, std::function<Diagnosis()> diagnosis) = 0;
  /// The counter of that name, made at the first call. Names are plain text: "late detections".
  virtual Counter& counter(const std::string& name) = 0;

  /// Data time: /clock live, the time of the source's current step offline. For stamps and timers only; no algorithm
  /// asks it.
  virtual ros::Time now() const = 0;
  /// Calls `handler(deadline)` once data time has passed each multiple of `period_s` [s], > 0: after all that happens
  /// at the deadline and, in one process, before all that happens later. The first one is at or after the time at which
  /// the graph starts.
  virtual void everyData(double period_s, std::function<void(ros::Time)> handler) = 0;
  /// Calls `handler` on wall time; never called offline. For diagnostics, progress and the drawn sweep only.
  virtual void everyWall(double period_s, std::function<void()> handler) = 0;

 protected:
  virtual std::shared_ptr<Channel> openChannel(const std::string& topic, bool latched, const MessageType& type) = 0;
  virtual void openSubscription(const std::string& topic, const MessageType& type,
                                std::function<void(const boost::shared_ptr<const void>&)> handler) = 0;
  virtual void openService(const std::string& service, const ServiceType& type) = 0;
};

}  // namespace tws_runtime
