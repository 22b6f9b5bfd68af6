#pragma once

#include <optional>

#include "core/adit_counts.h"
#include "core/alignment.h"
#include "core/radars.h"

namespace adit_tracker {

/// Takes in the radars' sectors: leaves out plots that cannot be used, keeps sectors until their turn, and lets the
/// processing of one see no more than it may.
class SectorIntake {
 public:
  /// `ahead`: how many sectors of a radar the processing of one looks at beyond it.
  SectorIntake(Radars& radars, AditCounts& counts, Alignment& alignment, std::int64_t ahead)
      : radars_(radars), counts_(counts), alignment_(alignment), ahead_(ahead) {}

  /// A closed sector of a radar. Plots that are not finite or whose range is not in (0, 10 000 km] are left out and
  /// counted; so are late ones, of which the beam met the target more than a sector before it entered this one, and
  /// copies of plots. `ship`: own ship meanwhile, if the radar is on one.
  void add(std::size_t radar, tws::RadarSector sector, const std::optional<Passage>& ship = std::nullopt);

  /// Lets in what the processing of that sector may look at. What else has come must not matter, or the result would
  /// depend on how the radars' messages interleave.
  void admit(const tws::SectorRef& sector);

 private:
  void sift(std::size_t radar, tws::RadarSector& sector);
  bool cameBefore(std::size_t radar, std::int64_t running, const tws::Plot& plot);
  void letIn(std::size_t index, WaitingSector& next);

  Radars& radars_;
  AditCounts& counts_;
  Alignment& alignment_;
  std::int64_t ahead_;
};

}  // namespace adit_tracker
