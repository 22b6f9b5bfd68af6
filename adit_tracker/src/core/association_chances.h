#pragma once

#include <cstddef>
#include <vector>

namespace adit_tracker {

/// A track may have made a plot.
struct Pairing {
  std::size_t track, plot;  // counted from 0 in each
  double odds;          // the plot is this track's and no false one, against the track having made none of the plots
  double chance = 0.0;  // found: that the plot is this track's
  double claim = 0.0;   // found: the odds at which it is, as far as the track's other plots go: others are not asked
};

/// For tracks and plots of which each has at most one of the other: the chance of each pairing, over all ways to pair
/// them (Williams & Lau, IEEE Trans. AES 50(4), 2014: loopy belief propagation; exact where the pairings form no ring,
/// and closer than a few hundredths where they do).
class AssociationChances {
 public:
  /// Fills `chance` of each pairing. Cost: pairings × iterations, of which there are at most 40.
  void solve(std::vector<Pairing>& pairings);

 private:
  double iterate(const std::vector<Pairing>& pairings);

  std::vector<double> to_track_;  // of each pairing: how free the plot is of other tracks
  std::vector<double> to_plot_;   // of each pairing: how much the track wants the plot
  std::vector<double> track_sums_, plot_sums_;
};

}  // namespace adit_tracker
