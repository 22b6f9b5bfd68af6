#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include <tws_core/geometry.h>
#include <tws_core/plot.h>
#include <tws_core/sectors.h>

#include "beam_crossings.h"
#include "clutter/spoke_feed.h"
#include "elevation_searches.h"
#include "fault.h"
#include "mast.h"
#include "radar_params.h"
#include "resolution.h"
#include "target.h"

namespace radar_sim {

/// One rotating radar at work, sector by sector.
///
/// All random numbers come from streams keyed by the seed, the radar's name and the target's name, or the sector for
/// false alarms, or the clutter's name: neither another radar nor another target changes them (targets closer than the
/// resolution cell do merge).
class RotatingRadar {
 public:
  /// `map_to_site` takes map coordinates to the site's east, north, up. `targets` must outlive the radar. `faults` are
  /// those of this radar. Times in [s of data time].
  RotatingRadar(RadarParams params, const Eigen::Isometry3d& map_to_site, const std::vector<Target>& targets,
                std::vector<Fault> faults, std::uint64_t seed, double start_time);
  RotatingRadar(const RotatingRadar&) = delete;
  RotatingRadar& operator=(const RotatingRadar&) = delete;

  const RadarParams& params() const { return params_; }
  const Antenna& antenna() const { return mast_.antenna(); }

  /// Time of the mark that closes the next sector [s of data time].
  double nextMark() const { return mast_.nextMark(); }
  /// The same as the radar's clock tells it.
  double nextStamp() const { return mast_.nextStamp(); }
  /// Goes on by one sector and returns it. Its times, and those of its plots, are the radar clock's: plots lie within
  /// their sector.
  tws::RadarSector closeSector();

  /// The mark that closes the next sector is the north mark.
  bool isNorthNext() const { return (mast_.nextSector() + 1) % tws::kSectors == 0; }
  /// Takes the elevation searches of the scan that begins with the north mark that comes next, in their order, as many
  /// as it can make. Returns how many it takes.
  std::size_t setElevationSearches(const std::vector<ElevationOrder>& orders);

  /// Lets the radar see that clutter, before the first sector.
  void addClutter(const std::shared_ptr<const ClutterSpec>& clutter);

  /// During an outage there is neither mark nor detection; the antenna still turns.
  bool isSilentAt(double time) const { return isFaulty(faults_, FaultKind::kOutage, time); }
  /// True slant range, azimuth and elevation of a target at the site.
  tws::Polar polarOf(const Target& target, double time) const;
  /// How fast its slant range grows [m/s].
  double rangeRateOf(const Target& target, double time) const;
  /// Chance that the radar would detect the target on one scan, were the beam on it now; 0 outside the instrumented
  /// range, for a target that does not exist, and while the radar is silent or misses scans. `target`: index among the
  /// targets.
  double detectionProbability(std::size_t target, double time) const;
  /// Duration of the revolution that ended with the mark of that running sector; NaN before the first full one [s].
  double rotationPeriod(std::int64_t running_sector) const { return mast_.rotationPeriod(running_sector); }

 private:
  bool isBlindAt(double time) const { return isSilentAt(time) || isFaulty(faults_, FaultKind::kMissedScan, time); }
  bool isInstrumented(double range) const { return range >= params_.min_range && range <= params_.max_range; }
  /// After integration, linear; for a target in reach of `slant_range`.
  double meanSnrOf(std::size_t target, double time, double slant_range) const;
  void illuminateTargets(double until);
  void illuminate(std::size_t target, double time);
  /// The same as polarOf in the antenna's own axes.
  tws::Polar polarAtAntenna(std::size_t target, double time) const;
  /// What the elevation scans that pass over the target see of it; nothing: none do, or they do not detect it.
  std::optional<ElevationLook> lookInElevation(std::size_t target, double time, const tws::Polar& polar) const;
  void raiseFalseAlarms(double until);
  void raiseClutter(double until);
  void drawFalseAlarms(std::int64_t sector, double per_scan, const Fault* burst, const std::string& stream);
  std::vector<Echo> takeEchoes(double until);
  tws::Plot measure(const Echo& echo, const SectorSpan& sector) const;

  RadarParams params_;
  Eigen::Isometry3d map_to_site_, map_to_antenna_;
  const std::vector<Target>& targets_;
  std::vector<Fault> faults_;
  std::uint64_t seed_;
  Mast mast_;
  std::vector<std::uint64_t> target_streams_;
  std::vector<double> stated_snr_;  ///< Of targets with a stated detection probability; else NaN.
  BeamCrossings crossings_;
  ElevationSearches elevation_searches_;
  SpokeFeed clutter_;
  std::int64_t next_false_alarm_sector_;
  std::vector<Echo> pending_;   ///< Detected, their resolution cell still open; in order of time.
  std::vector<Echo> resolved_;  ///< Not yet in a closed sector.
};

}  // namespace radar_sim
