#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include <tws_core/geometry.h>

#include "beam_crossings.h"
#include "fault.h"
#include "illumination.h"
#include "mast.h"
#include "random_stream.h"
#include "reply.h"
#include "secondary_params.h"
#include "target.h"

namespace radar_sim {

/// What the plot extractor makes of one aircraft's replies.
struct SecondaryPlot {
  double time;     ///< The beam was on it [s of data time].
  double range;    ///< Slant range [m], > 0.
  double azimuth;  ///< [rad], [0, 2π).
  std::array<CodeReading, kModes> readings;
};

struct SecondarySector {
  SectorSpan span;
  std::vector<SecondaryPlot> plots;  ///< In order of time.
};

/// One secondary radar at work, sector by sector.
///
/// It asks in the modes of its interlace while the beam is on an aircraft; each reply may be missed, and each that
/// overlaps another aircraft's reply to the same interrogation is garbled. Aircraft whose replies cannot be told apart
/// in range and within the beamwidth give one plot. Random numbers come from streams keyed as those of RotatingRadar.
class SecondaryRadar {
 public:
  /// As RotatingRadar.
  SecondaryRadar(SecondaryParams params, const Eigen::Isometry3d& map_to_site, const std::vector<Target>& targets,
                 std::vector<Fault> faults, std::uint64_t seed, double start_time);
  SecondaryRadar(const SecondaryRadar&) = delete;
  SecondaryRadar& operator=(const SecondaryRadar&) = delete;

  const SecondaryParams& params() const { return params_; }
  const Antenna& antenna() const { return mast_.antenna(); }
  double nextMark() const { return mast_.nextMark(); }
  SecondarySector closeSector();
  bool isSilentAt(double time) const { return isFaulty(faults_, FaultKind::kOutage, time); }
  /// Duration of the revolution that ended with the mark of that running sector; NaN before the first full one [s].
  double rotationPeriod(std::int64_t running_sector) const { return mast_.rotationPeriod(running_sector); }

 private:
  bool isBlindAt(double time) const { return isSilentAt(time) || isFaulty(faults_, FaultKind::kMissedScan, time); }
  bool isInCover(double range, double height) const;
  double beamTime() const { return params_.azimuth_beamwidth / antenna().rate(); }
  /// In the antenna's own axes.
  tws::Polar polarOf(std::size_t target, double time) const;
  Mode modeOf(std::int64_t interrogation) const;
  std::int64_t firstInterrogationAfter(double time) const;

  void illuminate(const BeamCrossings::Crossing& crossing);
  void drawReplies(Illumination& illumination, RandomStream& random) const;
  void extract(double until);
  void drawFruit(std::int64_t sector);
  std::vector<SecondaryPlot> takePlots(const SectorSpan& span, double until);
  SecondaryPlot measured(SecondaryPlot plot, const SectorSpan& span) const;

  SecondaryParams params_;
  Eigen::Isometry3d map_to_antenna_;
  const std::vector<Target>& targets_;
  std::vector<Fault> faults_;
  std::uint64_t seed_;
  double start_time_;
  Mast mast_;
  BeamCrossings crossings_;
  std::vector<std::uint64_t> target_streams_;
  std::deque<Illumination> illuminations_;  ///< In order of time, as long as they may still garble others.
  std::vector<SecondaryPlot> extracted_;    ///< Not yet in a closed sector.
};

}  // namespace radar_sim
