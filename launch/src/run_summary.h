#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/time.h>
#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/counters.h>

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "track_census.h"

namespace tws_launch {

/// What happened in a run, counted from its messages in the order of their recording.
class RunSummary {
 public:
  /// Counts all that a bag holds. Throws std::runtime_error that names the file when it cannot be read.
  static RunSummary ofBag(const std::string& path);

  void add(const tws_msgs::Detections& message);
  void add(const tws_msgs::DwellReports& message);
  void add(const tws_msgs::RangeProfile& message);
  void add(const tws_msgs::Tracks& message);
  void add(const tws_msgs::CorrelatedTracks& message);
  void add(const tws_msgs::ClutterMap& message);
  /// The counters of the nodes, as their diagnostics say them; the latest value of each counts.
  void add(const diagnostic_msgs::DiagnosticArray& message);

  /// Data time from the first sensor message to the last [s]; 0 without any.
  double simulatedTime() const;
  /// Of rotating radars, measurements of arrays, and range profiles.
  std::uint64_t plots() const;
  /// Tracks that have not been dropped: those of the correlator where there is one, else of all trackers.
  std::size_t livingTracks() const;
  /// From the first sensor message to the trackers' last word [s of data time]; 0 without any.
  double trackedTime() const;
  /// Why the run was in vain, what was in it and what to do, in one line; empty: something was tracked, to the end.
  std::string failure() const;
  /// The counters as the diagnostics said them.
  std::vector<tws_runtime::CounterReading> counters() const;
  /// A table for people, with those of the `counters` that are not zero. `wall_time` [s], when known.
  void print(std::ostream& out, const std::vector<tws_runtime::CounterReading>& counters,
             std::optional<double> wall_time) const;

 private:
  struct Radar {
    std::uint64_t sectors = 0;
    std::uint64_t plots = 0;
  };
  struct Array {
    std::uint64_t periods = 0;
    std::uint64_t dwells = 0, track_dwells = 0;
    std::uint64_t measurements = 0;
  };
  struct Staring {
    std::uint64_t profiles = 0;
    std::uint64_t bins = 0;
  };
  struct Tracker {
    TrackCensus census;
    std::map<std::string, ros::Time> processed;  ///< The last sector, or the like, of each radar.
    ros::Time newest;                            ///< Of this run.
    std::size_t clutter_points = 0;
  };
  struct Correlator {
    TrackCensus census;                          ///< By the correlator's own identities.
    std::map<std::uint32_t, std::uint8_t> kind;  ///< Of each living one.
  };

  void printRadars(std::ostream& out) const;
  void printArrays(std::ostream& out) const;
  void printStaring(std::ostream& out) const;
  void printTrackers(std::ostream& out) const;
  void printCorrelator(std::ostream& out) const;

  void beAlive(const std::string& radar, ros::Time stamp);
  std::string silence() const;
  std::string sensorNames() const;
  std::size_t begunTracks() const;
  bool hasConfirmed() const;

  ros::Time first_;
  ros::Time last_;
  ros::Time last_tracked_;
  std::map<std::string, ros::Time> spoken_;  ///< The last sensor message of each radar.
  std::map<std::string, Radar> radars_;
  std::map<std::string, Array> arrays_;
  std::map<std::string, Staring> staring_;
  std::map<std::string, Tracker> trackers_;
  std::optional<Correlator> correlator_;
  std::map<std::string, std::map<std::string, std::uint64_t>> counters_;
};

}  // namespace tws_launch
