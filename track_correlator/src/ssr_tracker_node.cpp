#include <track_correlator/ssr_tracker_node.h>

#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/count_report.h>
#include <tws_runtime/intake.h>
#include <tws_runtime/site_gate.h>
#include <tws_runtime/track_writer.h>

#include <optional>

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
  tws::SeaLevel sea;
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.tracker = readSecondaryParams(reader);
  reader.text("radar", params.radar);
  reader.text("frame", params.frame);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  params.sea = tws_runtime::readOrigin(reader);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  return params;
}

// Reports that wait for the radar's site: two turns.
constexpr std::size_t kMostWaiting = 2 * std::size_t{tws::kSectors};

}  // namespace

class SsrTrackerNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        topic_(params_.radar + "/plots"),
        tracks_(bus, "ssr/tracks", params_.frame),
        site_(bus, params_.frame, kMostWaiting),
        counts_(bus, {{"plots", &SecondaryCounts::plots},
                      {"mended codes", &SecondaryCounts::mended_codes},
                      {"split plots", &SecondaryCounts::split_plots},
                      {"crowded plots", &SecondaryCounts::crowded_plots,
                       "a sector holds more than " + std::to_string(SecondaryTracker::kMostPlots) +
                           " plots: no track starts there"},
                      {"dropped tracks", &SecondaryCounts::dropped_tracks},
                      {"lost sectors", &SecondaryCounts::lost_sectors, "a running number is missing in " + topic_},
                      {"late sectors", &SecondaryCounts::late_sectors,
                       "a running number came late, twice or out of line in " + topic_}}),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    begin();
    intake_.subscribe<tws_msgs::SsrPlots>(
        {topic_, params_.radar, tws_runtime::StampOrder::kAny, tws_runtime::sectorFault<tws_msgs::SsrPlots>},
        [this](const auto& message) { onPlots(message); });
  }

 private:
  void begin() {
    site_.clear();
    counts_.reset();
    tracker_.emplace(params_.tracker, [this](const SecondaryReport& report) {
      site_.add(frame_, report, [this](const SecondaryReport& each) { publish(each); });
    });
  }

  void onPlots(const tws_msgs::SsrPlots& message) {
    frame_ = message.header.frame_id;
    std::vector<std::string> faults;
    SecondarySector sector = sectorOf(message, faults);
    for (const std::string& fault : faults)
      bus_.counter("bad plots").add(fault + tws_runtime::whereText(topic_, message.header.stamp));
    bus_.counter("sectors").add();
    tracker_->add(std::move(sector));
    counts_.add(tracker_->counts());
  }

  void publish(const SecondaryReport& report) {
    const Site site = site_.site().value_or(Site{});
    tws_msgs::Tracks message = tracks_.message(report.enter_time, params_.radar, report.running);
    for (const SecondaryUpdate& update : report.updates)
      message.tracks.push_back(trackMessage(update, site, params_.sea, params_.radar));
    tracks_.publish(message);
  }

  Bus& bus_;
  NodeParams params_;
  std::string topic_;
  std::string frame_;  // of the radar's site
  tws_runtime::TrackWriter tracks_;
  tws_runtime::SiteGate site_;
  tws_runtime::CountReport<SecondaryCounts> counts_;
  std::optional<SecondaryTracker> tracker_;
  tws_runtime::Intake intake_;
};

SsrTrackerNode::SsrTrackerNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
SsrTrackerNode::~SsrTrackerNode() = default;

}  // namespace track_correlator
