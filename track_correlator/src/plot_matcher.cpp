#include "plot_matcher.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

namespace track_correlator {

PlacedPlot place(const SecondaryPlot& plot, const SecondaryParams& params) {
  return {&plot, tws::unbiasedMeasurement(plot.range, plot.azimuth, params.range_sigma, params.azimuth_sigma)};
}

tws::PlanarState predicted(const SecondaryTrack& track, double time, const SecondaryParams& params) {
  tws::PlanarState state = track.state;
  tws::predict(state, std::max(0.0, time - track.time), params.acceleration_density);
  return state;
}

const std::vector<int>& PlotMatcher::match(const std::vector<const SecondaryTrack*>& tracks,
                                           const std::vector<PlacedPlot>& plots,
                                           const std::vector<const SecondaryTrack*>& neighbours) {
  tracks_ = around_ = tracks;
  around_.insert(around_.end(), neighbours.begin(), neighbours.end());
  plot_of_.assign(tracks.size(), kNone);
  track_of_.assign(plots.size(), kNone);
  listOptions(plots);
  matchUniqueCodes(plots.size());
  matchByPosition(plots.size());
  return plot_of_;
}

void PlotMatcher::listOptions(const std::vector<PlacedPlot>& plots) {
  options_.clear();
  for (std::uint32_t t = 0; t < tracks_.size(); ++t) {
    for (std::uint32_t p = 0; p < plots.size(); ++p) {
      const SecondaryPlot& plot = *plots[p].plot;
      const tws::PlanarState state = predicted(*tracks_[t], plot.time, params_);
      const tws::PlanarInnovation seen = tws::innovation(state, plots[p].measured);
      Agreement agreement = agreementOf(*tracks_[t], plot);
      if (agreement == Agreement::kOtherAircraft) continue;
      if (agreement == Agreement::kOtherCode && garbled(t, plot)) agreement = Agreement::kUnknown;
      const Option option{t, p, agreement, seen.residual.norm(), seen.nis};
      const bool by_code = agreement == Agreement::kSame && option.distance <= params_.code_gate;
      if (by_code || option.innovation <= params_.gate) options_.push_back(option);
    }
  }
}

bool PlotMatcher::garbled(std::size_t track, const SecondaryPlot& plot) const {
  const SecondaryTrack& own = *tracks_[track];
  if (plot.mode_3a.garbled || !mayHideCodeOf(own, plot)) return plot.mode_3a.garbled;
  return std::any_of(around_.begin(), around_.end(), [&](const SecondaryTrack* other) {
    if (other == &own) return false;
    const Eigen::Vector2d where = predicted(*other, plot.time, params_).mean.head<2>();
    return std::abs(where.norm() - plot.range) <= params_.garble_range &&
           std::abs(tws::angularDifference(tws::azimuthOf(where), plot.azimuth)) <= params_.garble_azimuth;
  });
}

void PlotMatcher::matchUniqueCodes(std::size_t plots) {
  std::vector<int> plots_of_track(tracks_.size(), 0), tracks_of_plot(plots, 0);
  for (const Option& option : options_) {
    if (option.agreement != Agreement::kSame) continue;
    ++plots_of_track[option.track];
    ++tracks_of_plot[option.plot];
  }
  for (const Option& option : options_) {
    if (option.agreement != Agreement::kSame || plots_of_track[option.track] != 1 || tracks_of_plot[option.plot] != 1)
      continue;
    plot_of_[option.track] = static_cast<int>(option.plot);
    track_of_[option.plot] = static_cast<int>(option.track);
  }
}

void PlotMatcher::matchByPosition(std::size_t plots) {
  pairs_.clear();
  for (const Option& option : options_) {
    if (plot_of_[option.track] != kNone || track_of_[option.plot] != kNone) continue;
    const double cost = costOf(option);
    if (cost < tws::kForbidden) pairs_.push_back({option.track, option.plot, cost});
  }
  if (pairs_.empty()) return;
  const double miss_cost = params_.gate + params_.different_code_cost;
  const std::vector<int>& answer = solver_.solve(pairs_, tracks_.size(), plots, miss_cost);
  for (std::size_t track = 0; track < tracks_.size(); ++track) {
    if (answer[track] >= 0) plot_of_[track] = answer[track];
  }
}

double PlotMatcher::costOf(const Option& option) const {
  if (option.innovation > params_.gate) return tws::kForbidden;
  if (option.agreement == Agreement::kSame) return option.innovation;
  if (option.agreement == Agreement::kUnknown) return option.innovation + params_.unknown_code_cost;
  // An aircraft may change its code, but a track of a few plots has nothing else to go by.
  if (!tracks_[option.track]->firm) return tws::kForbidden;
  return option.innovation + params_.different_code_cost;
}

}  // namespace track_correlator
