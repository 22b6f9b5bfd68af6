#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <radar_sim/sensor_topics.h>
#include <ros/time.h>
#include <tws_core/geodesy.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/source.h>
#include <yaml-cpp/yaml.h>

namespace radar_sim {

struct Scenario;
struct SensorKind;
class Simulation;

/// The simulator as a source of messages: the truth, what the scenario's sensors report, and their frames. Where a
/// sensor takes commands, its steps wait for them. Parameters (see the README): scenario, seed, duration.
class RadarSimNode : public tws_runtime::Source {
 public:
  /// Throws tws_runtime::ParameterError for a wrong parameter or scenario file.
  explicit RadarSimNode(tws_runtime::Bus& bus);
  /// The same with other kinds of sensors than the package's own.
  RadarSimNode(tws_runtime::Bus& bus, const std::vector<SensorKind>& kinds);
  ~RadarSimNode() override;

  std::optional<ros::Time> nextTime() const override;
  void step() override;
  bool isReady() const override;
  void stopWaiting() override;
  std::optional<ros::Time> endTime() const override;

  /// The topics of the truth and of each sensor, in the scenario's order.
  const std::vector<SensorTopics>& sensors() const { return topics_; }
  /// Data time from start to end [s].
  double duration() const;
  /// Where the map frame lies [rad, m above the sea].
  const tws::Geodetic& origin() const;
  /// What the scenario says of the trackers that it is meant for: the map under its key `trackers` as it stands there,
  /// tracker name → parameters, unchecked. Empty when the key is absent.
  YAML::Node trackers() const;

 private:
  std::unique_ptr<const Scenario> scenario_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<SensorTopics> topics_;
};

}  // namespace radar_sim
