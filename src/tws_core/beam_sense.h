#pragma once

#include <string>
#include <vector>

#include <tws_core/rotation.h>

namespace tws {

/// Do plots show a beam that goes to and fro across a sector: some in a row clockwise, then some in a row back? It
/// takes twenty that follow each other within 2..60°.
bool scansToAndFro(TimedAzimuths plots);

/// What plots of which no rotation is found show instead, for a person: "the antenna turns counter-clockwise, once in
/// 4.000 s: that is not read", or that it scans to and fro. Empty: neither.
std::string otherScanOf(TimedAzimuths plots);

}  // namespace tws
