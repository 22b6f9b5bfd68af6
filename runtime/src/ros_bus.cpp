#include <tws_runtime/ros_bus.h>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_runtime/parameters.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "any_message.h"
#include "backlog.h"
#include "counter_set.h"
#include "data_timers.h"
#include "loopback_only.h"
#include "process_subscriptions.h"
#include "static_transforms.h"
#include "topic_name.h"
#include "xml_rpc_tree.h"

namespace tws_runtime {
namespace {

class RosChannel : public Channel {
 public:
  RosChannel(const ros::Publisher& publisher, const MessageType& type) : publisher_(publisher), type_(type) {}
  void publish(const boost::shared_ptr<const void>& message) override {
    publisher_.publish(boost::make_shared<AnyMessage>(AnyMessage{&type_, message}));
  }

 private:
  ros::Publisher publisher_;
  MessageType type_;
};

/// Hands roscpp's messages to a handler that takes any type. Between nodes of one process messages are not serialised.
class AnySubscription : public ros::SubscriptionCallbackHelper {
 public:
  using Handler = std::function<void(const boost::shared_ptr<const void>&)>;

  AnySubscription(const MessageType& type, Handler handler) : type_(type), handler_(std::move(handler)) {}

  ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& bytes) override {
    ros::serialization::IStream stream(bytes.buffer, bytes.length);
    return boost::make_shared<AnyMessage>(AnyMessage{&type_, type_.read(stream)});
  }
  void call(ros::SubscriptionCallbackHelperCallParams& params) override {
    const auto any = boost::static_pointer_cast<const AnyMessage>(params.event.getMessage());
    handler_(any->message);
  }
  const std::type_info& getTypeInfo() override { return typeid(AnyMessage); }
  bool isConst() override { return true; }
  bool hasHeader() override { return type_.has_header; }

 private:
  MessageType type_;
  Handler handler_;
};

class AnyService : public ros::ServiceCallbackHelper {
 public:
  explicit AnyService(ServiceType type) : type_(std::move(type)) {}
  bool call(ros::ServiceCallbackHelperCallParams& params) override {
    return type_.callSerialized(params.request, params.response);
  }

 private:
  ServiceType type_;
};

/// Something to do that waits its turn among the messages.
class Task : public ros::CallbackInterface {
 public:
  explicit Task(std::function<void()> task) : task_(std::move(task)) {}
  CallResult call() override {
    task_();
    return Success;
  }

 private:
  std::function<void()> task_;
};

std::uint8_t levelOf(Diagnosis::Level level) {
  using diagnostic_msgs::DiagnosticStatus;
  if (level == Diagnosis::Level::kError) return DiagnosticStatus::ERROR;
  return level == Diagnosis::Level::kWarning ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
}

/// The static transforms of all nodes of this process: roscpp keeps one last message of a latched topic for all of
/// them.
struct ProcessTransforms {
  std::mutex mutex;
  tf2_msgs::TFMessage message;
};

/// Never destroyed: nodelets may go later than static objects.
ProcessTransforms& processTransforms() {
  static auto* const the_ones = new ProcessTransforms;
  return *the_ones;
}

double steadyTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string withoutSlash(const std::string& name) { return name.empty() || name[0] != '/' ? name : name.substr(1); }

}  // namespace

class RosBus::Impl {
 public:
  explicit Impl(const ros::NodeHandle& private_handle)
      : handle(withQueue(private_handle, queue)),
        name(withoutSlash(handle.getNamespace())),
        counters(name, [](const std::string& line) { ROS_WARN_STREAM(line); }),
        diagnostics(ros::NodeHandle(), handle, "/" + name) {
    diagnostics.setHardwareID(name);
    diagnostics.add("counters", [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
    wall_timers.push_back(
        handle.createWallTimer(ros::WallDuration(1.0), [this](const auto&) { diagnostics.force_update(); }));
  }

  static ros::NodeHandle withQueue(ros::NodeHandle handle, ros::CallbackQueue& queue) {
    handle.setCallbackQueue(&queue);
    return handle;
  }

  std::string resolve(const std::string& topic) const { return handle.resolveName(absoluteName(name, topic)); }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status) {
    const std::uint64_t bad_news = counters.badNews();
    const bool grew = bad_news > reported_bad_news;
    status.summary(grew ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
                   grew ? std::to_string(bad_news - reported_bad_news) + " new faults" : "no new faults");
    for (const CounterReading& reading : counters.readings()) status.add(reading.name, reading.value);
    reported_bad_news = bad_news;
  }

  void onStaticTransforms(const tf2_msgs::TFMessage& message) {
    for (const auto& transform : message.transforms)
      if (!transforms.setTransform(transform, "tf_static", true))
        counters.get("refused transforms").add(transform.header.frame_id + " to " + transform.child_frame_id);
  }

  void beat() {
    if (const auto stood_still = backlog.beat(steadyTime()))
      counters.get("standstills")
          .add("the node stood still for " + std::to_string(*stood_still) +
               " s of wall time; what came meanwhile is worked off in order of its stamps");
  }

  void giveInOrder(std::size_t topic, ros::Time stamp, const Backlog::Give& give) {
    if (in_order) beat();
    if (!in_order || !backlog.keep(topic, stamp.toSec(), steadyTime(), give)) give();
  }

  AnySubscription::Handler inOrder(const MessageType& type, AnySubscription::Handler handler) {
    const std::size_t topic = backlog.addTopic();
    return [this, topic, stampOf = type.stamp, handler = std::move(handler)](const auto& message) {
      giveInOrder(topic, stampOf(message.get()), [&handler, message] { handler(message); });
    };
  }

  void fireTimers(ros::Time now) {
    while (const auto due = data_timers.takeBefore(now)) due->handler(due->deadline);
  }

  std::atomic<bool> stopped{false};
  ros::CallbackQueue queue;  // Before all that may still stand in it.
  ros::NodeHandle handle;
  std::string name;
  CounterSet counters;
  std::uint64_t reported_bad_news = 0;
  diagnostic_updater::Updater diagnostics;
  tf2::BufferCore transforms;
  std::optional<Publisher<tf2_msgs::TFMessage>> static_transform_publisher;
  DataTimers data_timers;
  Backlog backlog;
  bool in_order = false;  // what has gathered while the node stood still is handed over in order of time
  std::map<std::string, std::shared_ptr<RosChannel>> channels;
  // Last, so that nothing is called while the rest goes.
  std::vector<ros::Subscriber> subscribers;
  std::vector<ProcessSubscription> process_subscriptions;
  std::vector<ros::ServiceServer> services;
  std::vector<ros::WallTimer> wall_timers;
};

RosBus::RosBus(const ros::NodeHandle& private_handle) : impl_(std::make_unique<Impl>(private_handle)) {
  keepOnLoopback();
  subscribe<tf2_msgs::TFMessage>("/tf_static", [this](const auto& message) { impl_->onStaticTransforms(message); });
}

RosBus::~RosBus() = default;

const std::string& RosBus::name() const { return impl_->name; }

YAML::Node RosBus::parameters() const {
  XmlRpc::XmlRpcValue value;
  const std::string space = impl_->handle.getNamespace();
  return ros::param::get(space, value) ? withoutRuntimeKeys(treeFromXmlRpc(value, space)) : YAML::Node();
}

YAML::Node RosBus::liveParameters() const {
  XmlRpc::XmlRpcValue value;
  const std::string space = impl_->handle.getNamespace() + "/live";
  return ros::param::get(space, value) ? treeFromXmlRpc(value, space) : YAML::Node();
}

const tf2::BufferCore& RosBus::transforms() const { return impl_->transforms; }

void RosBus::publishStaticTransform(const geometry_msgs::TransformStamped& transform) {
  if (!impl_->static_transform_publisher)
    impl_->static_transform_publisher = advertise<tf2_msgs::TFMessage>("/tf_static", true);
  ProcessTransforms& all = processTransforms();
  const std::lock_guard<std::mutex> lock(all.mutex);
  addTransform(all.message, transform);
  impl_->static_transform_publisher->publish(all.message);
}

void RosBus::whenDrained(std::function<void()> handler) {
  impl_->queue.addCallback(boost::make_shared<Task>(std::move(handler)));
}

void RosBus::diagnose(const std::string& name, std::function<Diagnosis()> diagnosis) {
  impl_->diagnostics.add(name, [diagnosis = std::move(diagnosis)](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const Diagnosis now = diagnosis();
    status.summary(levelOf(now.level), now.summary);
    for (const auto& [key, value] : now.values) status.add(key, value);
  });
}

Counter& RosBus::counter(const std::string& name) { return impl_->counters.get(name); }
std::vector<CounterReading> RosBus::counters() const { return impl_->counters.readings(); }
ros::Time RosBus::now() const { return ros::Time::now(); }

void RosBus::everyData(double period_s, std::function<void(ros::Time)> handler) {
  const bool first = impl_->data_timers.empty();
  impl_->data_timers.add(period_s, std::move(handler));
  if (!first) return;
  if (ros::Time::isSimTime())
    subscribe<rosgraph_msgs::Clock>("/clock", [this, topic = impl_->backlog.addTopic()](const auto& message) {
      impl_->giveInOrder(topic, message.clock, [this, now = message.clock] { impl_->fireTimers(now); });
    });
  else
    everyWall(0.01, [this] { impl_->fireTimers(ros::Time::now()); });
}

void RosBus::everyWall(double period_s, std::function<void()> handler) {
  const auto call = [handler = std::move(handler)](const ros::WallTimerEvent&) { handler(); };
  impl_->wall_timers.push_back(impl_->handle.createWallTimer(ros::WallDuration(period_s), call));
}

std::string RosBus::resolved(const std::string& topic) const { return impl_->resolve(topic); }

void RosBus::spinFor(double wall_s) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(wall_s);
  do {
    impl_->queue.callAvailable(std::max(ros::WallDuration(0.0), end - ros::WallTime::now()));
  } while (ok() && ros::WallTime::now() < end);
}

void RosBus::spinInOrder(double wall_s) {
  // One by one: the work that a message makes is done before the next one, as if they had come at their time; and not
  // faster than listeners with short queues (rosbag record has 100) take in what comes of it.
  const ros::WallDuration between(0.001);
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(wall_s);
  impl_->in_order = true;
  do {
    impl_->beat();
    const auto give = impl_->backlog.take(steadyTime());
    if (give) (*give)();
    impl_->queue.callAvailable(give ? between : std::max(ros::WallDuration(0.0), end - ros::WallTime::now()));
  } while (ok() && ros::WallTime::now() < end);
}

void RosBus::spinOne(double wall_s) { impl_->queue.callOne(ros::WallDuration(wall_s)); }

bool RosBus::ok() const { return ros::ok() && !impl_->stopped; }

void RosBus::stop() {
  impl_->stopped = true;
  whenDrained([] {});  // So that who waits for something to call need not wait on.
}

std::shared_ptr<Channel> RosBus::openChannel(const std::string& topic, bool latched, const MessageType& type) {
  const std::string absolute = impl_->resolve(topic);
  ros::AdvertiseOptions options(absolute, 0, type.md5sum, type.datatype, type.definition);
  options.latch = latched;
  options.has_header = type.has_header;
  const ros::Publisher publisher = impl_->handle.advertise(options);
  if (!publisher) throw std::runtime_error("topic " + absolute + " cannot be opened as " + type.datatype);
  return impl_->channels[absolute] = std::make_shared<RosChannel>(publisher, type);
}

void RosBus::openSubscription(const std::string& topic, const MessageType& type,
                              std::function<void(const boost::shared_ptr<const void>&)> handler) {
  if (type.has_header) handler = impl_->inOrder(type, std::move(handler));
  ros::SubscribeOptions options;
  options.topic = impl_->resolve(topic);
  options.queue_size = 0;
  options.md5sum = type.md5sum;
  options.datatype = type.datatype;
  options.helper = boost::make_shared<AnySubscription>(type, std::move(handler));
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  impl_->subscribers.push_back(impl_->handle.subscribe(options));
  impl_->process_subscriptions.emplace_back(options.topic);
}

void RosBus::openService(const std::string& service, const ServiceType& type) {
  ros::AdvertiseServiceOptions options;
  options.service = impl_->resolve(service);
  options.md5sum = type.md5sum;
  options.datatype = type.datatype;
  options.req_datatype = type.request_datatype;
  options.res_datatype = type.response_datatype;
  options.helper = boost::make_shared<AnyService>(type);
  const ros::ServiceServer server = impl_->handle.advertiseService(options);
  if (!server) throw std::runtime_error("service " + options.service + " cannot be served");
  impl_->services.push_back(server);
}

}  // namespace tws_runtime
