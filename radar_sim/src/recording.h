#pragma once

#include <string>
#include <vector>

#include <tws_core/geodesy.h>

namespace radar_sim {

/// One fix of a recording.
struct RecordedFix {
  double time;  ///< Of the recording [s].
  tws::Geodetic place;
};

/// Reads a table (see tws::CsvTable) with the columns t_s, lat_deg, lon_deg and alt_m; altitude above the sea. Throws
/// std::runtime_error that names the file, the line and the reason: cannot be read, a column missing, not a finite
/// number, latitude beyond ±90°, time not increasing.
std::vector<RecordedFix> readRecording(const std::string& path);

}  // namespace radar_sim
