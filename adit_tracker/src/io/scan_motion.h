#pragma once

#include <vector>

#include <tws_core/plot.h>

namespace adit_tracker {

/// Plots that have one time a scan: do the targets move as if a beam that turned clockwise from north had met each of
/// them within the scan, and not all at that time? What tells it are targets that cross north: such a beam meets them
/// twice in a row, or only after two scans. False when too few do. `plots`: in order of time; `period` [s], > 0: of the
/// scans.
bool moveWithTheBeam(const std::vector<tws::Plot>& plots, double period);

}  // namespace adit_tracker
