#include <adit_tracker/adit_node.h>

#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/PlotFates.h>
#include <tws_msgs/RadarMap.h>
#include <tws_msgs/Registration.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/radar_inputs.h>
#include <tws_runtime/track_writer.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "clutter/clutter_interface.h"
#include "core/adit.h"
#include "elevation/elevation_interface.h"
#include "iff/iff_interface.h"
#include "io/own_ship_gate.h"
#include "io/radar_map_message.h"
#include "io/radar_sites.h"
#include "io/registration_message.h"
#include "io/status_report.h"
#include "io/track_messages.h"
#include "io/trouble_report.h"
#include "node_params.h"
#include "operator/operator_interface.h"

namespace adit_tracker {
namespace {

using tws_runtime::Bus;
using tws_runtime::RadarInputs;

// Of the reference radar: there the report sets its status words (ELEV).
constexpr std::int64_t kStatusSector = 61;
constexpr std::int64_t kMapScans = 4;              // of a radar, between two of its maps
constexpr std::int64_t kRegistrationSectors = 32;  // of the reference radar, between two messages

}  // namespace

class AditNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        tracks_(bus, "~tracks", params_.frame),
        clutter_(bus.advertise<tws_msgs::ClutterMap>("~clutter_map", true)),
        maps_(bus.advertise<tws_msgs::RadarMap>("~radar_maps")),
        registration_(bus.advertise<tws_msgs::Registration>("~registration")),
        fates_(bus.advertise<tws_msgs::PlotFates>("~plot_fates")),
        status_(bus.advertise<tws_msgs::TrackerStatus>("~status")),
        elevation_(bus, params_.adit),
        operators_(bus, params_.frame, params_.point_topic, operatorHost()),
        clutter_interface_(bus, operators_, params_.adit, {params_.clutter_map, params_.clutter_map_folder},
                           [this] { return adit_ && adit_->counts().sectors > 0 ? &*adit_ : nullptr; }),
        iff_(bus, params_.frame, params_.adit.iff, params_.inputs.restart_limit),
        sites_(bus, params_.frame, namesOf(params_.adit), joinsSites(params_.adit), params_.adit.map,
               [this](std::size_t radar) -> const std::string& { return inputs_.frame(radar); }),
        own_ship_(bus, params_.frame, params_.own_ship, namesOf(params_.adit),
                  [this](std::size_t radar, tws::RadarSector sector, const Passage& ship) {
                    adit_->add(radar, std::move(sector), ship);
                    scheduleWork(own_ship_.waiting() > 0);  // what waited for a pose is no overload
                  }),
        troubles_(bus, params_.adit, params_.overflow),
        inputs_(
            bus, topicsOf(params_.adit), params_.inputs,
            [this](std::size_t radar, tws::RadarSector sector) { onSector(radar, std::move(sector)); },
            [this](double time) {
              operators_.beginNewRun();
              iff_.beginNewRun(time);
              own_ship_.beginNewRun(time);
              begin();
            }) {
    begin();
    bus.diagnose("tracker", [this] { return diagnosisOf(*adit_, state(bus_.now())); });
  }

 private:
  /// A new run: nothing of the old one stays, but for the sites.
  void begin() {
    sites_.beginNewRun();
    troubles_.beginNewRun();
    heard_.assign(params_.adit.radars.size(), -std::numeric_limits<double>::infinity());
    adit_.emplace(params_.adit, [this](const SectorReport& report) { publish(report); });
    if (params_.plot_fates) adit_->tellPlots([this](const SectorFates& sector) { publishFates(sector); });
    clutter_interface_.beginRun();
    elevation_.begin(*adit_);
  }

  OperatorInterface::Host operatorHost() {
    return {[this](std::string& why) { return caughtUp(why); }, [this]() -> const Site& { return origin(); }};
  }

  /// Of the frame of positions itself, when own ship moves in it.
  const Site& origin() const {
    static const Site kFrame;
    return own_ship_.isOn() ? kFrame : sites_.origin();
  }

  void onSector(std::size_t radar, tws::RadarSector sector) {
    heard_[radar] = sector.leave_time;
    iff_.radarsAt(sector.leave_time);
    if (own_ship_.isOn()) return own_ship_.add(radar, inputs_.frame(radar), std::move(sector));
    // For a site, or to see whether a new run begins: that is no overload.
    const bool all_at_once = sites_.waiting() > 0 || inputs_.intake().isReleasing();
    sites_.add(radar, std::move(sector), [this, radar](tws::RadarSector ready) {
      adit_->standOn(sites_.plane());
      adit_->place(radar, sites_.frame(radar));
      adit_->add(radar, std::move(ready));
    });
    if (sites_.waiting() == 0) scheduleWork(all_at_once);
  }

  void scheduleWork(bool all_at_once) {
    while (all_at_once && workOne()) continue;
    if (!bus_.live()) return work();
    if (!scheduled_) bus_.whenDrained([this] { work(); });
    scheduled_ = true;
  }

  /// Live, one sector at a time, so that what arrives meanwhile is known in between: only then can the lag be seen.
  void work() {
    scheduled_ = false;
    if (bus_.live()) skipWhenOverflowing();
    while (workOne()) {
      if (!bus_.live()) continue;
      scheduled_ = true;
      return bus_.whenDrained([this] { work(); });
    }
    ++operator_calls_;
  }

  bool workOne() {
    operators_.beforeSector(*adit_);
    iff_.handOver(*adit_, sites_);
    if (!adit_->step()) return false;
    afterSector();
    return true;
  }

  void afterSector() {
    troubles_.add(*adit_);
    operators_.afterSector(*adit_);
    if (status_due_) publishStatus(*status_due_);
    status_due_.reset();
  }

  bool endsStatus(const SectorReport& report) const {
    const bool counts =
        report.radar == adit_->radars().reference() || adit_->order().silent(adit_->radars().reference());
    return counts && report.running % tws::kSectors == kStatusSector;
  }

  /// The report's I12DEL: sectors that wait for nothing but the tracker, and the four that it needs ahead.
  std::size_t lag() const {
    const std::vector<std::size_t> ready = adit_->order().ready();
    return kSectorsAhead + *std::max_element(ready.begin(), ready.end());
  }

  void skipWhenOverflowing() {
    if (params_.overflow == 0 || adit_->order().waiting() <= params_.overflow || lag() <= params_.overflow) return;
    const std::uint64_t before = adit_->counts().skipped_sectors;
    adit_->skip();
    skipped_ += static_cast<std::uint32_t>(adit_->counts().skipped_sectors - before);
    afterSector();
  }

  /// What has just come is worked off first, if it is little.
  Adit* caughtUp(std::string& why) {
    constexpr std::size_t kCaughtUp = 5;  // sectors behind the antenna, as in the report
    constexpr int kFew = 8;               // sectors worked off while the operator waits
    for (int i = 0; i < kFew && lag() >= kCaughtUp; ++i) workOne();
    if (adit_->counts().sectors == 0) why = "no sector has been processed yet";
    if (lag() >= kCaughtUp) why = std::to_string(lag()) + " sectors behind the radars; ask again";
    return why.empty() ? &*adit_ : nullptr;
  }

  void publish(const SectorReport& report) {
    tws_msgs::Tracks message =
        tracks_.message(report.enter_time, params_.adit.radars[report.radar].name, report.running);
    for (const TrackUpdate& update : report.updates) {
      message.tracks.push_back(trackMessage(*adit_, update, origin()));
    }
    tracks_.publish(message);
    const std::string& site = inputs_.frame(report.radar);
    if (message.sector == 0) say(clutter_, clutterMessage(*adit_), report, site);
    if (report.running % (kMapScans * tws::kSectors) == 0)
      say(maps_, radarMapMessage(*adit_, report.radar), report, site);
    const bool due = report.radar == adit_->radars().reference() && report.running % kRegistrationSectors == 0;
    if (due && adit_->learnsRegistration()) say(registration_, registrationMessage(*adit_), report, params_.frame);
    elevation_.afterSector(*adit_, report);
    if (endsStatus(report)) status_due_ = report.enter_time;
  }

  void publishFates(const SectorFates& sector) {
    tws_msgs::PlotFates message = fatesMessage(*adit_, sector);
    message.header.frame_id = inputs_.frame(sector.radar);
    message.tracker = bus_.name();
    fates_.publish(message);
  }

  /// What a sector's end brings, in that frame.
  template <class Message>
  void say(tws_runtime::Publisher<Message>& publisher, Message message, const SectorReport& report,
           const std::string& frame) {
    message.header.stamp = tws_runtime::toTime(report.enter_time);
    message.header.frame_id = frame;
    message.tracker = bus_.name();
    publisher.publish(message);
  }

  NodeState state(ros::Time now) {
    NodeState state{operator_calls_, skipped_, bus_.counter("bad detections").value(), {}};
    for (const double heard : heard_) state.silence.push_back(tws_runtime::toSeconds(now) - heard);
    return state;
  }

  void publishStatus(double time) {
    const ros::Time stamp = tws_runtime::toTime(time);
    tws_msgs::TrackerStatus message = statusMessage(*adit_, state(stamp));
    message.header.stamp = stamp;
    message.tracker = bus_.name();
    status_.publish(message);
    operator_calls_ = skipped_ = 0;
  }

  Bus& bus_;
  NodeParams params_;
  tws_runtime::TrackWriter tracks_;
  tws_runtime::Publisher<tws_msgs::ClutterMap> clutter_;
  tws_runtime::Publisher<tws_msgs::RadarMap> maps_;
  tws_runtime::Publisher<tws_msgs::Registration> registration_;
  tws_runtime::Publisher<tws_msgs::PlotFates> fates_;
  tws_runtime::Publisher<tws_msgs::TrackerStatus> status_;
  ElevationInterface elevation_;
  OperatorInterface operators_;
  ClutterInterface clutter_interface_;
  IffInterface iff_;
  RadarSites sites_;
  OwnShipGate own_ship_;
  TroubleReport troubles_;
  std::vector<double> heard_;                       // of each radar: the end of its last sector [s]
  std::uint32_t operator_calls_ = 0, skipped_ = 0;  // since the last status
  std::optional<double> status_due_;                // of this time [s]: it may be one of many sectors skipped at once
  bool scheduled_ = false;                          // work() stands in the queue
  std::optional<Adit> adit_;
  RadarInputs inputs_;
};

AditNode::AditNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
AditNode::~AditNode() = default;

}  // namespace adit_tracker
