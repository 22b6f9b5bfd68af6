#include "core/association_chances.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {
constexpr int kMostIterations = 40;
constexpr double kSettled = 1e-4;
}  // namespace

/// Returns the greatest change.
double AssociationChances::iterate(const std::vector<Pairing>& pairings) {
  std::fill(track_sums_.begin(), track_sums_.end(), 1.0);
  std::fill(plot_sums_.begin(), plot_sums_.end(), 1.0);
  for (std::size_t i = 0; i < pairings.size(); ++i) track_sums_[pairings[i].track] += pairings[i].odds * to_track_[i];
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    to_plot_[i] = pairings[i].odds / (track_sums_[pairings[i].track] - pairings[i].odds * to_track_[i]);
    plot_sums_[pairings[i].plot] += to_plot_[i];
  }
  double change = 0.0;
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    const double next = 1.0 / (plot_sums_[pairings[i].plot] - to_plot_[i]);
    change = std::max(change, std::abs(next - to_track_[i]));
    to_track_[i] = next;
  }
  return change;
}

void AssociationChances::solve(std::vector<Pairing>& pairings) {
  std::size_t tracks = 0, plots = 0;
  for (const Pairing& p : pairings) {
    tracks = std::max(tracks, p.track + 1);
    plots = std::max(plots, p.plot + 1);
  }
  to_track_.assign(pairings.size(), 1.0);
  to_plot_.assign(pairings.size(), 0.0);
  track_sums_.resize(tracks);
  plot_sums_.resize(plots);
  for (int i = 0; i < kMostIterations && iterate(pairings) > kSettled; ++i) continue;
  std::fill(track_sums_.begin(), track_sums_.end(), 1.0);
  for (std::size_t i = 0; i < pairings.size(); ++i) track_sums_[pairings[i].track] += pairings[i].odds * to_track_[i];
  std::fill(plot_sums_.begin(), plot_sums_.end(), 0.0);
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    pairings[i].chance = pairings[i].odds * to_track_[i] / track_sums_[pairings[i].track];
    pairings[i].claim = to_plot_[i];
    plot_sums_[pairings[i].plot] += pairings[i].chance;
  }
  // Where many tracks want few plots, it has not settled by then.
  for (Pairing& p : pairings) p.chance /= std::max(1.0, plot_sums_[p.plot]);
}

}  // namespace adit_tracker
