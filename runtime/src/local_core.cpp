#include "local_core.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <stdexcept>

#include "local_bus.h"

namespace tws_runtime {
namespace {

/// Marks a stretch of time in which a handler runs; it ends also by an exception.
class Busy {
 public:
  explicit Busy(bool& flag) : flag_(flag) {
    if (flag_) throw std::logic_error("a graph must not be driven from within one of its handlers");
    flag_ = true;
  }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;
  ~Busy() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace

LocalCore::LocalCore(std::ostream& log) : log_(log) {
  subscribe("/tf_static", messageType<tf2_msgs::TFMessage>(),
            [this](const boost::shared_ptr<const void>& message) { onStaticTransforms(message); });
}

LocalCore::~LocalCore() = default;

std::shared_ptr<Channel> LocalCore::openChannel(const std::string& node, const std::string& name, bool latched,
                                                const MessageType& type) {
  LocalTopic& found = topic(name, type);
  auto channel = std::make_shared<LocalChannel>(*this, found, "/" + node, latched);
  found.channels.push_back(channel);
  return channel;
}

void LocalCore::subscribe(const std::string& name, const MessageType& type, Handler handler) {
  LocalTopic& found = topic(name, type);
  found.handlers.push_back(std::move(handler));
  for (const auto& channel : found.channels)
    if (channel->last) queue_.push_back({channel.get(), channel->last, &found.handlers.back()});
}

void LocalCore::serve(const std::string& service, const ServiceType& type) {
  if (!services_.emplace(service, type).second) throw std::runtime_error("service " + service + " is served twice");
}

bool LocalCore::call(const std::string& service, const std::type_info& type, void* request, void* response) {
  const auto found = services_.find(service);
  if (found == services_.end()) throw std::runtime_error("no node offers the service " + service);
  if (*found->second.type != type)
    throw std::runtime_error("service " + service + " is of type " + found->second.datatype);
  bool answered = false;
  {
    const Busy busy(busy_);
    answered = found->second.call(request, response);
  }
  drain();
  return answered;
}

void LocalCore::post(LocalChannel& channel, const boost::shared_ptr<const void>& message) {
  queue_.push_back({&channel, message, nullptr});
}

void LocalCore::drain() {
  const Busy busy(busy_);
  while (!queue_.empty()) {
    const Delivery next = std::move(queue_.front());
    queue_.pop_front();
    deliver(next);
  }
}

void LocalCore::advanceTo(ros::Time time) {
  time = std::max(time, now_);
  while (const auto due = timers_.takeBefore(time)) {
    now_ = std::max(now_, due->deadline);
    {
      const Busy busy(busy_);
      due->handler(due->deadline);
    }
    drain();
  }
  now_ = time;
}

const MessageType* LocalCore::typeOf(const std::string& name) const {
  const auto found = topics_.find(name);
  return found == topics_.end() ? nullptr : &found->second.type;
}

bool LocalCore::isPublished(const std::string& name) const {
  const auto found = topics_.find(name);
  return found != topics_.end() && !found->second.channels.empty();
}

LocalTopic& LocalCore::topic(const std::string& name, const MessageType& type) {
  LocalTopic& found = topics_.try_emplace(name, LocalTopic{name, type, {}, {}}).first->second;
  if (*found.type.type != *type.type)
    throw std::runtime_error("topic " + name + " is opened as " + type.datatype + " (md5 " + type.md5sum +
                             ") and before as " + found.type.datatype + " (md5 " + found.type.md5sum + ")");
  return found;
}

void LocalCore::deliver(const Delivery& delivery) {
  if (delivery.task) return delivery.task();
  if (delivery.only) return (*delivery.only)(delivery.message);
  LocalChannel& channel = *delivery.channel;
  LocalTopic& topic = channel.topic;
  if (recorder_) recorder_->write(topic.name, now_, topic.type, delivery.message, channel.header);
  const std::size_t listeners =
      topic.handlers.size();  // One that subscribes meanwhile gets the latched message instead.
  if (channel.latched) channel.last = delivery.message;
  for (std::size_t i = 0; i < listeners; ++i) topic.handlers[i](delivery.message);
}

void LocalCore::onStaticTransforms(const boost::shared_ptr<const void>& message) {
  for (const auto& transform : static_cast<const tf2_msgs::TFMessage*>(message.get())->transforms)
    transforms_.setTransform(transform, "local", true);
}

}  // namespace tws_runtime
