#pragma once

#include <optional>

#include "adit_params.h"
#include "core/track_book.h"

namespace adit_tracker {

/// Track segment association: a target that turns harder than any gate follows is lost, and found again as a new track
/// one or two scans later. That it is the same one tells what is missing at that moment: a firm track that has not been
/// detected since, from whose last detection it could have flown to the new track's first. Then the new track takes the
/// lost one's number over.
class Stitching {
 public:
  explicit Stitching(const AditParams& params) : params_(params) {}

  /// The track that was lost where `slot`, which a radar of that period [s] has just made firm, began; nothing: none,
  /// or nobody knows which. Looks at all firm tracks that coast.
  std::optional<TrackFile::Slot> lostBefore(const TrackBook& tracks, TrackFile::Slot slot, double period) const;

 private:
  std::optional<double> detour(const TrackMotion& motion, const Track& lost, const Track& found, double period) const;

  AditParams params_;
};

}  // namespace adit_tracker
