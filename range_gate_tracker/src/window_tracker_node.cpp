#include <range_gate_tracker/window_tracker_node.h>

#include <geometry_msgs/PointStamped.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/TrackWindows.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/radar_inputs.h>
#include <tws_runtime/sites.h>

#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <stdexcept>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

#include "request_queue.h"
#include "window_messages.h"
#include "window_params_reader.h"
#include "window_tracker.h"

namespace range_gate_tracker {
namespace {

using tws_msgs::OperatorRequest;
using tws_runtime::Bus;
using tws_runtime::Site;

const char* const kRequestTopic = "tws/operator_requests";

struct NodeParams {
  WindowParams tracker;
  std::string radar;
  std::string frame = "map";       // of positions
  bool recorded_requests = false;  // a replay: requests come from the recording, not from the operator
  int request_delay = 8;           // [sectors]
  tws_runtime::RadarInputs::Options inputs;
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  reader.require("radar");
  reader.text("radar", params.radar);
  params.tracker = readWindowParams(reader);
  reader.text("frame", params.frame);
  reader.flag("recorded_requests", params.recorded_requests);
  reader.integer("request_delay_sectors", params.request_delay, 0, 64);
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
        tracks_(bus.advertise<tws_msgs::Tracks>("tws/tracks")),
        windows_(bus.advertise<tws_msgs::TrackWindows>("tws/windows")),
        inputs_(
            bus, {tws_runtime::usualTopics(params_.radar)}, params_.inputs,
            [this](std::size_t, tws::RadarSector sector) { onSector(std::move(sector)); },
            [this](double) { begin(); }) {
    if (params_.recorded_requests)
      bus.subscribe<OperatorRequest>(kRequestTopic, [this](const auto& request) { repeat(request); });
    else
      hearOperator();
    begin();
  }

 private:
  /// A new run: nothing of the old one stays, but for the site.
  void begin() {
    waiting_.clear();
    queue_.clear();
    totals_ = WindowCounts{};
    processed_.reset();
    tracker_.emplace(params_.tracker, [this](const WindowReport& report) { publish(report); });
  }

  void hearOperator() {
    requests_ = bus_.advertise<OperatorRequest>(kRequestTopic);
    bus_.subscribe<geometry_msgs::PointStamped>("/clicked_point", [this](const auto& point) { designate(point); });
    bus_.serve<tws_msgs::DropTrack>("tws/drop_track",
                                    [this](auto& request, auto& response) { return drop(request, response); });
  }

  /// Sectors wait until the site is known, so that what comes out does not depend on when it is told.
  void onSector(tws::RadarSector sector) {
    waiting_.push_back(std::move(sector));
    if (!site_) site_ = tws_runtime::awaitSite(bus_, params_.frame, inputs_.frame(0), waiting_.size() <= kMostWaiting);
    if (!site_) return;
    while (!waiting_.empty()) {
      processed_ = {waiting_.front().running, waiting_.front().leave_time};
      tracker_->process(waiting_.front());
      waiting_.pop_front();
      queue_.release(processed_->running, [this](const auto& request) { obey(request); });
    }
    countTroubles();
  }

  void publish(const WindowReport& report) {
    tws_msgs::Tracks message;
    message.header.stamp = tws_runtime::toTime(report.enter_time);
    message.header.frame_id = params_.frame;
    message.tracker = bus_.name();
    message.radar = params_.radar;
    message.running_sector = static_cast<std::uint32_t>(report.running);
    message.sector = static_cast<std::uint8_t>(report.running % tws::kSectors);
    message.sequence = sequence_++;
    tws_msgs::TrackWindows windows;
    windows.header.stamp = message.header.stamp;
    windows.header.frame_id = inputs_.frame(0);
    windows.tracker = message.tracker;
    windows.radar = message.radar;
    windows.running_sector = message.running_sector;
    for (const WindowWord& word : report.words) {
      message.tracks.push_back(trackMessage(*tracker_, word, *site_, params_.radar));
      windows.windows.push_back(windowMessage(word));
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
    OperatorRequest request = newRequest(OperatorRequest::INITIATE);
    request.position.x = place.x();
    request.position.y = place.y();
    ask(request);
  }

  bool drop(const tws_msgs::DropTrack::Request& asked, tws_msgs::DropTrack::Response& answer) {
    answer.success = processed_.has_value();
    if (!processed_) answer.message = "no sector was processed yet";
    if (asked.numbers.empty()) ask(newRequest(OperatorRequest::DROP_ALL));
    for (const std::uint32_t number : asked.numbers) {
      if (tracker_->tracks().count(number) == 0) {
        answer.success = false;
        answer.message += (answer.message.empty() ? "unknown: " : ", ") + std::to_string(number);
        continue;
      }
      OperatorRequest request = newRequest(OperatorRequest::DROP);
      request.track = number;
      ask(request);
    }
    return true;
  }

  OperatorRequest newRequest(std::uint8_t what) const {
    OperatorRequest request;
    request.header.frame_id = params_.frame;
    request.tracker = bus_.name();
    request.request = what;
    request.radar = params_.radar;
    request.lower = request.upper = std::numeric_limits<double>::quiet_NaN();
    return request;
  }

  /// It takes effect a few sectors later, and is told at once: so a replay has it in time, wherever it comes in.
  void ask(OperatorRequest request) {
    if (!processed_) return refuse("no sector was processed yet");
    request.header.stamp = tws_runtime::toTime(processed_->leave_time);
    request.running_sector = static_cast<std::uint32_t>(processed_->running + params_.request_delay);
    requests_.publish(request);
    queue_.add(request, processed_->running);
    bus_.counter("requests").add();
  }

  void repeat(const OperatorRequest& request) {
    if (request.tracker != bus_.name() || request.radar != params_.radar) return;
    bus_.counter("requests").add();
    if (!queue_.add(request, processed_ ? processed_->running : 0))
      bus_.counter("late requests").add("sector " + std::to_string(request.running_sector) + " was processed already");
  }

  void obey(const OperatorRequest& request) {
    switch (request.request) {
      case OperatorRequest::INITIATE:
        return start(fromSite(request.position.x, request.position.y, *site_));
      case OperatorRequest::DROP:
        if (!tracker_->cancel(request.track)) refuse("there is no track " + std::to_string(request.track));
        return;
      case OperatorRequest::DROP_ALL:
        return tracker_->cancelAll();
      default:
        return refuse("request " + std::to_string(request.request) + " is not for this tracker");
    }
  }

  void start(const Eigen::Vector2d& place) {
    const double range = place.norm();
    if (!(range > 0.0 && range < kFarthest)) return refuse("the marker stands on the radar, or nowhere");
    tracker_->designate(range, tws::azimuthOf(place));
  }

  void countTroubles() {
    const WindowCounts& now = tracker_->counts();
    for (auto n = totals_.refused_tracks; n < now.refused_tracks; ++n)
      bus_.counter("refused tracks")
          .add("all " + std::to_string(params_.tracker.capacity - 1) + " track numbers are in use");
    for (auto n = totals_.rejected_plots; n < now.rejected_plots; ++n)
      bus_.counter("rejected plots").add("range, azimuth or time is no number, or range is not above 0");
    totals_ = now;
  }

  struct Processed {
    std::int64_t running;
    double leave_time;  // [s]
  };

  Bus& bus_;
  NodeParams params_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  tws_runtime::Publisher<tws_msgs::TrackWindows> windows_;
  tws_runtime::Publisher<OperatorRequest> requests_;
  std::deque<tws::RadarSector> waiting_;
  std::optional<Site> site_;
  std::optional<Processed> processed_;  // the latest sector
  RequestQueue queue_;
  std::uint32_t sequence_ = 0;
  WindowCounts totals_;
  std::optional<WindowTracker> tracker_;
  tws_runtime::RadarInputs inputs_;
};

WindowTrackerNode::WindowTrackerNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
WindowTrackerNode::~WindowTrackerNode() = default;

}  // namespace range_gate_tracker
