#include <esa_frame_builder/mfa_stub_node.h>

#include <tws_msgs/Frame.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/sites.h>

#include <deque>
#include <optional>

#include "dwell_messages.h"
#include "frame_rules.h"
#include "mfa_messages.h"
#include "mfa_stub_params_reader.h"
#include "run_watch.h"
#include "stub_tracker.h"

namespace esa_frame_builder {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  MfaStubParams tracker;
  std::string radar = "esa";
  std::string frame = "map";
  double restart_limit = 5.0;  // [s]
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.tracker = readMfaStubParams(reader);
  reader.text("radar", params.radar);
  reader.text("frame", params.frame);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

// Heartbeats that wait for the array's pose.
constexpr std::size_t kMostWaiting = 50;

}  // namespace

class MfaStubNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/frames"),
        watch_(params_.restart_limit),
        tracks_(bus.advertise<tws_msgs::Tracks>(params_.radar + "/tracks")),
        database_(bus.advertise<tws_msgs::TrackDatabase>(params_.radar + "/track_database")) {
    bus.subscribe<tws_msgs::Frame>(topic_, [this](const auto& message) { hear(message); });
  }

 private:
  void begin() {
    window_ = FrameWindow(params_.tracker.window_frames);
    if (pose_) tracker_ = std::make_unique<StubTracker>(params_.tracker, *pose_);
  }

  void hear(const tws_msgs::Frame& message) {
    if (!isGood(message)) return;
    waiting_.push_back(message);
    if (!pose_ && !findPose(message)) return;
    for (; !waiting_.empty(); waiting_.pop_front()) take(waiting_.front());
  }

  bool isGood(const tws_msgs::Frame& message) {
    if (message.radar != params_.radar) {
      bus_.counter("bad messages").add("radar '" + message.radar + "', expected '" + params_.radar + "'" + at(message));
      return false;
    }
    const RunWatch::Verdict verdict = watch_.judge(tws_runtime::toSeconds(message.through));
    if (verdict == RunWatch::Verdict::kLate) {
      bus_.counter("late messages").add("the stamp goes back" + at(message));
      return false;
    }
    if (verdict == RunWatch::Verdict::kNewRun) {
      bus_.counter("new runs").add("time has gone back" + at(message));
      waiting_.clear();
      begin();
    }
    return true;
  }

  std::string at(const tws_msgs::Frame& message) const {
    return " in " + topic_ + " at " + std::to_string(message.through.toSec()) + " s";
  }

  /// False: wait for the array's pose.
  bool findPose(const tws_msgs::Frame& message) {
    std::string why;
    const auto pose = tws_runtime::findPose(bus_.transforms(), params_.frame, message.header.frame_id, why);
    if (!pose && waiting_.size() <= kMostWaiting) return false;
    if (!pose) {
      bus_.counter("unknown poses")
          .add("no transform from " + message.header.frame_id + " to " + params_.frame + ": " + why);
    }
    pose_ = pose ? ArrayPose{pose->translation(), pose->linear()} : ArrayPose{};
    begin();
    return true;
  }

  void take(const tws_msgs::Frame& message) {
    if (message.status == tws_msgs::Frame::HEARTBEAT) return answer(message);
    std::vector<std::string> faults;
    Frame frame = toFrame(message, faults);
    for (const std::string& fault : faults) bus_.counter("bad measurements").add(fault + at(message));
    if (!frame.closed) return window_.look(std::move(frame));
    const Frame* previous = window_.closed().empty() ? nullptr : &window_.closed().front();
    for (const std::string& fault : brokenRules(frame, previous))
      bus_.counter("broken frame rules").add(fault + at(message));
    bus_.counter("duplicates in frames").add(removeDuplicates(frame, params_.tracker.duplicate_chi2));
    bus_.counter("frames").add();
    window_.shift(std::move(frame));
    tracker_->take(window_);
  }

  void answer(const tws_msgs::Frame& heartbeat) {
    const TrackReport report = tracker_->report(window_);
    window_.clearOpen();
    publishTracks(heartbeat, report);
    publishDatabase(heartbeat, report);
  }

  void publishTracks(const tws_msgs::Frame& heartbeat, const TrackReport& report) {
    tws_msgs::Tracks message;
    message.header.stamp = heartbeat.through;
    message.header.frame_id = params_.frame;
    message.tracker = bus_.name();
    message.radar = params_.radar;
    message.sequence = sequence_++;
    for (const TrackWord& word : report.words) {
      message.tracks.push_back(trackMessage(word, *pose_, params_.radar));
      if (word.dropped) bus_.counter("dropped tracks").add();
    }
    tracks_.publish(message);
  }

  void publishDatabase(const tws_msgs::Frame& heartbeat, const TrackReport& report) {
    tws_msgs::TrackDatabase message;
    message.header.stamp = heartbeat.through;
    message.header.frame_id = params_.frame;
    message.radar = params_.radar;
    const double time = tws_runtime::toSeconds(heartbeat.through);
    for (const FrameTrack& track : report.living) message.tracks.push_back(databaseEntry(track, time, params_.tracker));
    database_.publish(message);
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  RunWatch watch_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  tws_runtime::Publisher<tws_msgs::TrackDatabase> database_;
  std::deque<tws_msgs::Frame> waiting_;
  std::optional<ArrayPose> pose_;
  FrameWindow window_{2};
  std::unique_ptr<FrameTracker> tracker_;
  std::uint32_t sequence_ = 0;
};

MfaStubNode::MfaStubNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
MfaStubNode::~MfaStubNode() = default;

}  // namespace esa_frame_builder
