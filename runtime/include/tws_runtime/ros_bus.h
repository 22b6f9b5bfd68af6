#pragma once

#include <ros/node_handle.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/counters.h>

#include <memory>
#include <string>
#include <vector>

namespace tws_runtime {

/// The Bus over roscpp. All queues are unbounded. It has a callback queue of its own, which one thread must serve by
/// spinFor() or spinOne(): that of the program's main(), or the one that each nodelet has.
///
/// Counters go to /diagnostics once a second of wall time: WARN when anything was counted with a reason since the last
/// time.
class RosBus : public Bus {
 public:
  /// `private_handle` gives the node's name, parameters and remaps: ros::NodeHandle("~"), or getPrivateNodeHandle() of
  /// a nodelet. ros::init must have been called.
  explicit RosBus(const ros::NodeHandle& private_handle);
  ~RosBus() override;

  const std::string& name() const override;
  YAML::Node parameters() const override;
  const tf2::BufferCore& transforms() const override;
  void publishStaticTransform(const geometry_msgs::TransformStamped& transform) override;
  bool live() const override { return true; }
  void whenDrained(std::function<void()> handler) override;
  void diagnose(const std::string& name, std::function<Diagnosis()> diagnosis) override;
  Counter& counter(const std::string& name) override;
  ros::Time now() const override;
  void everyData(double period_s, std::function<void(ros::Time)> handler) override;
  void everyWall(double period_s, std::function<void()> handler) override;

  /// The sub-tree `live` of the private parameters, which parameters() leaves out; see LiveOptions.
  YAML::Node liveParameters() const;
  /// The absolute name of a topic, after this node's remaps.
  std::string resolved(const std::string& topic) const;
  std::vector<CounterReading> counters() const;

  /// Calls what waits and what comes meanwhile, for at least `wall_s` [s of wall time], >= 0, or until ok() says false.
  void spinFor(double wall_s);
  /// The same for a node that only listens: what has gathered in its sockets while it stood still is handed over in
  /// order of its stamps, not topic by topic, and counted as "standstills".
  void spinInOrder(double wall_s);
  /// Calls the next thing that waits or comes within `wall_s` [s of wall time], >= 0.
  void spinOne(double wall_s);
  /// Says false once the node should end: ROS shuts down, or stop() was called.
  bool ok() const;
  /// May be called from any thread.
  void stop();

 protected:
  std::shared_ptr<Channel> openChannel(const std::string& topic, bool latched, const MessageType& type) override;
  void openSubscription(const std::string& topic, const MessageType& type,
                        std::function<void(const boost::shared_ptr<const void>&)> handler) override;
  void openService(const std::string& service, const ServiceType& type) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_runtime
