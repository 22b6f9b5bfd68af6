#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tws_core/plot.h>

#include "track_window.h"

namespace range_gate_tracker {

struct TrackFile;

/// Finds the tracks that may have a plot in one of their windows, without a look at the others: a map of cells of 4 km
/// by 11°, each with the tracks whose windows reach into it.
class WindowIndex {
 public:
  WindowIndex() : cells_(std::size_t{kRanges} * kAzimuths) {}

  /// The track stays where it is, and its window as it is, until it is removed.
  void add(const TrackFile& track, const TrackWindow& window);
  void remove(const TrackFile& track, const TrackWindow& window);

  /// Whether that is true of any track with a window near the plot.
  template <class Predicate>
  bool any(const tws::Plot& plot, Predicate predicate) const {
    const auto holds = [&](const TrackFile* track) { return predicate(*track); };
    const Tracks& cell = cells_[cellAt(azimuthCell(plot.azimuth), rangeCell(plot.range))];
    return std::any_of(cell.begin(), cell.end(), holds) || std::any_of(wide_.begin(), wide_.end(), holds);
  }

 private:
  using Tracks = std::vector<const TrackFile*>;

  static constexpr int kRanges = 128, kAzimuths = 32;
  static constexpr double kCell = 4000.0;  // [m] What is farther than all of them is in the last one.
  static constexpr int kWide = 60;         // A window that reaches into more cells is kept in none.

  static int rangeCell(double range);
  static int azimuthCell(double azimuth);
  static std::size_t cellAt(int azimuth, int range) {
    return static_cast<std::size_t>(azimuth) * kRanges + static_cast<std::size_t>(range);
  }
  /// Calls visit(tracks) for each list that the window belongs to.
  template <class Visit>
  void forEachList(const TrackWindow& window, Visit visit);

  std::vector<Tracks> cells_;
  Tracks wide_;
};

}  // namespace range_gate_tracker
