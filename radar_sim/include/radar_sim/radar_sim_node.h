#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/time.h>

#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/source.h>

namespace radar_sim {

struct Scenario;
struct SectorReport;
struct TruthReport;
class Simulation;

/// The simulator as a source of messages: of each radar its detections and sector marks, the truth, and the radars'
/// frames. Parameters (see the README): scenario, seed, duration.
class RadarSimNode : public tws_runtime::Source {
 public:
  /// Throws tws_runtime::ParameterError for a wrong parameter or scenario file.
  explicit RadarSimNode(tws_runtime::Bus& bus);
  ~RadarSimNode() override;

  std::optional<ros::Time> nextTime() const override;
  void step() override;
  std::optional<ros::Time> endTime() const override;

  /// Names of the rotating radars, in the scenario's order.
  std::vector<std::string> radars() const;
  /// Data time from start to end [s].
  double duration() const;

 private:
  struct RadarTopics {
    tws_runtime::Publisher<tws_msgs::Detections> detections;
    tws_runtime::Publisher<tws_msgs::SectorMark> marks;
  };

  void advertise(tws_runtime::Bus& bus);
  void publish(const SectorReport& report);
  void publish(const TruthReport& report);

  std::unique_ptr<const Scenario> scenario_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<RadarTopics> radar_topics_;
  tws_runtime::Publisher<tws_msgs::Truth> truth_topic_;
};

}  // namespace radar_sim
