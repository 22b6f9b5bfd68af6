#include "core/radar_state.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr double kMedianOfNormal = 0.6745;  // half of all normal deviates are within it
// The innovation of several models has more weight in the middle than a normal one of the same variance has; this share
// is within the median in its place. Too large a sigma costs a little accuracy, too small a one costs tracks.
constexpr double kWithin = 0.55;
constexpr double kLeastGain = 0.002;

}  // namespace

RadarQuality::RadarQuality(const RadarParams& params, bool learn)
    : range_sigma_(params.range_sigma),
      azimuth_sigma_(params.azimuth_sigma),
      rate_span_(params.range_rate_span),
      least_range_sigma_(0.1 * params.range_sigma),
      least_azimuth_sigma_(0.05 * params.azimuth_sigma),
      greatest_range_sigma_(5.0 * params.range_sigma),
      greatest_azimuth_sigma_(5.0 * params.azimuth_sigma),
      learn_(learn) {
  setGain(0.03);
  rate_.sigma = params.range_rate_sigma;
  rate_.ambiguity = params.range_rate_ambiguity;
  if (rate_.ambiguity > 0.0) rate_span_ = std::min(rate_span_, rate_.ambiguity);
}

void RadarQuality::setGain(double gain) {
  if (gain == gain_) return;
  gain_ = gain;
  grown_ = std::exp(gain * kWithin);
  shrunk_ = std::exp(gain * (kWithin - 1.0));
}

double RadarQuality::rangeSigma(const tws::Plot& plot) const {
  return std::isnan(plot.range_sigma) ? range_sigma_ : plot.range_sigma;
}

double RadarQuality::azimuthSigma(const tws::Plot& plot) const {
  return std::isnan(plot.azimuth_sigma) ? azimuth_sigma_ : plot.azimuth_sigma;
}

void RadarQuality::learnErrors(double range_deviation, double cross_range_deviation) {
  if (!learn_) return;
  const auto factor = [&](double deviation) { return std::abs(deviation) > kMedianOfNormal ? grown_ : shrunk_; };
  range_sigma_ = std::clamp(range_sigma_ * factor(range_deviation), least_range_sigma_, greatest_range_sigma_);
  azimuth_sigma_ =
      std::clamp(azimuth_sigma_ * factor(cross_range_deviation), least_azimuth_sigma_, greatest_azimuth_sigma_);
  setGain(std::max(kLeastGain, 0.985 * gain_));
}

void RadarQuality::learnMerging(double merged) {
  constexpr double kGain = 0.02;
  merging_ += kGain * (merged - merging_);
}

RadarCounts RadarQuality::counts() const {
  RadarCounts counts;
  false_plots_.save(counts);
  coverage_.save(counts);
  return counts;
}

void RadarQuality::load(const RadarCounts& counts) {
  false_plots_.load(counts);
  coverage_.load(counts);
}

}  // namespace adit_tracker
