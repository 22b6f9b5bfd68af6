#include "local_bus.h"

#include <ostream>

#include "static_transforms.h"
#include "topic_name.h"

namespace tws_runtime {

LocalBus::LocalBus(LocalCore& core, const std::string& name, const YAML::Node& parameters,
                   const std::map<std::string, std::string>& remaps)
    : core_(core),
      name_(name),
      parameters_(parameters),
      counters_(name, [&core](const std::string& line) { core.log() << line << std::endl; }) {
  for (const auto& [from, to] : remaps) remaps_.emplace(absoluteName(name, from), absoluteName(name, to));
}

YAML::Node LocalBus::parameters() const { return withoutRuntimeKeys(parameters_); }

void LocalBus::publishStaticTransform(const geometry_msgs::TransformStamped& transform) {
  if (static_transforms_.transforms.empty())
    static_transform_publisher_ = advertise<tf2_msgs::TFMessage>("/tf_static", true);
  addTransform(static_transforms_, transform);
  static_transform_publisher_.publish(static_transforms_);
}

void LocalBus::everyData(double period_s, std::function<void(ros::Time)> handler) {
  core_.timers().add(period_s, std::move(handler));
}

std::shared_ptr<Channel> LocalBus::openChannel(const std::string& topic, bool latched, const MessageType& type) {
  return core_.openChannel(name_, resolve(topic), latched, type);
}

void LocalBus::openSubscription(const std::string& topic, const MessageType& type, LocalTopic::Handler handler) {
  core_.subscribe(resolve(topic), type, std::move(handler));
}

void LocalBus::openService(const std::string& service, const ServiceType& type) { core_.serve(resolve(service), type); }

std::string LocalBus::resolve(const std::string& name) const {
  const std::string absolute = absoluteName(name_, name);
  const auto remap = remaps_.find(absolute);
  return remap == remaps_.end() ? absolute : remap->second;
}

}  // namespace tws_runtime
