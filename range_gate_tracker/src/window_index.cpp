#include "window_index.h"

#include <tws_core/angles.h>

namespace range_gate_tracker {

// A place that is no number is in the first cell; no plot is in such a window.
int WindowIndex::rangeCell(double range) {
  return range > 0.0 ? static_cast<int>(std::min(range / kCell, kRanges - 1.0)) : 0;
}

int WindowIndex::azimuthCell(double azimuth) {
  const double turn = tws::wrapTwoPi(azimuth) / tws::kTwoPi;
  return turn > 0.0 ? std::min(static_cast<int>(turn * kAzimuths), kAzimuths - 1) : 0;
}

template <class Visit>
void WindowIndex::forEachList(const TrackWindow& window, Visit visit) {
  constexpr double kRounding = 1.0, kAngleRounding = 1e-9;  // [m], [rad]
  if (window.close < window.open) return;                   // It is none.
  const int nearest = rangeCell(window.range - window.half_range - kRounding);
  const int farthest = rangeCell(window.range + window.half_range + kRounding);
  const int first = azimuthCell(window.azimuth - window.half_azimuth - kAngleRounding);
  const int last = azimuthCell(window.azimuth + window.half_azimuth + kAngleRounding);
  const int width = (last - first + kAzimuths) % kAzimuths + 1;  // No window is wider than half a turn.
  if (width * (farthest - nearest + 1) > kWide) return visit(wide_);
  for (int i = 0; i < width; ++i)
    for (int range = nearest; range <= farthest; ++range) visit(cells_[cellAt((first + i) % kAzimuths, range)]);
}

void WindowIndex::add(const TrackFile& track, const TrackWindow& window) {
  forEachList(window, [&](Tracks& tracks) { tracks.push_back(&track); });
}

void WindowIndex::remove(const TrackFile& track, const TrackWindow& window) {
  forEachList(window, [&](Tracks& tracks) {
    const auto found = std::find(tracks.begin(), tracks.end(), &track);
    if (found == tracks.end()) return;
    *found = tracks.back();
    tracks.pop_back();
  });
}

}  // namespace range_gate_tracker
