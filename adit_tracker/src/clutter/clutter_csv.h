#pragma once

#include <iosfwd>
#include <string>

#include "clutter/saved_maps.h"

namespace adit_tracker {

/// Reads `radar,range_m,az_deg` with a header line; radar `*` means all radars; lines that begin with # and empty ones
/// are left out. With further columns, rows with a depth_m are cells of what was learned of a radar (see
/// RadarCountsReader). Throws std::runtime_error that names file, line and reason at the first line that cannot be
/// used: clutter that is loaded takes detections away, so a file is used whole or not at all.
SavedMaps readClutter(std::istream& input, const std::string& name, ClutterLimits limits);

/// Writes them so that readClutter gives them back, points to 0.1 m and 0.0001°.
void writeClutter(std::ostream& output, const SavedMaps& maps);

/// The same with files: regular ones of at most 16 MB are read, and a file that was there stays whole until another one
/// is (tws::OutputFile). Throw std::runtime_error, naming the file.
SavedMaps loadClutterFile(const std::string& path, const ClutterLimits& limits);
void saveClutterFile(const std::string& path, const SavedMaps& maps);

}  // namespace adit_tracker
