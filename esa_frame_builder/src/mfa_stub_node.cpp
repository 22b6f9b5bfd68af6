#include <esa_frame_builder/mfa_stub_node.h>

#include <tws_msgs/Frame.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>
#include <tws_runtime/site_gate.h>
#include <tws_runtime/track_writer.h>

#include <memory>

#include "dwell_messages.h"
#include "frame_rules.h"
#include "mfa_messages.h"
#include "mfa_stub_params_reader.h"
#include "stub_tracker.h"

namespace esa_frame_builder {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  MfaStubParams tracker;
  std::string radar = "esa";
  std::string frame = "map";
  double restart_limit = 5.0;  // [s]
  tws::SeaLevel sea;
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.tracker = readMfaStubParams(reader);
  reader.text("radar", params.radar);
  reader.text("frame", params.frame);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  params.sea = tws_runtime::readOrigin(reader);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

// Frames that wait for the array's pose.
constexpr std::size_t kMostWaiting = 50;

}  // namespace

class MfaStubNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/frames"),
        tracks_(bus, params_.radar + "/tracks", params_.frame),
        database_(bus.advertise<tws_msgs::TrackDatabase>(params_.radar + "/track_database")),
        site_(bus, params_.frame, kMostWaiting),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    tws_runtime::IntakeTopic<tws_msgs::Frame> frames{topic_, params_.radar, tws_runtime::StampOrder::kNotBackward};
    frames.stamp = [](const tws_msgs::Frame& message) { return message.through; };
    intake_.subscribe<tws_msgs::Frame>(frames, [this](const auto& message) {
      site_.add(message.header.frame_id, message, [this](const tws_msgs::Frame& each) { onFrame(each); });
    });
  }

 private:
  void begin() {
    site_.clear();
    window_ = FrameWindow(params_.tracker.window_frames);
    tracker_.reset();
  }

  /// The first frame of a run, once the array's pose is known.
  void start() {
    if (const auto& pose = site_.pose()) pose_ = {pose->translation(), pose->linear()};
    window_ = FrameWindow(params_.tracker.window_frames);
    tracker_ = std::make_unique<StubTracker>(params_.tracker, pose_);
  }

  std::string at(const tws_msgs::Frame& message) const { return tws_runtime::whereText(topic_, message.through); }

  void onFrame(const tws_msgs::Frame& message) {
    if (!tracker_) start();
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
    tws_msgs::Tracks message = tracks_.message(heartbeat.through, params_.radar);
    for (const TrackUpdate& update : report.updates) {
      message.tracks.push_back(trackMessage(update, pose_.place, params_.sea, params_.radar));
      if (update.dropped) bus_.counter("dropped tracks").add();
    }
    tracks_.publish(message);
  }

  void publishDatabase(const tws_msgs::Frame& heartbeat, const TrackReport& report) {
    tws_msgs::TrackDatabase message;
    message.header.stamp = heartbeat.through;
    message.header.frame_id = params_.frame;
    message.radar = heartbeat.radar;
    const double time = tws_runtime::toSeconds(heartbeat.through);
    for (const FrameTrack& track : report.living) message.tracks.push_back(databaseEntry(track, time, params_.tracker));
    database_.publish(message);
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  tws_runtime::TrackWriter tracks_;
  tws_runtime::Publisher<tws_msgs::TrackDatabase> database_;
  tws_runtime::SiteGate site_;
  ArrayPose pose_;
  FrameWindow window_{2};
  std::unique_ptr<FrameTracker> tracker_;
  tws_runtime::Intake intake_;
};

MfaStubNode::MfaStubNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
MfaStubNode::~MfaStubNode() = default;

}  // namespace esa_frame_builder
