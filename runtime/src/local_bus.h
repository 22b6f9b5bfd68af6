#pragma once

#include <tf2_msgs/TFMessage.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/parameters.h>

#include <map>
#include <string>
#include <utility>

#include "counter_set.h"
#include "local_core.h"

namespace tws_runtime {

/// The Bus of one node of a LocalGraph.
class LocalBus : public Bus {
 public:
  LocalBus(LocalCore& core, const std::string& name, const YAML::Node& parameters,
           const std::map<std::string, std::string>& remaps);

  const std::string& name() const override { return name_; }
  YAML::Node parameters() const override;
  const tf2::BufferCore& transforms() const override { return core_.transforms(); }
  void publishStaticTransform(const geometry_msgs::TransformStamped& transform) override;
  bool live() const override { return false; }
  void whenDrained(std::function<void()> handler) override { core_.post(std::move(handler)); }
  void diagnose(const std::string&, std::function<Diagnosis()>) override {}
  Counter& counter(const std::string& name) override { return counters_.get(name); }
  ros::Time now() const override { return core_.now(); }
  void everyData(double period_s, std::function<void(ros::Time)> handler) override;
  void everyWall(double, std::function<void()>) override {}

  const CounterSet& counters() const { return counters_; }

 protected:
  std::shared_ptr<Channel> openChannel(const std::string& topic, bool latched, const MessageType& type) override;
  void openSubscription(const std::string& topic, const MessageType& type, LocalTopic::Handler handler) override;
  void openService(const std::string& service, const ServiceType& type) override;

 private:
  std::string resolve(const std::string& name) const;

  LocalCore& core_;
  const std::string name_;
  const YAML::Node parameters_;
  std::map<std::string, std::string> remaps_;  // absolute names
  CounterSet counters_;
  tf2_msgs::TFMessage static_transforms_;
  Publisher<tf2_msgs::TFMessage> static_transform_publisher_;
};

}  // namespace tws_runtime
