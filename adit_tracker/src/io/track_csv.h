#pragma once

#include <iosfwd>
#include <optional>

#include "core/adit.h"

namespace adit_tracker {

/// Writes tracks as `t_s,track_id,x_m,y_m,vx_mps,vy_mps,status`: x east, y north of the radars (on own ship: in the
/// fixed frame); slant range laid on the plane. With heights, `height_m,height_sigma_m` follow: above the radars, empty
/// where unknown. With covariances, the upper triangle of that of (x, y, vx, vy) follows, row by row, in units of m and
/// s; empty where the filter has none.
class TrackCsv {
 public:
  explicit TrackCsv(std::ostream& output, bool with_heights = false, bool with_covariances = false);

  /// One row for each track that was updated or illuminated in vain.
  void report(const Adit& adit, const SectorReport& report);
  /// The firm and coasting tracks, extrapolated to an instant.
  void picture(const Adit& adit, double time);

 private:
  void covarianceColumns(const Extrapolation& track);
  void heightColumns(const std::optional<Height>& height);
  void row(const Adit& adit, TrackFile::Slot slot, double time);

  std::ostream& output_;
  bool with_heights_, with_covariances_;
};

/// "tentative", "firm" or "coasting": a firm track that was not detected when a beam met it last.
const char* statusOf(const Adit& adit, const Track& track);

}  // namespace adit_tracker
