#pragma once

#include <iosfwd>
#include <optional>

#include "core/adit.h"

namespace adit_tracker {

/// Writes tracks as `t_s,track_id,x_m,y_m,vx_mps,vy_mps,status`: x east, y north of the radars; slant range laid on the
/// plane. With heights, `height_m,height_sigma_m` follow: above the radars, empty where unknown.
class TrackCsv {
 public:
  explicit TrackCsv(std::ostream& output, bool with_heights = false);

  /// One row for each track that was updated or illuminated in vain.
  void report(const Adit& adit, const SectorReport& report);
  /// The firm and coasting tracks, extrapolated to an instant.
  void picture(const Adit& adit, double time);

 private:
  void heightColumns(const std::optional<Height>& height);
  void row(const Adit& adit, TrackFile::Slot slot, double time);

  std::ostream& output_;
  bool with_heights_;
};

/// "tentative", "firm" or "coasting": a firm track that was not detected when a beam met it last.
const char* statusOf(const Adit& adit, const Track& track);

}  // namespace adit_tracker
