#pragma once

#include "reading.h"
#include "transponder.h"

namespace radar_sim {

/// `transponder` of a target; what is not there stays as in `transponder`.
void readTransponder(ParameterReader& reader, const ReadingContext& context, Transponder& transponder);

/// `transponder` of a random group.
void readTransponderShares(ParameterReader& reader, TransponderShares& shares);

}  // namespace radar_sim
