#include <track_correlator/ssr_tracker_node.h>

#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/sites.h>

#include <cmath>
#include <deque>
#include <optional>

#include <tws_core/run_guard.h>
#include <tws_core/sectors.h>

#include "secondary_messages.h"
#include "secondary_params_reader.h"

namespace track_correlator {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  SecondaryParams tracker;
  std::string radar = "ssr";
  std::string frame = "map";
  double restart_limit = 5.0;  // [s]
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.tracker = readSecondaryParams(reader);
  reader.text("radar", params.radar);
  reader.text("frame", params.frame);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

// Reports that wait for the radar's site: two turns.
constexpr std::size_t kMostWaiting = 2 * tws::kSectors;

}  // namespace

class SsrTrackerNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/plots"),
        guard_(1, params_.restart_limit),
        tracks_(bus.advertise<tws_msgs::Tracks>("ssr/tracks")) {
    begin();
    bus.subscribe<tws_msgs::SsrPlots>(topic_, [this](const auto& message) { hear(message); });
  }

 private:
  void begin() {
    waiting_.clear();
    totals_ = SecondaryCounts{};
    tracker_.emplace(params_.tracker, [this](const SecondaryReport& report) { hold(report); });
  }

  void hear(const tws_msgs::SsrPlots& message) {
    if (!isGood(message)) return;
    frame_ = message.header.frame_id;
    std::vector<std::string> faults;
    SecondarySector sector = sectorOf(message, faults);
    for (const std::string& fault : faults) bus_.counter("bad plots").add(fault + where(message));
    bus_.counter("sectors").add();
    tracker_->add(std::move(sector));
    countTroubles();
  }

  /// The message comes from this radar, is consistent, and its time fits the run.
  bool isGood(const tws_msgs::SsrPlots& message) {
    std::string fault;
    if (message.radar != params_.radar)
      fault = "radar '" + message.radar + "', expected '" + params_.radar + "'";
    else if (message.sector != message.running_sector % tws::kSectors)
      fault =
          "sector " + std::to_string(message.sector) + " with running number " + std::to_string(message.running_sector);
    if (fault.empty()) return fits(message);
    bus_.counter("bad messages").add(fault + where(message));
    return false;
  }

  bool fits(const tws_msgs::SsrPlots& message) {
    const tws::RunGuard::Verdict verdict = guard_.judge(0, tws_runtime::toSeconds(message.header.stamp));
    if (verdict == tws::RunGuard::Verdict::kTake) return true;
    if (verdict == tws::RunGuard::Verdict::kNewRun) {
      bus_.counter("new runs").add("time has gone back" + where(message));
      begin();
      return true;
    }
    bus_.counter("stray messages").add("the stamp is out of line" + where(message));
    return false;
  }

  std::string where(const tws_msgs::SsrPlots& message) const {
    return " in " + topic_ + " at " + std::to_string(message.header.stamp.toSec()) + " s";
  }

  /// Reports wait until the radar's site is known, so that what comes out does not depend on when it is told.
  void hold(const SecondaryReport& report) {
    waiting_.push_back(report);
    if (!site_) site_ = tws_runtime::awaitSite(bus_, params_.frame, frame_, waiting_.size() <= kMostWaiting);
    if (!site_) return;
    for (const SecondaryReport& ready : waiting_) publish(ready);
    waiting_.clear();
  }

  void publish(const SecondaryReport& report) {
    tws_msgs::Tracks message;
    message.header.stamp = tws_runtime::toTime(report.enter_time);
    message.header.frame_id = params_.frame;
    message.tracker = bus_.name();
    message.radar = params_.radar;
    message.running_sector = static_cast<std::uint32_t>(report.running);
    message.sector = static_cast<std::uint8_t>(report.running % tws::kSectors);
    message.sequence = sequence_++;
    for (const SecondaryWord& word : report.words) message.tracks.push_back(trackMessage(word, *site_, params_.radar));
    tracks_.publish(message);
  }

  void countTroubles() {
    const SecondaryCounts& now = tracker_->counts();
    const auto news = [&](std::uint64_t SecondaryCounts::*member) { return now.*member - totals_.*member; };
    bus_.counter("plots").add(news(&SecondaryCounts::plots));
    bus_.counter("mended codes").add(news(&SecondaryCounts::mended_codes));
    bus_.counter("split plots").add(news(&SecondaryCounts::split_plots));
    bus_.counter("dropped tracks").add(news(&SecondaryCounts::dropped_tracks));
    for (auto n = news(&SecondaryCounts::lost_sectors); n > 0; --n)
      bus_.counter("lost sectors").add("a running number is missing in " + topic_);
    for (auto n = news(&SecondaryCounts::late_sectors); n > 0; --n)
      bus_.counter("late sectors").add("a running number came late, twice or out of line in " + topic_);
    totals_ = now;
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  std::string frame_;  // of the radar's site
  tws::RunGuard guard_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  std::deque<SecondaryReport> waiting_;
  std::optional<Site> site_;
  std::uint32_t sequence_ = 0;
  SecondaryCounts totals_;
  std::optional<SecondaryTracker> tracker_;
};

SsrTrackerNode::SsrTrackerNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
SsrTrackerNode::~SsrTrackerNode() = default;

}  // namespace track_correlator
