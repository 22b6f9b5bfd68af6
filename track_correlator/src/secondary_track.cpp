#include "secondary_track.h"

namespace track_correlator {

Agreement agreementOf(const SecondaryTrack& track, const SecondaryPlot& plot) {
  if (track.aircraft_address != 0 && plot.aircraft_address != 0)
    return track.aircraft_address == plot.aircraft_address ? Agreement::kSame : Agreement::kOtherAircraft;
  const std::uint16_t own = track.mode_3a.value();
  if (own == kNoCode || plot.mode_3a.code == kNoCode || plot.mode_3a.garbled) return Agreement::kUnknown;
  return own == plot.mode_3a.code ? Agreement::kSame : Agreement::kOtherCode;
}

bool mayHideCodeOf(const SecondaryTrack& track, const SecondaryPlot& plot) {
  const std::uint16_t own = track.mode_3a.value();
  return own != kNoCode && plot.mode_3a.code != kNoCode && plot.mode_3a.code != own && (plot.mode_3a.code & own) == own;
}

}  // namespace track_correlator
