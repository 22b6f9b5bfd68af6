#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/adit.h"
#include "elevation/elevation_schedule.h"

namespace adit_tracker {

/// One search that the radar shall make (a pair in IAZIM).
struct ElevationSearch {
  std::uint32_t track = 0;  // number
  double azimuth = 0.0;     // where it begins [rad], [0, 2π)
  double range = 0.0;       // centre of the range interval [m]
};

/// What the radar shall search for while it turns from its next north crossing to the one after.
struct ElevationList {
  double time = 0.0;                      // its antenna enters sector 61 [s]
  std::vector<ElevationSearch> searches;  // by azimuth
};

/// Designated tracks → elevation searches (the report's ELEV), once a scan of one radar, when its antenna enters sector
/// 61. The tracks are then as of its sector 56: the result depends on what was processed up to there and not on what
/// else has arrived.
class ElevationHandler {
 public:
  /// The index of the radar that searches. The parameters must be good (see check).
  static std::size_t radarOf(const AditParams& params);

  explicit ElevationHandler(const Adit& adit);

  /// To be called after each sector, while its updates are valid. The list, when the sector makes it due. It may
  /// designate tracks (`elevation.automatic`).
  std::optional<ElevationList> afterSector(Adit& adit, const SectorReport& report);

 private:
  bool isDue(std::int64_t running);
  void updateDesignations(Adit& adit, const SectorReport& report);
  ElevationList list(const Adit& adit, std::int64_t running);
  ElevationSearch search(const Adit& adit, TrackFile::Slot slot, std::int64_t running) const;

  std::size_t radar_;
  ElevationParams params_;
  ElevationSchedule schedule_;
  std::optional<std::int64_t> scan_;
};

}  // namespace adit_tracker
