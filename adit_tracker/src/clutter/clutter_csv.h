#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "clutter/clutter_places.h"

namespace adit_tracker {

/// Reads `radar,range_m,az_deg` with a header line; radar `*` means all radars; lines that begin with # and empty ones
/// are left out. Throws std::runtime_error that names file, line and reason at the first line that cannot be used:
/// clutter that is loaded takes detections away, so a file is used whole or not at all.
std::vector<ClutterPlace> readClutter(std::istream& input, const std::string& name, ClutterLimits limits);

/// Writes them so that readClutter gives them back, to 0.1 m and 0.0001°.
void writeClutter(std::ostream& output, const std::vector<ClutterPlace>& places);

/// The same with files: regular ones of at most 16 MB are read, and a file that was there stays whole until another one
/// is (tws::OutputFile). Throw std::runtime_error, naming the file.
std::vector<ClutterPlace> loadClutterFile(const std::string& path, const ClutterLimits& limits);
void saveClutterFile(const std::string& path, const std::vector<ClutterPlace>& places);

}  // namespace adit_tracker
