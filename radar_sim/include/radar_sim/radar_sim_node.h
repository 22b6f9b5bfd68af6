#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/time.h>

#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/source.h>
#include <yaml-cpp/yaml.h>

namespace radar_sim {

class ArrayLoop;
struct ArrayReport;
class ElevationLoop;
class RangeLoop;
struct RangeReport;
struct Scenario;
struct SecondarySectorReport;
struct SectorReport;
struct TruthReport;
class Simulation;
class TrackFeed;

/// The simulator as a source of messages: of each radar its detections (a secondary one: plots) and sector marks, the
/// truth, the radars' frames, of an array radar its dwell reports, planned by the track database that it hears, of
/// a range radar its profiles, whose gate goes where it is told to, and where the scenario feeds tracks, these.
/// Parameters (see the README): scenario, seed, duration.
class RadarSimNode : public tws_runtime::Source {
 public:
  /// Throws tws_runtime::ParameterError for a wrong parameter or scenario file.
  explicit RadarSimNode(tws_runtime::Bus& bus);
  ~RadarSimNode() override;

  std::optional<ros::Time> nextTime() const override;
  void step() override;
  bool isReady() const override;
  void stopWaiting() override;
  std::optional<ros::Time> endTime() const override;

  /// Names of the rotating primary radars, in the scenario's order; of the secondary ones; of the arrays.
  std::vector<std::string> radars() const;
  std::vector<std::string> secondaryRadars() const;
  /// Whether the scenario feeds tracks, on /primary/tracks and /secondary/tracks.
  bool feedsTracks() const;
  std::vector<std::string> arrayRadars() const;
  /// Names of those that measure range profiles.
  std::vector<std::string> rangeRadars() const;
  /// Data time from start to end [s].
  double duration() const;
  /// What the scenario says of the trackers that it is meant for: the map under its key `trackers` as it stands there,
  /// tracker name → parameters, unchecked. Empty when the key is absent.
  YAML::Node trackers() const;

 private:
  struct RadarTopics {
    tws_runtime::Publisher<tws_msgs::Detections> detections;
    tws_runtime::Publisher<tws_msgs::SectorMark> marks;
  };
  struct SecondaryTopics {
    tws_runtime::Publisher<tws_msgs::SsrPlots> plots;
    tws_runtime::Publisher<tws_msgs::SectorMark> marks;
  };
  struct Feed {
    std::unique_ptr<TrackFeed> tracks;
    tws_runtime::Publisher<tws_msgs::Tracks> topic;
    std::uint32_t sequence = 0;
  };

  void advertise(tws_runtime::Bus& bus);
  void advertiseFeeds(tws_runtime::Bus& bus);
  void publish(const SectorReport& report);
  void feedTracks(const SectorReport& report);
  void publish(const SecondarySectorReport& report);
  void publish(const ArrayReport& report);
  void publish(const RangeReport& report);
  void publish(const TruthReport& report);

  std::unique_ptr<const Scenario> scenario_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<RadarTopics> radar_topics_;
  std::vector<SecondaryTopics> secondary_topics_;
  std::vector<Feed> feeds_;
  std::deque<ArrayLoop> array_loops_;
  std::deque<RangeLoop> range_loops_;
  std::deque<ElevationLoop> elevation_loops_;
  tws_runtime::Publisher<tws_msgs::Truth> truth_topic_;
};

}  // namespace radar_sim
