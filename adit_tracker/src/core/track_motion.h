#pragma once

#include <tws_core/earth_plane.h>
#include <vector>

#include "adit_params.h"
#include "core/candidates.h"
#include "core/fast_share.h"
#include "core/radar_state.h"
#include "core/track.h"

namespace adit_tracker {

/// Position, velocity and, with the turning filter, covariance of (x, y, vx, vy) at one instant.
struct Extrapolation {
  Kinematics kinematics;
  bool has_covariance = false;
  tws::PlanarMotion planar;
};

/// A target that has split from another one, as a radar sees it.
struct Parting {
  std::uint32_t parent;              // slot of the other's track
  double azimuth;                    // of the beam [rad]
  double along, across;              // how far from the other, along the beam and clockwise across it [m]
  double rate_along, rate_across;    // how fast they part [m/s],
  double sigma_along, sigma_across;  // the standard deviations of that
  double chance;                     // that there is such a target: the detection may be a false plot
};

/// How a radar sees a track.
struct ApparentPosition {
  double range, azimuth, azimuth_rate;  // [m], [rad], [rad/s]
};

/// How tracks move: starts, corrects and extrapolates them by the filter that the parameters choose.
class TrackMotion {
 public:
  explicit TrackMotion(const AditParams& params);

  /// Where the radars stand on that plane, one frame a radar, from now on at more than one site. Needs the turning
  /// filter.
  void join(const std::vector<tws::SiteFrame>& frames, const tws::EarthPlane& plane);
  bool joined() const { return joined_; }
  /// Are there volumes with parameters of their own?
  bool hasVolumes() const { return !params_.volumes.empty(); }
  /// By whose parameters the track goes from now on, at its latest place and a height above the antenna [m]; NaN:
  /// unknown. What the filter knows stays.
  void enterVolume(Track& track, double height) const {
    track.volume = params_.volumeAt({track.smoothed.range, track.smoothed.azimuth, height}, track.volume);
  }
  /// Of a track that was started when there was one site.
  void guessHeight(Track& track) const;

  /// Moves a track that has just been started to a place on the plane [m].
  void relocate(Track& track, double x, double y) const;

  /// The origin of the plane moves [m], the track does not. Needs the turning filter.
  void moveOrigin(Track& track, double dx, double dy) const;

  /// The track's first detection: where the plot is, at rest (section "Track Initiation") or with the range rate that
  /// it tells. Returns the logarithm of how much likelier that rate is of a target than of a false plot; 0 without one.
  double start(Track& track, const tws::Plot& plot, const RadarQuality& quality, std::size_t radar = 0) const;

  /// Learns from a track that has become firm how fast targets are, for those that start from now on.
  void learnSpeed(const Track& track);

  /// Corrects by a detection. Returns the natural logarithm of its likelihood [1/m²]; 0 with the α-β filter. Of its
  /// range rate, how much likelier it is than that of a false plot counts.
  double update(Track& track, const tws::Plot& plot, const RadarQuality& quality, std::size_t radar = 0) const;

  /// Corrects by one of several detections or none, nobody knows which, as of `time`, at which the beam met the track.
  /// `missed`: the chance of none. Radars at one site only.
  void update(Track& track, const std::vector<PlotChance>& plots, double missed, double time,
              const RadarQuality& quality) const;

  /// Gives a track that has just started the velocity of another one and what they differ by.
  void branch(Track& track, const Track& parent, const Parting& parting, std::size_t radar) const;

  /// Where the track is at `time`, which may be before the latest update by a little.
  Extrapolation at(const Track& track, double time) const;

  /// Slant range and azimuth of the track's latest state as the radar sees it.
  ApparentPosition apparentPosition(const Track& track, std::size_t radar, double time) const;

  /// Of a plot of another sensor from the track at the plot's time: in standard deviations of both, squared.
  double squaredDistance(const Track& track, const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                         const tws::SiteFrame& site) const;

  /// Sets track.predicted for an illumination by a radar.
  void predict(Track& track, std::size_t radar, double time, const RadarQuality& quality) const;

 private:
  const tws::MultipleModelParams& turningOf(const Track& track) const { return params_.in(track.volume).turning; }
  void updatePolar(Track& track, const tws::Plot& plot) const;
  tws::RangeRate rateOf(const Track& track, double value, const RadarQuality& quality, std::size_t radar) const;
  void predictRate(Track& track, double dt, const RadarQuality& quality) const;
  double updateTurning(Track& track, const tws::Plot& plot, const RadarQuality& quality) const;
  double updateJoined(Track& track, const tws::Plot& plot, const RadarQuality& quality, std::size_t radar) const;
  tws::PlaceAtHeight placeOf(const Track& track, const tws::Plot& plot, const RadarQuality& quality,
                             std::size_t radar) const;
  tws::SiteView view(const Track& track, std::size_t radar, double dt) const;
  void predictJoined(Track& track, const tws::PlanarPosition& there, const RadarQuality& quality) const;

  AditParams params_;
  std::vector<tws::SiteFrame> frames_;  // by radar, when they are at several sites
  std::vector<tws::EarthSite> sites_;   // the same
  tws::EarthPlane plane_;
  bool joined_ = false;  // are they at several sites?
  tws::AdaptiveAlphaBeta alpha_beta_;
  FastShare fast_share_;
};

}  // namespace adit_tracker
