#include "io/trouble_report.h"

#include <string>

#include "io/status_report.h"

namespace adit_tracker {

TroubleReport::TroubleReport(tws_runtime::Bus& bus, const AditParams& params, std::size_t overflow)
    : bus_(bus),
      counts_(bus,
              {{"refused tracks", &AditCounts::refused_tracks,
                "all " + std::to_string(params.capacity - 1) + " track numbers are in use"},
               {"refused clutter points", &AditCounts::refused_clutter, "all clutter numbers are in use"},
               {"late sectors", &AditCounts::late_sectors,
                "a radar's data came more than " + std::to_string(params.skew_limit) + " s after the others'"},
               {"rejected plots", &AditCounts::rejected_plots,
                "range, azimuth or time is no number, or range is not in (0, 10000 km]"},
               {"late detections", &AditCounts::late_plots,
                "stamped more than a sector before the one that they came with"},
               {"duplicate detections", &AditCounts::duplicate_plots, "the same time, range and azimuth came before"},
               {"skipped sectors", &AditCounts::skipped_sectors,
                "overflow: more than " + std::to_string(overflow) + " sectors behind the radars"}}) {}

void TroubleReport::add(const Adit& adit) {
  counts_.add(adit.counts());
  warnOfCapacity(adit);
}

/// Once, until there is room again.
void TroubleReport::warnOfCapacity(const Adit& adit) {
  const bool nearly_full = isFilled(adit, kNearlyFull);
  if (nearly_full && !warned_)
    bus_.counter("capacity warnings")
        .add(std::to_string(adit.tracks().size()) + " of " + std::to_string(adit.params().capacity - 1) +
             " track numbers are in use");
  constexpr double kRoomAgain = 0.8;
  warned_ = nearly_full || (warned_ && isFilled(adit, kRoomAgain));
}

}  // namespace adit_tracker
