#include <range_gate_tracker/range_gate_tracker_node.h>

#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_runtime/intake.h>
#include <tws_runtime/site_gate.h>
#include <tws_runtime/track_writer.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "range_gate_messages.h"
#include "range_gate_params_reader.h"

namespace range_gate_tracker {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  RangeGateParams tracker;
  std::string radar = "mrs";
  std::string frame = "map";
  double restart_limit = 5.0;  // [s]
  double track_period = 0.2;   // [s]
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.tracker = readRangeGateParams(reader);
  reader.text("radar", params.radar);
  reader.text("frame", params.frame);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.number("track_period_s", params.track_period, 0.001, 60.0);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

constexpr std::size_t kMostWaiting = 50;  // Tracks messages

}  // namespace

class RangeGateTrackerNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/range_profile"),
        gates_(bus.advertise<tws_msgs::RangeGate>(params_.radar + "/range_gate")),
        tracks_(bus, params_.radar + "/tracks", params_.frame),
        site_(bus, params_.frame, kMostWaiting),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    begin();
    intake_.subscribe<tws_msgs::RangeProfile>({topic_, params_.radar, tws_runtime::StampOrder::kForward},
                                              [this](const auto& message) { onProfile(message); });
  }

 private:
  void begin() {
    tracker_.emplace(params_.tracker);
    last_.reset();
    target_.reset();
    next_profile_.reset();
    next_tracks_ = -std::numeric_limits<double>::infinity();
  }

  void onProfile(const tws_msgs::RangeProfile& message) {
    std::string fault = faultOf(message);
    try {
      if (fault.empty()) return add(message, tracker_->process(toProfile(message)));
    } catch (const std::invalid_argument& error) {
      fault = error.what();
    }
    bus_.counter("bad profiles").add(fault + tws_runtime::whereText(topic_, message.header.stamp));
    answerUnchanged(message);
  }

  void add(const tws_msgs::RangeProfile& message, const GateReport& report) {
    if (next_profile_ && message.profile > *next_profile_)
      bus_.counter("lost profiles").add(message.profile - *next_profile_);
    next_profile_ = message.profile + 1;
    bus_.counter("profiles").add();
    if (report.lock == Lock::kSearching && last_ && last_->lock != Lock::kSearching) bus_.counter("lost targets").add();
    answer(message, report);
    update(message, report);
    last_ = report;
  }

  /// Each profile has its answer, a bad one too: the radar waits for it.
  void answer(const tws_msgs::RangeProfile& message, const GateReport& report) {
    tws_msgs::RangeGate gate = toMessage(report, params_.tracker);
    gate.header.stamp = message.header.stamp;
    gate.header.frame_id = message.header.frame_id;
    gate.radar = message.radar;
    gates_.publish(gate);
  }

  void answerUnchanged(const tws_msgs::RangeProfile& message) {
    if (!last_) return;
    last_->time = tws_runtime::toSeconds(message.header.stamp);
    last_->measured = std::numeric_limits<double>::quiet_NaN();
    answer(message, *last_);
  }

  void update(const tws_msgs::RangeProfile& message, const GateReport& report) {
    std::vector<tws_msgs::Track> updates;
    const bool has_target = report.lock != Lock::kSearching;
    const bool is_news = has_target != target_.has_value();
    if (has_target) {
      updates.push_back(*(target_ = updateOf(report, message.azimuth)));
    } else if (target_) {
      updates.push_back(*target_);
      updates.back().state = tws_msgs::Track::DROPPED;
      target_.reset();
    }
    if (is_news || report.time >= next_tracks_) publish(message, std::move(updates));
  }

  tws_msgs::Track updateOf(const GateReport& report, double azimuth) {
    tws_msgs::Track update = toTrack(report, azimuth, target_ ? target_->uid : ++uid_);
    update.first_detection = target_ ? target_->first_detection : update.stamp;
    update.last_update = report.lock == Lock::kLocked ? update.stamp : target_->last_update;
    update.radars = {params_.radar};
    update.radar_updates = {update.last_update};
    return update;
  }

  /// Tracks wait until the radar's site is known; without one their places stay unknown.
  void publish(const tws_msgs::RangeProfile& message, std::vector<tws_msgs::Track> updates) {
    next_tracks_ = tws_runtime::toSeconds(message.header.stamp) + params_.track_period;
    tws_msgs::Tracks out = tracks_.message(message.header.stamp, "");
    out.tracks = std::move(updates);
    site_.add(message.header.frame_id, std::move(out), [this](tws_msgs::Tracks& ready) {
      constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
      const tws_runtime::Site site = site_.site().value_or(tws_runtime::Site{kUnknown, kUnknown, kUnknown, kUnknown});
      for (tws_msgs::Track& track : ready.tracks) place(track, site);
      tracks_.publish(ready);
    });
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  tws_runtime::Publisher<tws_msgs::RangeGate> gates_;
  tws_runtime::TrackWriter tracks_;
  tws_runtime::SiteGate site_;  // Tracks messages wait for it
  std::optional<RangeGateTracker> tracker_;
  std::optional<GateReport> last_;
  std::optional<tws_msgs::Track> target_;  // its latest update
  std::optional<std::uint32_t> next_profile_;
  double next_tracks_ = 0.0;  // [s]
  std::uint32_t uid_ = 0;
  tws_runtime::Intake intake_;
};

RangeGateTrackerNode::RangeGateTrackerNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
RangeGateTrackerNode::~RangeGateTrackerNode() = default;

}  // namespace range_gate_tracker
