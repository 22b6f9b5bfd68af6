#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

#include <tws_core/antenna.h>
#include <tws_core/range_rate.h>
#include <tws_core/site_frame.h>
#include "adit_params.h"
#include "clutter/false_plot_map.h"
#include "core/coverage_map.h"
#include "core/detection_file.h"
#include "core/passage.h"

namespace adit_tracker {

/// What a radar's plots have shown of its errors and of its false plots. Everything the tracker learns about a radar is
/// here.
class RadarQuality {
 public:
  RadarQuality(const RadarParams& params, bool learn);

  double rangeSigma(const tws::Plot& plot) const;
  double azimuthSigma(const tws::Plot& plot) const;
  double rangeSigma() const { return range_sigma_; }
  double azimuthSigma() const { return azimuth_sigma_; }

  /// Are its range rates of use?
  bool measuresRates() const { return rate_.sigma > 0.0; }
  /// One of its range rates [m/s]; NaN: unknown, as all are of a radar whose rates are of no use, and those that are
  /// mistakes. Place and height are still to be filled in.
  tws::RangeRate rangeRate(double value) const {
    tws::RangeRate rate = rate_;
    if (measuresRates() && std::abs(value) <= kFastestRate) rate.value = value;
    return rate;
  }
  /// Over how many m/s those of its false plots are spread evenly.
  double rateSpan() const { return rate_span_; }

  /// A firm track was updated: innovation in range and cross-range, in standard deviations. Moves the learned sigmas so
  /// that about half of all innovations stay within the median of the normal distribution; that is hardly touched by
  /// manoeuvres.
  void learnErrors(double range_deviation, double cross_range_deviation);

  /// Two targets within one cell gave one plot with this chance, and not two.
  void learnMerging(double merged);
  /// Chance that two targets within one cell give one plot.
  double merging() const { return merging_; }

  /// Its false plots.
  FalsePlotMap& falsePlotMap() { return false_plots_; }
  const FalsePlotMap& falsePlotMap() const { return false_plots_; }

  /// Where it sees targets.
  CoverageMap& coverage() { return coverage_; }
  const CoverageMap& coverage() const { return coverage_; }

  /// What both maps have counted, without the radar's name.
  RadarCounts counts() const;
  /// As if that had been seen on a few looks, less those made already; without problems (see problemOf).
  void load(const RadarCounts& counts);

 private:
  void setGain(double gain);

  double range_sigma_, azimuth_sigma_;
  tws::RangeRate rate_;  // without a value
  double rate_span_;
  double least_range_sigma_, least_azimuth_sigma_, greatest_range_sigma_, greatest_azimuth_sigma_;
  bool learn_;
  double gain_ = 0.0, grown_ = 1.0, shrunk_ = 1.0;
  double merging_ = 0.9;
  FalsePlotMap false_plots_;
  CoverageMap coverage_;
};

/// A sector that has come before its turn.
struct WaitingSector {
  tws::RadarSector sector;
  std::optional<Passage> ship;  // own ship meanwhile, if the radar is on one
};

/// One radar as the tracker sees it.
struct RadarState {
  RadarState(const RadarParams& params, bool learn) : antenna(params.period), quality(params, learn) {}

  tws::Antenna antenna;
  DetectionFile detections;
  RadarQuality quality;
  std::deque<WaitingSector> waiting;
  tws::RadarSector latest;   // of those that are not waiting, as it came; on own ship, or where errors were taken out
  std::optional<Pose> pose;  // when the sector processed last began, on own ship
  tws::SiteFrame frame;
  std::size_t site = 0;
  bool joined = true;  // its site has sectors already
};

}  // namespace adit_tracker
