#include <range_gate_tracker/range_gate_tracker_node.h>

#include <tws_core/run_guard.h>
#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/sites.h>

#include <deque>
#include <limits>
#include <optional>
#include <stdexcept>

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
        guard_(1, params_.restart_limit),
        gates_(bus.advertise<tws_msgs::RangeGate>(params_.radar + "/range_gate")),
        tracks_(bus.advertise<tws_msgs::Tracks>(params_.radar + "/tracks")) {
    begin();
    bus.subscribe<tws_msgs::RangeProfile>(topic_, [this](const auto& message) { hear(message); });
  }

 private:
  void begin() {
    tracker_.emplace(params_.tracker);
    last_.reset();
    target_.reset();
    next_profile_.reset();
    next_tracks_ = -std::numeric_limits<double>::infinity();
  }

  void hear(const tws_msgs::RangeProfile& message) {
    if (!fits(message)) return;
    std::string fault = faultOf(message, params_.radar);
    try {
      if (fault.empty()) return take(message, tracker_->process(toProfile(message)));
    } catch (const std::invalid_argument& error) {
      fault = error.what();
    }
    bus_.counter("bad profiles").add(fault + where(message));
    if (message.radar == params_.radar) answerUnchanged(message);
  }

  /// The stamp is one of this run, and new.
  bool fits(const tws_msgs::RangeProfile& message) {
    const double time = tws_runtime::toSeconds(message.header.stamp);
    const tws::RunGuard::Verdict verdict = guard_.judge(0, time);
    if (verdict == tws::RunGuard::Verdict::kNewRun) {
      bus_.counter("new runs").add("time has gone back" + where(message));
      begin();
      return true;
    }
    if (verdict != tws::RunGuard::Verdict::kTake) {
      bus_.counter("stray profiles").add("the stamp is out of line" + where(message));
      return false;
    }
    if (!last_ || time > last_->time) return true;
    bus_.counter("late profiles").add("not later than the profile before" + where(message));
    return false;
  }

  std::string where(const tws_msgs::RangeProfile& message) const {
    return " in " + topic_ + " at " + std::to_string(message.header.stamp.toSec()) + " s";
  }

  void take(const tws_msgs::RangeProfile& message, const GateReport& report) {
    if (next_profile_ && message.profile > *next_profile_)
      bus_.counter("lost profiles").add(message.profile - *next_profile_);
    next_profile_ = message.profile + 1;
    bus_.counter("profiles").add();
    if (report.lock == Lock::kSearching && last_ && last_->lock != Lock::kSearching) bus_.counter("lost targets").add();
    answer(message, report);
    speak(message, report);
    last_ = report;
  }

  /// Each profile has its answer, a bad one too: the radar waits for it.
  void answer(const tws_msgs::RangeProfile& message, const GateReport& report) {
    tws_msgs::RangeGate gate = toMessage(report, params_.tracker);
    gate.header.stamp = message.header.stamp;
    gate.header.frame_id = message.header.frame_id;
    gate.radar = params_.radar;
    gates_.publish(gate);
  }

  void answerUnchanged(const tws_msgs::RangeProfile& message) {
    if (!last_) return;
    last_->time = tws_runtime::toSeconds(message.header.stamp);
    last_->measured = std::numeric_limits<double>::quiet_NaN();
    answer(message, *last_);
  }

  void speak(const tws_msgs::RangeProfile& message, const GateReport& report) {
    tws_msgs::Tracks words;
    const bool has_target = report.lock != Lock::kSearching;
    const bool is_news = has_target != target_.has_value();
    if (has_target) {
      words.tracks.push_back(*(target_ = wordOf(report, message.azimuth)));
    } else if (target_) {
      words.tracks.push_back(*target_);
      words.tracks.back().state = tws_msgs::Track::DROPPED;
      target_.reset();
    }
    if (is_news || report.time >= next_tracks_) publish(message, words);
  }

  tws_msgs::Track wordOf(const GateReport& report, double azimuth) {
    tws_msgs::Track word = toTrack(report, azimuth);
    word.number = 1;
    word.uid = target_ ? target_->uid : ++uid_;
    word.first_detection = target_ ? target_->first_detection : word.stamp;
    word.last_update = report.lock == Lock::kLocked ? word.stamp : target_->last_update;
    word.radars = {params_.radar};
    word.radar_updates = {word.last_update};
    return word;
  }

  /// Tracks wait until the radar's site is known; without one their places stay unknown.
  std::optional<tws_runtime::Site> awaitSite(const std::string& radar_frame) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return tws_runtime::awaitSite(bus_, params_.frame, radar_frame, waiting_.size() <= kMostWaiting,
                                  {kUnknown, kUnknown, kUnknown, kUnknown});
  }

  void publish(const tws_msgs::RangeProfile& message, tws_msgs::Tracks& words) {
    next_tracks_ = tws_runtime::toSeconds(message.header.stamp) + params_.track_period;
    words.header.stamp = message.header.stamp;
    words.header.frame_id = params_.frame;
    words.tracker = bus_.name();
    words.sequence = sequence_++;
    waiting_.push_back(words);
    if (!site_) site_ = awaitSite(message.header.frame_id);
    if (!site_) return;
    for (tws_msgs::Tracks& ready : waiting_) {
      for (tws_msgs::Track& track : ready.tracks) place(track, *site_);
      tracks_.publish(ready);
    }
    waiting_.clear();
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  tws::RunGuard guard_;
  tws_runtime::Publisher<tws_msgs::RangeGate> gates_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  std::optional<RangeGateTracker> tracker_;
  std::optional<GateReport> last_;
  std::optional<tws_msgs::Track> target_;  // its last word
  std::optional<std::uint32_t> next_profile_;
  std::optional<tws_runtime::Site> site_;
  std::deque<tws_msgs::Tracks> waiting_;  // for the site
  double next_tracks_ = 0.0;              // [s]
  std::uint32_t uid_ = 0;
  std::uint32_t sequence_ = 0;
};

RangeGateTrackerNode::RangeGateTrackerNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
RangeGateTrackerNode::~RangeGateTrackerNode() = default;

}  // namespace range_gate_tracker
