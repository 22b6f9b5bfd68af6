#include "set_metrics.h"

#include <algorithm>
#include <cmath>

namespace track_evaluation {

void SetMetrics::add(const Epoch& epoch, const Distances& distances, const std::vector<std::size_t>& truths,
                     const std::vector<std::size_t>& tracks) {
  addSets(distances, truths, tracks);
  addSiap(epoch, distances, truths, tracks);
}

void SetMetrics::addSets(const Distances& distances, const std::vector<std::size_t>& truths,
                         const std::vector<std::size_t>& tracks) {
  pairs_.clear();
  for (std::uint32_t i = 0; i < truths.size(); ++i) {
    for (std::uint32_t j = 0; j < tracks.size(); ++j) {
      const double distance = distances.at(truths[i], tracks[j]);
      if (distance < cutoff_) pairs_.push_back({i, j, std::pow(distance, order_)});
    }
  }
  const double penalty = std::pow(cutoff_, order_);
  const std::vector<int>& track_of = solver_.solve(pairs_, truths.size(), tracks.size(), penalty);
  const auto n_truths = static_cast<double>(truths.size()), n_tracks = static_cast<double>(tracks.size());
  const double assigned =
      n_truths - static_cast<double>(std::count(track_of.begin(), track_of.end(), tws::AssignmentSolver::kUnassigned));
  last_.localisation = solver_.cost();
  last_.missed = penalty / 2.0 * (n_truths - assigned);
  last_.false_tracks = penalty / 2.0 * (n_tracks - assigned);
  last_.gospa = std::pow(last_.localisation + last_.missed + last_.false_tracks, 1.0 / order_);
  const double larger = std::max(n_truths, n_tracks);
  last_.ospa =
      larger > 0.0 ? std::pow((last_.localisation + penalty * (larger - assigned)) / larger, 1.0 / order_) : 0.0;
  sums_.localisation += last_.localisation;
  sums_.missed += last_.missed;
  sums_.false_tracks += last_.false_tracks;
  sums_.gospa += last_.gospa;
  sums_.ospa += last_.ospa;
}

void SetMetrics::addSiap(const Epoch& epoch, const Distances& distances, const std::vector<std::size_t>& truths,
                         const std::vector<std::size_t>& tracks) {
  held_.assign(truths.size(), false);
  for (const std::size_t track : tracks) {
    const auto nearest = std::min_element(truths.begin(), truths.end(), [&](std::size_t a, std::size_t b) {
      return distances.at(a, track) < distances.at(b, track);
    });
    if (nearest == truths.end() || distances.at(*nearest, track) >= cutoff_) continue;
    held_[static_cast<std::size_t>(nearest - truths.begin())] = true;
    siap_.associated += 1.0;
    siap_.distance += distances.at(*nearest, track);
    const TrackState& its = epoch.tracks[track];
    siap_.speed_error += (comparable(epoch.truths[*nearest], its).velocity - its.state.velocity).norm();
  }
  const auto held = static_cast<double>(std::count(held_.begin(), held_.end(), true));
  const auto n_truths = static_cast<double>(truths.size());
  siap_.epochs += 1.0;
  siap_.truths += n_truths;
  siap_.tracks += static_cast<double>(tracks.size());
  siap_.held += held;
  last_.completeness = ratio(held, n_truths);
}

void SetMetrics::report(MetricList& metrics) const {
  metrics.insert(metrics.end(), {{"epochs", siap_.epochs},
                                 {"ospa_m", ratio(sums_.ospa, siap_.epochs)},
                                 {"gospa_m", ratio(sums_.gospa, siap_.epochs)},
                                 {"gospa_loc", ratio(sums_.localisation, siap_.epochs)},
                                 {"gospa_miss", ratio(sums_.missed, siap_.epochs)},
                                 {"gospa_false", ratio(sums_.false_tracks, siap_.epochs)},
                                 {"completeness", ratio(siap_.held, siap_.truths)},
                                 {"ambiguity", ratio(siap_.associated, siap_.held)},
                                 {"spuriousness", siap_.tracks > 0.0 ? 1.0 - siap_.associated / siap_.tracks : 0.0},
                                 {"pos_accuracy_m", ratio(siap_.distance, siap_.associated)},
                                 {"vel_accuracy_mps", ratio(siap_.speed_error, siap_.associated)}});
}

}  // namespace track_evaluation
