#pragma once

#include <string>

#include <tws_core/csv_table.h>
#include <tws_core/units.h>

namespace adit_tracker {

/// An angle of a table's row in radians, NaN as it is. Throws std::runtime_error, which names the row, when the degrees
/// of the column `name` are not in [least, greatest].
inline double angleOf(const tws::CsvTable& table, std::size_t column, const char* name, double degrees, double least,
                      double greatest) {
  if (degrees < least || degrees > greatest) table.fail(std::string(name) + " is out of range: " + table.text(column));
  return tws::radians(degrees);
}

}  // namespace adit_tracker
