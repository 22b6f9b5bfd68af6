#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>
#include <tws_runtime/channel.h>

#include <deque>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bag_recorder.h"
#include "data_timers.h"

namespace tws_runtime {

class LocalBus;
class LocalChannel;

/// Subscribers and publishers of one topic.
struct LocalTopic {
  using Handler = std::function<void(const boost::shared_ptr<const void>&)>;

  std::string name;
  MessageType type;
  std::deque<Handler> handlers;  ///< A deque: a handler that runs may add one.
  std::vector<std::shared_ptr<LocalChannel>> channels;
};

/// The topics, services, queue, timers and recorder that the nodes of one LocalGraph share. All names are absolute.
class LocalCore {
 public:
  using Handler = LocalTopic::Handler;

  explicit LocalCore(std::ostream& log);
  ~LocalCore();

  std::shared_ptr<Channel> openChannel(const std::string& node, const std::string& topic, bool latched,
                                       const MessageType& type);
  void subscribe(const std::string& topic, const MessageType& type, Handler handler);
  void serve(const std::string& service, const ServiceType& type);
  bool call(const std::string& service, const std::type_info& type, void* request, void* response);

  void post(LocalChannel& channel, const boost::shared_ptr<const void>& message);
  /// Calls `task` after all that is queued by now.
  void post(std::function<void()> task) { queue_.push_back({nullptr, nullptr, nullptr, std::move(task)}); }
  void drain();
  void advanceTo(ros::Time time);

  const MessageType* typeOf(const std::string& topic) const;
  bool isPublished(const std::string& topic) const;

  ros::Time now() const { return now_; }
  DataTimers& timers() { return timers_; }
  const tf2::BufferCore& transforms() const { return transforms_; }
  std::ostream& log() { return log_; }
  std::vector<std::unique_ptr<LocalBus>>& nodes() { return nodes_; }
  const std::vector<std::unique_ptr<LocalBus>>& nodes() const { return nodes_; }
  std::unique_ptr<BagRecorder>& recorder() { return recorder_; }

 private:
  /// A message on its way. `only` restricts it to one handler: a latched message for a late subscriber. Or a task.
  struct Delivery {
    LocalChannel* channel;
    boost::shared_ptr<const void> message;
    const Handler* only;
    std::function<void()> task = {};
  };
  LocalTopic& topic(const std::string& name, const MessageType& type);
  void deliver(const Delivery& delivery);
  void onStaticTransforms(const boost::shared_ptr<const void>& message);

  std::ostream& log_;
  ros::Time now_;
  bool busy_ = false;  ///< A handler runs.
  std::map<std::string, LocalTopic> topics_;
  std::map<std::string, ServiceType> services_;
  std::deque<Delivery> queue_;
  DataTimers timers_;
  tf2::BufferCore transforms_;
  std::unique_ptr<BagRecorder> recorder_;
  std::vector<std::unique_ptr<LocalBus>> nodes_;
};

/// One node's end of one topic.
class LocalChannel : public Channel {
 public:
  LocalChannel(LocalCore& core, LocalTopic& topic, const std::string& node, bool latched)
      : core(core), topic(topic), latched(latched), header(connectionHeader(node, topic.name, latched, topic.type)) {}
  void publish(const boost::shared_ptr<const void>& message) override { core.post(*this, message); }

  LocalCore& core;
  LocalTopic& topic;
  const bool latched;
  const boost::shared_ptr<ros::M_string> header;  ///< For the recorder.
  boost::shared_ptr<const void> last;             ///< The last message delivered, when latched.
};

}  // namespace tws_runtime
