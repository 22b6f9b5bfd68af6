#include <range_gate_tracker/window_tracker_node.h>

#include <geometry_msgs/PointStamped.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/TrackWindows.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/count_report.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/radar_inputs.h>
#include <tws_runtime/request_log.h>
#include <tws_runtime/site_gate.h>
#include <tws_runtime/track_writer.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

#include "window_messages.h"
#include "window_params_reader.h"
#include "window_tracker.h"

namespace range_gate_tracker {
namespace {

using tws_msgs::OperatorRequest;
using tws_runtime::Bus;
using tws_runtime::Site;

struct NodeParams {
  WindowParams tracker;
  std::string radar;
  std::string frame = "map";  // of positions
  tws_runtime::RadarInputs::Options inputs;
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  reader.require("radar");
  reader.text("radar", params.radar);
  params.tracker = readWindowParams(reader);
  reader.text("frame", params.frame);
  reader.number("wait_limit_s", params.inputs.wait_limit, 0.0, 60.0);
  reader.number("restart_limit_s", params.inputs.restart_limit, 0.5, 3600.0);
  reader.done();
  if (params.radar.empty()) reader.fail("radar", "must not be empty");
  try {
    check(params.tracker);
  } catch (const std::invalid_argument& error) {
    throw tws_runtime::ParameterError(bus.name() + ": " + error.what());
  }
  return params;
}

// Sectors that wait for the radar's site: two turns.
constexpr std::size_t kMostWaiting = 128;
// The operator's marker is within this of the radar [m].
constexpr double kFarthest = 1e7;

}  // namespace

class WindowTrackerNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        tracks_(bus, "tws/tracks", params_.frame),
        windows_(bus.advertise<tws_msgs::TrackWindows>("tws/windows")),
        requests_(bus, params_.frame),
        site_gate_(bus, params_.frame, kMostWaiting),
        counts_(bus, {{"refused tracks", &WindowCounts::refused_tracks,
                       "all " + std::to_string(params_.tracker.capacity - 1) + " track numbers are in use"},
                      {"rejected plots", &WindowCounts::rejected_plots,
                       "range, azimuth or time is no number, or range is not above 0"},
                      {"crowded plots", &WindowCounts::crowded_plots,
                       "a sector holds more than " + std::to_string(WindowTracker::kMostPlots) +
                           " plots: no track starts there by itself"}}),
        inputs_(
            bus, {tws_runtime::usualTopics(params_.radar)}, params_.inputs,
            [this](std::size_t, tws::RadarSector sector) { onSector(std::move(sector)); },
            [this](double) {
              requests_.beginNewRun();
              begin();
            }) {
    bus_.subscribe<geometry_msgs::PointStamped>("/clicked_point", [this](const auto& point) { designate(point); });
    bus_.serve<tws_msgs::DropTrack>("tws/drop_track",
                                    [this](auto& request, auto& response) { return drop(request, response); });
    begin();
  }

 private:
  /// A new run: nothing of the old one stays, but for the site.
  void begin() {
    site_gate_.clear();
    counts_.reset();
    processed_.reset();
    tracker_.emplace(params_.tracker, [this](const WindowReport& report) { publish(report); });
  }

  void onSector(tws::RadarSector sector) {
    site_gate_.add(inputs_.frame(0), std::move(sector), [this](const tws::RadarSector& ready) { process(ready); });
  }

  void process(const tws::RadarSector& sector) {
    site_ = site_gate_.site().value_or(Site{});
    tracker_->process(sector);
    processed_ = {params_.radar, sector.running, sector.leave_time};
    repeatRequests();
    counts_.add(tracker_->counts());
  }

  void publish(const WindowReport& report) {
    tws_msgs::Tracks message = tracks_.message(report.enter_time, params_.radar, report.running);
    tws_msgs::TrackWindows windows;
    windows.header.stamp = message.header.stamp;
    windows.header.frame_id = inputs_.frame(0);
    windows.tracker = message.tracker;
    windows.radar = message.radar;
    windows.running_sector = message.running_sector;
    for (const WindowUpdate& update : report.updates) {
      message.tracks.push_back(trackMessage(*tracker_, update, site_, params_.radar));
      windows.windows.push_back(windowMessage(update));
    }
    tracks_.publish(message);
    windows_.publish(windows);
  }

  // ---- the operator -------------------------------------------------------------------------------------------------

  void refuse(const std::string& reason) { bus_.counter("refused requests").add(reason); }

  /// RViz's Publish Point is the target designation marker (Henery 1985, section 2.4.1).
  void designate(const geometry_msgs::PointStamped& point) {
    std::string why;
    const auto frame = tws_runtime::findSite(bus_.transforms(), params_.frame, point.header.frame_id, why);
    const bool here = point.header.frame_id == params_.frame;
    if (!here && !frame) return refuse("/clicked_point in frame '" + point.header.frame_id + "': " + why);
    const Eigen::Vector2d place = toFrame({point.point.x, point.point.y}, here ? Site{} : *frame);
    if (!place.allFinite()) return refuse("/clicked_point is no finite place");
    OperatorRequest request = requests_.blank(OperatorRequest::INITIATE);
    request.position.x = place.x();
    request.position.y = place.y();
    execute(request);
  }

  bool drop(const tws_msgs::DropTrack::Request& asked, tws_msgs::DropTrack::Response& answer) {
    std::vector<OperatorRequest> requests(
        std::max<std::size_t>(asked.numbers.size(), 1),
        requests_.blank(asked.numbers.empty() ? OperatorRequest::DROP_ALL : OperatorRequest::DROP));
    answer.success = true;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      if (!asked.numbers.empty()) requests[i].track = asked.numbers[i];
      execute(requests[i]);
      if (requests[i].result == OperatorRequest::OK) continue;
      answer.message += (answer.success ? "" : "; ") + requests[i].message;
      answer.success = false;
    }
    return true;
  }

  /// It takes effect at once, after the sector that was processed last, and is published with what came of it.
  void execute(OperatorRequest& request) {
    bus_.counter("requests").add();
    request.message = processed_ ? apply(request) : "no sector was processed yet";
    request.result = request.message.empty() ? OperatorRequest::OK : OperatorRequest::REFUSED;
    if (!request.message.empty()) refuse(request.message);
    if (!processed_) return;
    requests_.stamp(request, *processed_);
    requests_.publish(request);
  }

  void repeatRequests() {
    const auto has_passed = [this](const std::string& radar, std::uint32_t running) {
      return radar == processed_->radar &&
             tws_runtime::hasReached(static_cast<std::uint32_t>(processed_->running_sector), running);
    };
    while (auto recorded = requests_.takeDue(has_passed)) {
      OperatorRequest request = *recorded;
      request.tracks.clear();
      execute(request);
      requests_.compare(*recorded, request);
    }
  }

  /// Why it cannot be carried out; empty: it was.
  std::string apply(OperatorRequest& request) {
    const std::string unknown = "there is no track " + std::to_string(request.track);
    switch (request.request) {
      case OperatorRequest::INITIATE:
        return start(fromSite(request.position.x, request.position.y, site_), request);
      case OperatorRequest::DROP:
        return tracker_->cancel(request.track) ? "" : unknown;
      case OperatorRequest::DROP_ALL:
        tracker_->cancelAll();
        return "";
      default:
        return "request " + std::to_string(request.request) + " is not for this tracker";
    }
  }

  std::string start(const Eigen::Vector2d& place, OperatorRequest& request) {
    const double range = place.norm();
    if (!(range > 0.0 && range < kFarthest)) return "the marker stands on the radar, or nowhere";
    const auto number = tracker_->designate(range, tws::azimuthOf(place));
    if (!number) return "all track numbers are in use";
    request.tracks.push_back(*number);
    return "";
  }

  Bus& bus_;
  NodeParams params_;
  tws_runtime::TrackWriter tracks_;
  tws_runtime::Publisher<tws_msgs::TrackWindows> windows_;
  tws_runtime::RequestLog requests_;
  tws_runtime::SiteGate site_gate_;  // sectors wait for it
  tws_runtime::CountReport<WindowCounts> counts_;
  Site site_;
  std::optional<tws_runtime::RequestLog::Moment> processed_;  // the latest sector
  std::optional<WindowTracker> tracker_;
  tws_runtime::RadarInputs inputs_;
};

WindowTrackerNode::WindowTrackerNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
WindowTrackerNode::~WindowTrackerNode() = default;

}  // namespace range_gate_tracker
