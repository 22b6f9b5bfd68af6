#include <adit_tracker/adit_node.h>

#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/radar_inputs.h>

#include <cmath>
#include <deque>
#include <optional>

#include "adit.h"
#include "adit_params_reader.h"
#include "track_messages.h"

namespace adit_tracker {
namespace {

using tws_runtime::Bus;
using tws_runtime::RadarInputs;

struct NodeParams {
  AditParams adit;
  std::string frame = "map";  // of positions
  RadarInputs::Options inputs;
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  reader.require("radars");
  params.adit = readAditParams(reader);
  reader.text("frame", params.frame);
  reader.number("wait_limit_s", params.inputs.wait_limit, 0.0, 60.0);
  reader.number("restart_limit_s", params.inputs.restart_limit, 0.5, 3600.0);
  reader.done();
  if (params.inputs.wait_limit >= params.adit.skew_limit) {
    reader.fail("wait_limit_s", "must be less than skew_limit_s, or what replaces lost messages comes too late");
  }
  try {
    check(params.adit);
  } catch (const std::invalid_argument& error) {
    throw tws_runtime::ParameterError(bus.name() + ": " + error.what());
  }
  return params;
}

std::vector<tws_runtime::RadarTopics> topicsOf(const AditParams& params) {
  std::vector<tws_runtime::RadarTopics> topics;
  for (const RadarParams& radar : params.radars) topics.push_back(tws_runtime::usualTopics(radar.name));
  return topics;
}

// Radars further apart than this do not see a target in the same polar coordinates.
constexpr double kSameSite = 100.0;  // [m]
// Sectors that wait for the radars' sites: two turns of one radar.
constexpr std::size_t kMostWaiting = 2 * tws::kSectors;

}  // namespace

class AditNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        tracks_(bus.advertise<tws_msgs::Tracks>("/" + bus.name() + "/tracks")),
        clutter_(bus.advertise<tws_msgs::ClutterMap>("/" + bus.name() + "/clutter_map", true)),
        usable_(params_.adit.radars.size()),
        inputs_(
            bus, topicsOf(params_.adit), params_.inputs,
            [this](std::size_t radar, tws::RadarSector sector) { onSector(radar, std::move(sector)); },
            [this](double) { begin(); }) {
    begin();
  }

 private:
  /// A new run: nothing of the old one stays, but for the sites.
  void begin() {
    waiting_.clear();
    totals_ = AditCounts{};
    adit_.emplace(params_.adit, [this](const SectorReport& report) { publish(report); });
  }

  /// Sectors wait, in the order in which they came, until the sites of their radars are known: what comes out does not
  /// depend on when a transform arrives, nor on which radar is heard first.
  void onSector(std::size_t radar, tws::RadarSector sector) {
    waiting_.emplace_back(radar, std::move(sector));
    const bool patient = waiting_.size() <= kMostWaiting;
    if (!origin_ && !findOrigin(patient)) return;
    for (const auto& [waiting, unused] : waiting_) {
      if (!usable_[waiting] && !findSite(waiting, patient)) return;
    }
    for (auto& [ready, its_sector] : waiting_) {
      if (*usable_[ready]) adit_->add(ready, std::move(its_sector));
    }
    waiting_.clear();
    countTroubles();
  }

  std::optional<Site> siteOf(std::size_t radar, std::string& why) const {
    // Before its first message a radar's frame is taken to have its name.
    const std::string& heard = inputs_.frame(radar);
    const std::string& frame = heard.empty() ? params_.adit.radars[radar].name : heard;
    return tws_runtime::findSite(bus_.transforms(), params_.frame, frame, why);
  }

  /// The first radar's site; of the first one that is heard, when the first radar has none.
  bool findOrigin(bool patient) {
    std::string why;
    origin_ = siteOf(0, why);
    if (origin_ || patient) return origin_.has_value();
    origin_ = siteOf(waiting_.front().first, why);
    if (!origin_) origin_ = Site{};
    return true;
  }

  /// False: the radar's sectors wait for its site.
  bool findSite(std::size_t radar, bool patient) {
    std::string why;
    const std::optional<Site> site = siteOf(radar, why);
    if (!site && patient) return false;
    const std::string& name = params_.adit.radars[radar].name;
    if (!site) bus_.counter("unknown sites").add("no transform from " + name + " to " + params_.frame + ": " + why);
    const double distance = site ? std::hypot(site->x - origin_->x, site->y - origin_->y) : 0.0;
    usable_[radar] = distance <= kSameSite;
    if (!*usable_[radar]) {
      bus_.counter("radars at another site")
          .add(name + " stands " + std::to_string(std::lround(distance)) +
               " m from the first radar; its detections are left out");
    }
    return true;
  }

  void publish(const SectorReport& report) {
    tws_msgs::Tracks message;
    message.header.stamp = tws_runtime::toTime(report.enter_time);
    message.header.frame_id = params_.frame;
    message.tracker = bus_.name();
    message.radar = params_.adit.radars[report.radar].name;
    message.running_sector = static_cast<std::uint32_t>(report.running);
    message.sector = static_cast<std::uint8_t>(report.running % tws::kSectors);
    message.sequence = sequence_++;
    for (const TrackWord& word : report.words) {
      message.tracks.push_back(trackMessage(*adit_, word, *origin_));
    }
    tracks_.publish(message);
    if (message.sector == 0) publishClutter(report);
  }

  /// Once a turn of each radar.
  void publishClutter(const SectorReport& report) {
    tws_msgs::ClutterMap message = clutterMessage(*adit_);
    message.header.stamp = tws_runtime::toTime(report.enter_time);
    message.header.frame_id = inputs_.frame(report.radar);
    message.tracker = bus_.name();
    clutter_.publish(message);
  }

  void countTroubles() {
    const AditCounts& now = adit_->counts();
    const auto count = [&](const char* name, std::uint64_t AditCounts::*member, const std::string& reason) {
      for (std::uint64_t n = totals_.*member; n < now.*member; ++n) bus_.counter(name).add(reason);
    };
    count("refused tracks", &AditCounts::refused_tracks,
          "all " + std::to_string(params_.adit.capacity - 1) + " track numbers are in use");
    count("refused clutter points", &AditCounts::refused_clutter, "all clutter numbers are in use");
    count("late sectors", &AditCounts::late_sectors,
          "a radar's data came more than " + std::to_string(params_.adit.skew_limit) + " s after the others'");
    count("rejected plots", &AditCounts::rejected_plots,
          "range, azimuth or time is no number, or range is not in (0, 10000 km]");
    totals_ = now;
  }

  Bus& bus_;
  NodeParams params_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  tws_runtime::Publisher<tws_msgs::ClutterMap> clutter_;
  std::deque<std::pair<std::size_t, tws::RadarSector>> waiting_;
  std::vector<std::optional<bool>> usable_;  // of each radar: does it stand with the first? Nothing: not known yet
  std::optional<Site> origin_;
  std::uint32_t sequence_ = 0;
  AditCounts totals_;
  std::optional<Adit> adit_;
  RadarInputs inputs_;
};

AditNode::AditNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
AditNode::~AditNode() = default;

}  // namespace adit_tracker
