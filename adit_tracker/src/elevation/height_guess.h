#pragma once

#include <tws_core/plot.h>

#include <tws_core/multiple_model_filter.h>
#include <tws_core/site_frame.h>

namespace adit_tracker {

/// A plot, or a place where a plot may come from, on the plane, under a guess of the target's height.
struct GuessedPlace {
  tws::PlanarPosition place;            // covariance: of the radar's own errors, or of the prediction
  double x_per_squared, y_per_squared;  // how it changes with the height's square [1/m]
};

/// What radars at different sites need to know of a target's height, which none of them measures. Slant range r and
/// ground range g differ by the height h: g² = r² - h². That does not matter as long as one site alone sees a target;
/// two sites place it differently. So a track carries h² with its variance, and how the track's own position changes
/// with it; where sites disagree, they tell the height (a Kalman filter with a consider parameter: S. F. Schmidt 1966).
/// The earth's curvature is left out: at 150 km it is 1.8 km of height.
struct HeightGuess {
  float squared = 0.0F;   // h² [m²]
  float variance = 0.0F;  // of h² [m⁴]; 0: the height does not count, slant range is laid on the plane
  float x_per_squared = 0.0F, y_per_squared = 0.0F;  // change of the track's position with h² [1/m]

  /// Nothing is known but that targets fly below `greatest` [m], and that radars do not look steeper than 30°.
  static HeightGuess below(double greatest, double slant_range);

  double height() const { return std::sqrt(squared); }
  /// Do sites give it to about a kilometre?
  bool known() const;
  double slantRange(double ground_range) const { return std::sqrt(ground_range * ground_range + squared); }
  GuessedPlace placeOf(const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                       const tws::SiteFrame& site) const;
  /// The same of a track's first plot: it is the track's place.
  tws::PlanarPosition begin(const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                            const tws::SiteFrame& site);
  /// Adds to the covariance of a place what comes of the height: its error moves track and place differently.
  tws::PlanarPosition against(const GuessedPlace& place) const;

  /// The covariance of the track's position, with what comes of the height.
  tws::Symmetric2 widened(const tws::Symmetric2& position) const;
  /// The track's displacement, when a height that nobody is sure of is not thought to be steeper than 30° at that slant
  /// range [m].
  tws::PlanarPosition flatten(double slant_range);
  /// `dt` [s] have passed, in which the target may have climbed.
  void age(double dt, double greatest);
  /// Learns from a place that is used to correct the prediction (both without what comes of the height). Returns by how
  /// much the corrected track is to be moved [m].
  tws::PlanarPosition learn(const GuessedPlace& place, const tws::PlanarPosition& predicted, double greatest);
  /// Another guess; returns the track's displacement by it.
  tws::PlanarPosition moveTo(double new_squared);
};

}  // namespace adit_tracker
