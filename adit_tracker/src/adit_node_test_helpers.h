#pragma once

#include <adit_tracker/adit_node.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/InitiateTrack.h>
#include <tws_msgs/OperatorCommand.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/PlotFates.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/TrackerStatus.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "core/adit_test_helpers.h"

namespace adit_tracker {

constexpr double kEpoch = 1000.0;  // data time of the flights' beginning [s]

/// The node in one process, and radars r0 and r1 of 6 and 8 s that this test plays.
class NodeGraph {
 public:
  explicit NodeGraph(const std::string& parameters = "{}") {
    YAML::Node tree = YAML::Load(parameters);
    if (!tree["radars"]) tree["radars"] = YAML::Load("[{name: r0, period_s: 6}, {name: r1, period_s: 8}]");
    bus = &graph.addNode("adit", tree);
    node_ = std::make_unique<AditNode>(*bus);
    tws_runtime::Bus& ear = graph.addNode("ear");
    ear.subscribe<tws_msgs::Tracks>("/adit/tracks", [this](const auto& m) { tracks.push_back(m); });
    ear.subscribe<tws_msgs::OperatorRequest>("/adit/operator_requests", [this](const auto& m) { told.push_back(m); });
    ear.subscribe<tws_msgs::TrackerStatus>("/adit/status", [this](const auto& m) { statuses.push_back(m); });
    ear.subscribe<tws_msgs::PlotFates>("/adit/plot_fates", [this](const auto& m) { fates.push_back(m); });
    recorded = ear.advertise<tws_msgs::OperatorRequest>("/adit/recorded_requests");
    points = ear.advertise<geometry_msgs::PointStamped>("/clicked_point");
    for (std::size_t r = 0; r < 2; ++r) {
      tws_runtime::Bus& radar = graph.addNode(name(r));
      detections_.push_back(radar.advertise<tws_msgs::Detections>("/" + name(r) + "/detections"));
      marks_.push_back(radar.advertise<tws_msgs::SectorMark>("/" + name(r) + "/sector_marks"));
      geometry_msgs::TransformStamped site;
      site.header.frame_id = "map";
      site.child_frame_id = name(r);
      site.transform.translation.x = kEast;
      site.transform.rotation.w = 1.0;
      radar.publishStaticTransform(site);
    }
    graph.drain();
  }

  static std::string name(std::size_t radar) { return "r" + std::to_string(radar); }

  /// Publishes the sectors that close after `from` and not after `to` [s of the flights], in order of the time at which
  /// they come.
  void play(const RadarSectors& radars, double from, double to) {
    std::vector<std::tuple<double, std::size_t, const tws::RadarSector*>> order;
    for (std::size_t r = 0; r < radars.size(); ++r) {
      for (const tws::RadarSector& sector : radars[r]) {
        if (sector.leave_time > from && sector.leave_time <= to) order.emplace_back(sector.leave_time, r, &sector);
      }
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
    for (const auto& [time, radar, sector] : order) send(radar, *sector);
  }

  /// `clock_error` of the radar's clock when it stamps [s].
  void send(std::size_t radar, const tws::RadarSector& sector, double clock_error = 0.0) {
    tws::RadarSector stamped = sector;
    stamped.enter_time += kEpoch + clock_error;
    stamped.leave_time += kEpoch + clock_error;
    for (tws::Plot& plot : stamped.plots) plot.time += kEpoch + clock_error;
    graph.advanceTo(tws_runtime::toTime(stamped.leave_time));
    detections_[radar].publish(tws_runtime::toDetections(stamped, name(radar), name(radar)));
    tws_msgs::SectorMark mark;
    mark.header.stamp = tws_runtime::toTime(stamped.leave_time);
    mark.header.frame_id = mark.radar = name(radar);
    mark.running_sector = static_cast<std::uint32_t>(sector.running + 1);
    mark.sector = static_cast<std::uint8_t>(mark.running_sector % 64);
    mark.closed_sector = static_cast<std::uint8_t>(sector.sector);
    mark.closed_count = static_cast<std::uint32_t>(sector.plots.size());
    mark.rotation_period = radar == 0 ? 6.0 : 8.0;
    marks_[radar].publish(mark);
    graph.drain();
  }

  tws_msgs::OperatorCommand::Response ask(std::uint8_t request, std::uint32_t track = 0, double from = std::nan(""),
                                          double to = std::nan("")) {
    tws_msgs::OperatorCommand::Request command;
    tws_msgs::OperatorCommand::Response answer;
    command.request = request;
    command.track = track;
    command.lower = from;
    command.upper = to;
    graph.call<tws_msgs::OperatorCommand>("/adit/operator_command", command, answer);
    return answer;
  }

  tws_msgs::InitiateTrack::Response initiate(double x, double y, const std::string& frame = "map") {
    tws_msgs::InitiateTrack::Request request;
    tws_msgs::InitiateTrack::Response answer;
    request.point.header.frame_id = frame;
    request.point.point.x = x;
    request.point.point.y = y;
    graph.call<tws_msgs::InitiateTrack>("/adit/initiate_track", request, answer);
    return answer;
  }

  tws_msgs::DropTrack::Response drop(const std::vector<std::uint32_t>& numbers) {
    tws_msgs::DropTrack::Request request;
    tws_msgs::DropTrack::Response answer;
    request.numbers = numbers;
    graph.call<tws_msgs::DropTrack>("/adit/drop_track", request, answer);
    return answer;
  }

  std::uint64_t count(const std::string& counter) { return bus->counter(counter).value(); }

  std::vector<tws_msgs::Track> updates() const {
    std::vector<tws_msgs::Track> all;
    for (const auto& message : tracks) all.insert(all.end(), message.tracks.begin(), message.tracks.end());
    return all;
  }

  /// The latest update of each track that has not been dropped, by its identity.
  std::map<std::uint32_t, tws_msgs::Track> picture() const {
    std::map<std::uint32_t, tws_msgs::Track> latest;
    for (const tws_msgs::Track& update : updates()) {
      if (update.state == tws_msgs::Track::DROPPED)
        latest.erase(update.uid);
      else
        latest[update.uid] = update;
    }
    return latest;
  }

  /// Identities of the tracks that the picture shows as believed.
  std::set<std::uint32_t> confirmed() const {
    std::set<std::uint32_t> uids;
    for (const auto& [uid, update] : picture())
      if (update.state == tws_msgs::Track::FIRM || update.state == tws_msgs::Track::COASTING) uids.insert(uid);
    return uids;
  }

  template <class M>
  static std::string bytesOf(const std::vector<M>& messages) {
    std::ostringstream text;
    for (const M& message : messages) text << message;
    return text.str();
  }

  static constexpr double kEast = 5000.0;  // where the radars stand [m]

  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  tws_runtime::Bus* bus = nullptr;
  std::vector<tws_msgs::Tracks> tracks;
  std::vector<tws_msgs::OperatorRequest> told;
  std::vector<tws_msgs::TrackerStatus> statuses;
  std::vector<tws_msgs::PlotFates> fates;
  tws_runtime::Publisher<tws_msgs::OperatorRequest> recorded;
  tws_runtime::Publisher<geometry_msgs::PointStamped> points;

 private:
  std::vector<tws_runtime::Publisher<tws_msgs::Detections>> detections_;
  std::vector<tws_runtime::Publisher<tws_msgs::SectorMark>> marks_;
  std::unique_ptr<AditNode> node_;
};

/// What both radars see of some flights up to that time [s].
inline RadarSectors flights(double to, const std::vector<TestTarget>& targets) {
  const TestRadar first(6.0), second(8.0, 0.5);
  RadarSectors radars = {first.sectors(0.0, to), second.sectors(0.0, to)};
  for (const TestTarget& target : targets) {
    first.see(target, radars[0]);
    second.see(target, radars[1]);
  }
  return radars;
}

/// Eight aircraft in all directions.
inline std::vector<TestTarget> eightAircraft() {
  std::vector<TestTarget> targets;
  for (int i = 0; i < 8; ++i) {
    const double azimuth = tws::radians(45.0 * i + 10.0), course = tws::radians(100.0 * i), range = 40e3 + 8e3 * i;
    targets.push_back(
        {range * std::sin(azimuth), range * std::cos(azimuth), 180.0 * std::sin(course), 180.0 * std::cos(course)});
  }
  return targets;
}

}  // namespace adit_tracker
