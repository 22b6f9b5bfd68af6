#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/geometry.h>
#include <tws_core/sine_space.h>

#include "array_beam.h"
#include "fault.h"
#include "random_stream.h"
#include "resource_manager.h"
#include "target.h"

namespace radar_sim {

/// One echo as an array measures it.
struct ArrayMeasurement {
  tws::Ruv place;
  Eigen::Matrix3d covariance;  ///< Of (range, u, v) [m, 1].
  double snr;                  ///< Power ratio.
  double rcs;                  ///< What the SNR means for an echo in the beam's centre [m²].
};

struct ArrayDwell {
  PlannedDwell plan;
  double time;                                 ///< Its centre [s of data time].
  std::uint32_t number;                        ///< Running.
  std::vector<ArrayMeasurement> measurements;  ///< In order of range.
};

/// All that an array did in one resource period.
struct ResourcePeriod {
  std::uint32_t number;                       ///< Running.
  double end;                                 ///< [s of data time]
  std::optional<double> next_expected_dwell;  ///< See nextExpectedDwell().
  std::vector<ArrayDwell> dwells;             ///< In order of time.
};

/// A track of the array's tracker, in map coordinates.
struct ArrayTrack {
  std::uint32_t number;
  double time;         ///< At which position and velocity hold [s of data time].
  double last_update;  ///< [s of data time]
  Eigen::Vector3d position;
  Eigen::Vector3d velocity;
  int priority;
  double revisit;  ///< Wanted time between dwells [s]; NaN: the array's own.
};

/// One electronically scanned array at work, resource period by resource period.
///
/// A dwell is one test a range cell: echoes of one dwell that lie within a range cell of the nearest one merge at their
/// centre of power, since one beam does not part them in angle. A target's radar cross-section is drawn anew for each
/// resource period, noise for each dwell. Random numbers come from streams keyed by the seed, the array's name and the
/// target's name, or the dwell: neither another radar nor another target changes them.
class ArrayRadar {
 public:
  /// `map_to_array` takes map coordinates to the array's frame (x along boresight, y left, z up). `targets` must
  /// outlive the radar. `faults` are those of this radar. Throws as SearchRaster.
  ArrayRadar(ArrayParams params, const Eigen::Isometry3d& map_to_array, const std::vector<Target>& targets,
             std::vector<Fault> faults, std::uint64_t seed, double start_time);
  ArrayRadar(const ArrayRadar&) = delete;
  ArrayRadar& operator=(const ArrayRadar&) = delete;

  const ArrayParams& params() const { return params_; }
  const Eigen::Isometry3d& mapToArray() const { return map_to_array_; }
  /// When the running resource period ends [s of data time]: the time of its report.
  double nextReport() const { return timeOf(next_period_ + 1); }
  /// When its dwells are planned: at its begin.
  double planTime() const { return timeOf(next_period_); }

  /// The tracks that dwells are planned by from now on.
  void setTracks(std::vector<ArrayTrack> tracks) { tracks_ = std::move(tracks); }
  ResourcePeriod runPeriod();

  /// During an outage nothing is sent; time goes on.
  bool isSilentAt(double time) const { return isFaulty(faults_, FaultKind::kOutage, time); }
  tws::Ruv placeOf(const Target& target, double time) const;
  /// The same as range, azimuth and elevation at the site.
  tws::Polar polarOf(const Target& target, double time) const;
  /// Chance that a dwell with the target in its beam's centre detects it; 0 out of reach, where the array does not
  /// search, for a target that does not exist, and while the radar is silent or misses scans.
  double detectionProbability(std::size_t target, double time) const;

 private:
  /// Power that comes back, in units of the mean noise power, and from where.
  struct Echo {
    tws::Ruv place;
    double power;
    std::size_t target;  ///< The nearest one, of merged echoes.
  };

  static Echo merged(std::vector<Echo>::const_iterator first, std::vector<Echo>::const_iterator last);

  double timeOf(std::uint32_t period) const { return start_time_ + period * params_.resource_period; }
  bool isBlindAt(double time) const { return isSilentAt(time) || isFaulty(faults_, FaultKind::kMissedScan, time); }
  bool isSearched(const BeamPoint& direction) const;
  bool isInReach(const Target& target, const tws::Ruv& place, double time) const;
  std::vector<SteerableTrack> steerable(double time) const;
  double meanSnr(std::size_t target, const BeamPoint& beam, const tws::Ruv& place) const;
  /// In order of range.
  std::vector<Echo> echoes(const ArrayDwell& dwell) const;
  void drawFalseAlarms(ArrayDwell& dwell) const;
  void measure(ArrayDwell& dwell) const;
  ArrayMeasurement measured(const Echo& echo, const BeamPoint& beam, RandomStream& random) const;

  ArrayParams params_;
  Eigen::Isometry3d map_to_array_;
  const std::vector<Target>& targets_;
  std::vector<Fault> faults_;
  std::uint64_t seed_;
  double start_time_;
  ResourceManager manager_;
  std::vector<std::uint64_t> target_streams_;  ///< Of their cross-sections, by resource period.
  std::vector<std::uint64_t> noise_streams_;   ///< Of the noise on their echoes, by dwell.
  std::vector<double> stated_snr_;             ///< Of targets with a stated detection probability; else NaN.
  std::vector<ArrayTrack> tracks_;
  std::uint32_t next_period_ = 0;
  std::uint32_t dwells_ = 0;
};

}  // namespace radar_sim
