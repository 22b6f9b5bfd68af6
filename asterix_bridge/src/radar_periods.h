#pragma once

#include <map>

#include "recording.h"

namespace asterix_bridge {

/// How long each radar of a recording takes for a turn [s], as its first minutes show; what is not known is left out.
std::map<SourceId, double> periodsOf(const Recording& recording, const DataClock& clock);

}  // namespace asterix_bridge
