#pragma once

#include <cstddef>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include <tws_core/plot.h>

namespace adit_tracker {

/// The plots of a CSV file, for each radar in order of time, and what was wrong with it.
struct PlotTable {
  std::map<std::string, std::vector<tws::Plot>> radars;  // by the text in the column `radar`
  std::size_t plots = 0;
  std::size_t refused = 0;              // lines
  int midnights = 0;                    // that times of day passed
  bool has_elevations = false;          // the header has a column for them,
  bool has_range_rates = false;         // and for these
  std::vector<std::string> complaints;  // "file:line: reason", the first ones only
};

/// Reads a table with the columns t_s, radar, range_m and az_deg (see tws::CsvTable); azimuth clockwise from true
/// north. Further columns el_deg (up from the horizontal, -90 .. 90), el_sigma_deg (>= 0) and range_rate_mps (Doppler,
/// positive outbound, within ±100 000) may be empty: unknown; others are ignored. Times of day go on over midnight. A
/// line that cannot be used is counted and left out. So is one whose time must be a mistake: beyond ±1e10 s, one of two
/// or fewer with nothing of any radar within ten minutes of them, or of a stretch that lies a month or more from the
/// longest one. A recording may pause for hours or days. Throws std::runtime_error, naming the file, when a column is
/// missing.
PlotTable readPlots(std::istream& input, const std::string& name);

}  // namespace adit_tracker
