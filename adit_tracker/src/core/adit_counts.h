#pragma once

#include <cstdint>

namespace adit_tracker {

/// Totals since the start.
struct AditCounts {
  std::uint64_t sectors = 0, plots = 0, rejected_plots = 0, late_plots = 0, duplicate_plots = 0;
  std::uint64_t late_sectors = 0;
  std::uint64_t skipped_sectors = 0;
  std::uint64_t tracks_started = 0, tracks_firm = 0, tracks_dropped = 0;
  std::uint64_t refused_tracks = 0, refused_clutter = 0;  // for want of numbers
  std::uint64_t to_clutter = 0, to_track = 0;             // conversions
  std::uint64_t stitched = 0;                             // new tracks with the number of a lost one
};

}  // namespace adit_tracker
