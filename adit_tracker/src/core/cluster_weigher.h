#pragma once

#include <cstdint>
#include <vector>

#include "core/association_chances.h"
#include "core/candidates.h"

namespace adit_tracker {

/// Association by chances (joint integrated probabilistic data association, Musicki & Evans 2004): tracks that compete
/// for detections are weighed together, over all ways to pair them, with the chance that each track's target exists and
/// is detected against the density of false plots at each place. A track alone with its only detection, which is hardly
/// a false one, simply takes it.
class ClusterWeigher {
 public:
  /// Of a radar: two targets within so many metres and radians give one plot with this chance.
  struct Resolution {
    double range, azimuth, merged;
  };

  /// Appends what each primary entry gets to `correlations`, and marks the detections: what is left of them for others,
  /// and who took them. `run`: of the correlator. The candidates of each entry stand together, in order of the entries.
  void weigh(const TrackFile& tracks, std::vector<Entry>& entries, const std::vector<Candidate>& candidates,
             const Resolution& resolution, std::uint64_t run, std::vector<Correlation>& correlations);

  /// What the weighed correlations of the last run refer to.
  const std::vector<PlotChance>& chances() const { return chances_; }

 private:
  /// Of one run.
  struct Run {
    const TrackFile& tracks;
    std::vector<Entry>& entries;
    const std::vector<Candidate>& candidates;
    const Resolution& resolution;
    std::uint64_t number;
    std::vector<Correlation>& correlations;
  };

  /// What the weighing says of one track.
  struct Outcome {
    double existence, missed;  // chances that it is there, and that it is there and made none of its plots
    double hidden;             // the same of "its plot is merged in another firm track's", which no pairing has
    Detection* taken;          // nullptr: none
  };

  void join(const Run& run);
  std::size_t rootOf(std::size_t entry);
  bool takeAlone(const Run& run, Entry& entry);
  void solve(const Run& run, const std::size_t* begin, const std::size_t* end);
  void pair(const Run& run, const std::size_t* begin, const std::size_t* end);
  void hideInOthers(const Run& run, const std::size_t* begin);
  void existAfter(const Run& run, const std::size_t* begin, const std::size_t* end);
  void chooseTakers(const Run& run, const std::size_t* begin);
  void settle(const Run& run, std::size_t entry, const Outcome& outcome, std::size_t& pairing);
  void leaveToOthers(const Run& run, const std::size_t* begin);

  std::vector<std::size_t> roots_, ambiguous_;  // entries
  std::vector<Pairing> pairings_;
  std::vector<Detection*> plots_;
  std::vector<double> spoken_for_;   // of each plot: the chance that one of the tracks made it
  std::vector<std::size_t> claims_;  // pairings
  std::vector<Outcome> outcomes_;    // of the entries
  std::vector<PlotChance> chances_;
  AssociationChances solver_;
};

}  // namespace adit_tracker
