#pragma once

#include <Eigen/Geometry>
#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include "fault.h"
#include "random_stream.h"
#include "range_radar_params.h"
#include "scatterers.h"
#include "target.h"

namespace radar_sim {

/// The open range gate [m].
struct RangeGate {
  double min = 0.0;
  double max = 0.0;
};

/// |A(r, t)| in the open gate.
struct AmplitudeProfile {
  double time = 0.0;             ///< [s of data time]
  std::uint32_t number = 0;      ///< Running number.
  double range_min = 0.0;        ///< Start of the first bin, a whole number of bins from the radar [m].
  double azimuth = 0.0;          ///< Of the beam [rad].
  std::vector<float> amplitude;  ///< One a bin; squares are radar cross-section [m²].
};

/// One staring radar at work, profile by profile.
///
/// Every scatterer in the beam adds its complex echo, as wide as the resolution; receiver noise and sea clutter add
/// complex Gaussian numbers; the amplitude is the modulus of the sum. A point target of cross-section σ on the beam's
/// axis gives squares that add up to σ: with range R and the middle of the gate at C, to σ·(C/R)⁴, for one factor
/// calibrates a whole profile, so that the receiver's noise is flat over the gate (DDRE A-5/2005, section 2).
///
/// Random numbers come from streams keyed by (seed, radar or radar and target, profile); those of targets do not depend
/// on the gate.
class RangeRadar {
 public:
  /// `targets` must outlive the radar. Throws std::invalid_argument when the target to follow is not among them.
  RangeRadar(RangeRadarParams params, const Eigen::Isometry3d& map_to_site, const std::vector<Target>& targets,
             std::vector<Fault> faults, std::uint64_t seed, double start_time);

  const RangeRadarParams& params() const { return params_; }
  double nextProfile() const { return timeOf(next_); }
  /// For the next profiles. What exceeds the radar's ranges is cut off; a gate that makes no sense is refused: false.
  bool setGate(RangeGate gate);
  AmplitudeProfile takeProfile();
  bool isSilentAt(double time) const { return isFaulty(faults_, FaultKind::kOutage, time); }

 private:
  double timeOf(std::uint32_t profile) const { return start_time_ + profile / params_.profile_rate; }
  void point(double time);
  void openAtStart();
  void addTargets(double time);
  void addEcho(double range, std::complex<double> echo);
  void addNoise(AmplitudeProfile& profile);
  double clutterOn(double patch, double time) const;

  RangeRadarParams params_;
  Eigen::Isometry3d map_to_site_;
  const std::vector<Target>& targets_;
  std::vector<Fault> faults_;
  std::size_t followed_;
  std::uint64_t seed_;
  double start_time_;
  std::uint64_t noise_stream_, clutter_stream_;
  std::vector<Scatterers> scatterers_;  // of each target
  std::uint32_t next_ = 0;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitY();  // of the beam, at the site
  std::int64_t first_bin_ = 0;
  std::vector<std::complex<double>> echo_;  // of each bin of the gate
};

}  // namespace radar_sim
