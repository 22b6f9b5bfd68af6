#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/geodesy.h>

#include "core/own_ship.h"

namespace adit_tracker {

/// Own ship's track of a CSV file, and what was wrong with it.
struct OwnShipTable {
  OwnShip ship;
  std::size_t refused = 0;              // lines
  std::vector<std::string> complaints;  // "file:line: reason", the first ones only
  bool has_headings = false;            // azimuths are told from the bow
  std::optional<tws::Geodetic> origin;  // of the fixed frame, when places came as latitude and longitude
};

/// Reads a table with the column t_s and either x_m and y_m (east and north in the fixed frame) or lat_deg and lon_deg
/// (WGS 84; then the first usable place is the fixed frame's origin); a further column heading_deg says that azimuths
/// are told from the bow (see tws::CsvTable). A line that cannot be used is counted and left out; so are those that
/// OwnShip refuses. Throws std::runtime_error, naming the file, when a column is missing or fewer than two lines are
/// usable.
OwnShipTable readOwnShip(std::istream& input, const std::string& name);

}  // namespace adit_tracker
