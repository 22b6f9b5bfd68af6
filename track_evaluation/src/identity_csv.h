#pragma once

#include <iosfwd>
#include <string>

#include "identity.h"

namespace track_evaluation {

/// Adds the plots of a file with the columns t_s, range_m, az_deg and mode3a (octal), in any order and among others.
/// Plots without a code are left out. Throws std::runtime_error with `name`, line and reason.
void readPlots(std::istream& input, const std::string& name, IdentityMetrics& metrics);
/// Throws also when the file cannot be opened.
void readPlotFile(const std::string& path, IdentityMetrics& metrics);

}  // namespace track_evaluation
