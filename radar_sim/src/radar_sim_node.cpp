#include <radar_sim/radar_sim_node.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <tws_runtime/conversions.h>
#include <tws_runtime/parameters.h>

#include "array_loop.h"
#include "conversions.h"
#include "elevation_loop.h"
#include "range_loop.h"
#include "scenario.h"
#include "simulation.h"
#include "track_feed.h"
#include "track_feed_messages.h"

namespace radar_sim {
namespace {

Scenario readParameters(tws_runtime::Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  std::string file;
  long seed = 0;
  double duration = 0.0;
  reader.require("scenario");
  reader.text("scenario", file);
  reader.integer("seed", seed, 0, std::numeric_limits<long>::max());
  reader.number("duration", duration, 1.0, 1e6);
  reader.done();
  ScenarioOverrides overrides;
  if (reader.has("seed")) overrides.seed = static_cast<std::uint64_t>(seed);
  if (reader.has("duration")) overrides.duration = duration;
  return loadScenario(file, overrides);
}

std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const std::string& file) {
  try {
    return std::make_unique<Simulation>(scenario);
  } catch (const std::invalid_argument& error) {
    throw tws_runtime::ParameterError(file + ": " + error.what());
  }
}

template <class Params>
std::vector<std::string> namesOf(const std::vector<Params>& radars) {
  std::vector<std::string> names;
  for (const Params& radar : radars) names.push_back(radar.name);
  return names;
}

}  // namespace

RadarSimNode::RadarSimNode(tws_runtime::Bus& bus)
    : scenario_(std::make_unique<Scenario>(readParameters(bus))),
      simulation_(makeSimulation(*scenario_, bus.parameters()["scenario"].as<std::string>())) {
  advertise(bus);
  advertiseFeeds(bus);
}

RadarSimNode::~RadarSimNode() = default;

void RadarSimNode::advertise(tws_runtime::Bus& bus) {
  truth_topic_ = bus.advertise<tws_msgs::Truth>("/truth");
  for (const RadarParams& radar : scenario_->radars) {
    radar_topics_.push_back({bus.advertise<tws_msgs::Detections>("/" + radar.name + "/detections"),
                             bus.advertise<tws_msgs::SectorMark>("/" + radar.name + "/sector_marks")});
    bus.publishStaticTransform(toTransform(mapToRadar(*scenario_, radar), radar.name));
    if (radar.elevation_search) elevation_loops_.emplace_back(bus, *simulation_, radar_topics_.size() - 1);
  }
  for (const SecondaryParams& radar : scenario_->secondary_radars) {
    secondary_topics_.push_back({bus.advertise<tws_msgs::SsrPlots>("/" + radar.name + "/plots"),
                                 bus.advertise<tws_msgs::SectorMark>("/" + radar.name + "/sector_marks")});
    bus.publishStaticTransform(toTransform(mapToRadar(*scenario_, radar), radar.name));
  }
  for (std::size_t i = 0; i < simulation_->arrayRadars().size(); ++i) {
    array_loops_.emplace_back(bus, *simulation_, i);
    const ArrayRadar& radar = simulation_->arrayRadars()[i];
    bus.publishStaticTransform(toTransform(radar.mapToArray(), radar.params().name));
  }
  for (std::size_t i = 0; i < simulation_->rangeRadars().size(); ++i) {
    range_loops_.emplace_back(bus, *simulation_, i);
    const RangeRadarParams& radar = scenario_->range_radars[i];
    bus.publishStaticTransform(toTransform(mapToRadar(*scenario_, radar), radar.name));
  }
}

void RadarSimNode::advertiseFeeds(tws_runtime::Bus& bus) {
  if (!feedsTracks()) return;
  for (const RadarParams& radar : scenario_->radars) {
    if (radar.name != scenario_->track_feed->clock_radar) continue;
    for (const FeedKind kind : {FeedKind::kPrimary, FeedKind::kSecondary})
      feeds_.push_back({std::make_unique<TrackFeed>(kind, *scenario_->track_feed, mapToRadar(*scenario_, radar),
                                                    simulation_->targets(), scenario_->seed),
                        bus.advertise<tws_msgs::Tracks>("/" + nameOf(kind) + "/tracks")});
  }
}

std::optional<ros::Time> RadarSimNode::nextTime() const {
  const std::optional<double> time = simulation_->nextTime();
  return time ? std::optional<ros::Time>(tws_runtime::toTime(*time)) : std::nullopt;
}

std::optional<ros::Time> RadarSimNode::endTime() const { return tws_runtime::toTime(scenario_->endTime()); }

std::vector<std::string> RadarSimNode::radars() const { return namesOf(scenario_->radars); }

std::vector<std::string> RadarSimNode::secondaryRadars() const { return namesOf(scenario_->secondary_radars); }

bool RadarSimNode::feedsTracks() const { return scenario_->track_feed.has_value(); }

std::vector<std::string> RadarSimNode::arrayRadars() const { return namesOf(scenario_->array_radars); }

std::vector<std::string> RadarSimNode::rangeRadars() const { return namesOf(scenario_->range_radars); }

double RadarSimNode::duration() const { return scenario_->duration; }

YAML::Node RadarSimNode::trackers() const { return scenario_->trackers; }

bool RadarSimNode::isReady() const {
  const auto isReady = [](const auto& loop) { return loop.isReady(); };
  return std::all_of(array_loops_.begin(), array_loops_.end(), isReady) &&
         std::all_of(range_loops_.begin(), range_loops_.end(), isReady) &&
         std::all_of(elevation_loops_.begin(), elevation_loops_.end(), isReady);
}

void RadarSimNode::stopWaiting() {
  for (ArrayLoop& loop : array_loops_) loop.stopWaiting();
  for (RangeLoop& loop : range_loops_) loop.stopWaiting();
  for (ElevationLoop& loop : elevation_loops_) loop.stopWaiting();
}

void RadarSimNode::step() {
  for (ArrayLoop& loop : array_loops_) loop.prepareStep();
  for (RangeLoop& loop : range_loops_) loop.prepareStep();
  for (ElevationLoop& loop : elevation_loops_) loop.prepareStep();
  std::visit([this](const auto& report) { publish(report); }, simulation_->step());
}

void RadarSimNode::publish(const SectorReport& report) {
  const std::string& radar = simulation_->radars()[report.radar].params().name;
  radar_topics_[report.radar].detections.publish(tws_runtime::toDetections(report.sector, radar, radar));
  feedTracks(report);
  for (ElevationLoop& loop : elevation_loops_) loop.hearMark(report);
  radar_topics_[report.radar].marks.publish(toSectorMark(report, *simulation_));
}

void RadarSimNode::feedTracks(const SectorReport& report) {
  const RadarParams& radar = simulation_->radars()[report.radar].params();
  for (Feed& feed : feeds_) {
    if (radar.name != feed.tracks->params().clock_radar) continue;
    tws_msgs::Tracks message = toTracks(*feed.tracks, feed.tracks->tracksOf(report.sector), report.sector,
                                        simulation_->targets(), radar.antenna_height);
    message.sequence = feed.sequence++;
    feed.topic.publish(message);
  }
}

void RadarSimNode::publish(const SecondarySectorReport& report) {
  const std::string& radar = simulation_->secondaryRadars()[report.radar].params().name;
  secondary_topics_[report.radar].plots.publish(toSsrPlots(report.sector, radar));
  secondary_topics_[report.radar].marks.publish(toSectorMark(report, *simulation_));
}

void RadarSimNode::publish(const ArrayReport& report) { array_loops_[report.radar].publish(report.period); }

void RadarSimNode::publish(const RangeReport& report) { range_loops_[report.radar].publish(report.profile); }

void RadarSimNode::publish(const TruthReport& report) { truth_topic_.publish(toTruth(report, *simulation_)); }

}  // namespace radar_sim
