#pragma once

#include <vector>

#include "core/candidates.h"
#include "core/track_book.h"

namespace adit_tracker {

/// Two tracks that follow one target: they compete for its detections, each gets half of every one, and both would live
/// on. Where two tracks of one cluster are in one place with one velocity, as far as they know, the younger ends. Two
/// firm ones do not where the radar may give one plot for two targets: that is left to the rules of bifurcation.
class DuplicateTracks {
 public:
  /// After the correlation and the updates of a sector. Nothing to do for who did not compete.
  void end(const std::vector<Correlation>& correlations, TrackBook& tracks, bool firm_too);

 private:
  void endAmong(TrackBook& tracks, bool firm_too);

  std::vector<TrackFile::Slot> suspects_;
};

}  // namespace adit_tracker
