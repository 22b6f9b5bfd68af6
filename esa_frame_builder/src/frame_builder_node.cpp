#include <esa_frame_builder/frame_builder_node.h>

#include <tws_msgs/DwellReports.h>
#include <tws_msgs/Frame.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>

#include <optional>

#include "dwell_messages.h"
#include "frame_builder.h"
#include "frame_builder_params_reader.h"

namespace esa_frame_builder {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  FrameBuilderParams builder;
  std::string radar = "esa";
  bool partial_frames = true;
  double timer_period = 0.05;  // [s]
  double restart_limit = 5.0;  // [s]
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.builder = readFrameBuilderParams(reader);
  reader.text("radar", params.radar);
  reader.flag("partial_frames", params.partial_frames);
  reader.number("timer_period_s", params.timer_period, 1e-3, 60.0);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

std::string durationFault(const tws_msgs::DwellReports& message) {
  if (message.duration > 0.0 && message.duration < 1e4) return "";
  return "duration is " + std::to_string(message.duration);
}

}  // namespace

class FrameBuilderNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/dwell_reports"),
        frames_(bus.advertise<tws_msgs::Frame>(params_.radar + "/frames")),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    begin();
    intake_.subscribe<tws_msgs::DwellReports>(
        {topic_, params_.radar, tws_runtime::StampOrder::kNotBackward, durationFault},
        [this](const auto& message) { onDwells(message); });
    if (!params_.builder.expects_next_dwell)
      bus.everyData(params_.timer_period, [this](ros::Time deadline) { closeStale(deadline); });
  }

 private:
  void begin() {
    builder_.emplace(params_.builder);
    last_dwell_ = 0.0;
    next_period_.reset();
  }

  void onDwells(const tws_msgs::DwellReports& message) {
    frame_id_ = message.header.frame_id;
    through_ = message.header.stamp;
    countLosses(message);
    ResourcePeriod period;
    period.duration = message.duration;
    if (!message.expected_next_dwell.isZero()) period.next_dwell = tws_runtime::toSeconds(message.expected_next_dwell);
    period.dwells = goodDwells(message);
    publish(builder_->take(std::move(period)));
    if (params_.partial_frames) publish(builder_->partialFrames());
    publishHeartbeat();
  }

  std::string at(const tws_msgs::DwellReports& message) const {
    return tws_runtime::whereText(topic_, message.header.stamp);
  }

  void countLosses(const tws_msgs::DwellReports& message) {
    if (next_period_ && message.resource_period != *next_period_)
      bus_.counter("lost resource periods").add("a running number is missing" + at(message));
    next_period_ = message.resource_period + 1;
    bus_.counter("resource periods").add();
  }

  std::vector<Dwell> goodDwells(const tws_msgs::DwellReports& message) {
    std::vector<Dwell> dwells;
    std::vector<std::string> bad_measurements;
    for (const tws_msgs::DwellReport& dwell : message.dwells) {
      const DwellFault fault = faultOf(dwell, last_dwell_, tws_runtime::toSeconds(message.header.stamp));
      if (!fault.counter.empty()) {
        bus_.counter(fault.counter).add(fault.reason + at(message));
        continue;
      }
      dwells.push_back(toDwell(dwell, bad_measurements));
      last_dwell_ = dwells.back().time;
    }
    for (const std::string& reason : bad_measurements) bus_.counter("bad measurements").add(reason + at(message));
    bus_.counter("dwells").add(dwells.size());
    return dwells;
  }

  void closeStale(ros::Time deadline) {
    const std::vector<Frame> stale = builder_->closeStale(tws_runtime::toSeconds(deadline));
    if (stale.empty()) return;
    bus_.counter("frames closed by the timer").add(stale.size());
    publish(stale);
    publishHeartbeat();
  }

  void publish(const std::vector<Frame>& frames) {
    for (const Frame& frame : frames) {
      tws_msgs::Frame message = toMessage(frame);
      message.header.stamp = message.dwells.front().stamp;
      if (frame.closed) count(frame);
      publish(message);
    }
  }

  void publishHeartbeat() {
    tws_msgs::Frame message;
    message.status = tws_msgs::Frame::HEARTBEAT;
    message.header.stamp = through_;
    publish(message);
  }

  void publish(tws_msgs::Frame& message) {
    message.header.frame_id = frame_id_;
    message.radar = intake_.radarOf(topic_);
    message.through = through_;
    frames_.publish(message);
  }

  void count(const Frame& frame) {
    bus_.counter("frames").add();
    bus_.counter("duplicates discarded").add(frame.discarded);
    for (const Dwell& dwell : frame.dwells) bus_.counter("measurements in frames").add(dwell.measurements.size());
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  std::string frame_id_;  // the array
  tws_runtime::Publisher<tws_msgs::Frame> frames_;
  std::optional<FrameBuilder> builder_;
  ros::Time through_;
  double last_dwell_ = 0.0;  // [s]
  std::optional<std::uint32_t> next_period_;
  tws_runtime::Intake intake_;
};

FrameBuilderNode::FrameBuilderNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
FrameBuilderNode::~FrameBuilderNode() = default;

}  // namespace esa_frame_builder
