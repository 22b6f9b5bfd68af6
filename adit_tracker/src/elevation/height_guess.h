#pragma once

#include <cmath>

#include <tws_core/earth_plane.h>
#include <tws_core/planar_gaussian.h>

namespace adit_tracker {

/// What radars at different sites need to know of a target's height, which none of them measures. Slant range and
/// ground range differ by it. That does not matter as long as one site alone sees a target; two sites place it
/// differently. So a track carries its height with a variance, and how its own position changes with it; where sites
/// disagree, they tell the height (a Kalman filter with a consider parameter: S. F. Schmidt 1966).
struct HeightGuess {
  float height = 0.0F;                             // above the ellipsoid [m]
  float variance = 0.0F;                           // of it [m²]
  float x_per_height = 0.0F, y_per_height = 0.0F;  // change of the track's position with the height [m/m]

  /// Nothing is known but that targets fly below `greatest` [m], and that radars do not look steeper than 30°.
  static HeightGuess below(double greatest, double slant_range);

  /// Do sites give it to about a kilometre?
  bool known() const;
  /// A track's first plot, under this height: it is the track's place.
  void begin(const tws::PlaceAtHeight& place);
  /// Adds to the covariance of a place what comes of the height: its error moves track and place differently.
  tws::PlanarPosition against(const tws::PlaceAtHeight& place) const;

  /// The covariance of the track's position, with what comes of the height.
  tws::Symmetric2 widened(const tws::Symmetric2& position) const;
  /// The track's displacement, when a height that nobody is sure of is not thought to be steeper than 30° at that slant
  /// range [m] from an antenna at that height [m].
  tws::PlanarPosition flatten(double slant_range, double antenna);
  /// `dt` [s] have passed, in which the target may have climbed.
  void age(double dt, double greatest);
  /// Learns from a place that is used to correct the prediction (both without what comes of the height). Returns by how
  /// much the corrected track is to be moved [m].
  tws::PlanarPosition learn(const tws::PlaceAtHeight& place, const tws::PlanarPosition& predicted, double greatest);
  /// Another guess; returns the track's displacement by it.
  tws::PlanarPosition moveTo(double new_height);
};

}  // namespace adit_tracker
