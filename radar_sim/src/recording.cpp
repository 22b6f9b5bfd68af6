#include "recording.h"

#include <cmath>

#include <tws_core/csv_table.h>
#include <tws_core/units.h>

namespace radar_sim {

std::vector<RecordedFix> readRecording(const std::string& path) {
  const std::unique_ptr<std::istream> file = tws::openText(path);
  tws::CsvTable table(*file, path);
  const std::size_t time = table.require("t_s"), latitude = table.require("lat_deg"),
                    longitude = table.require("lon_deg"), altitude = table.require("alt_m");
  std::vector<RecordedFix> fixes;
  while (table.next()) {
    const RecordedFix fix{
        table.time(time),
        {tws::radians(table.number(latitude)), tws::radians(table.number(longitude)), table.number(altitude)}};
    if (std::abs(table.number(latitude)) > 90.0)
      table.fail("latitude " + table.text(latitude) + " is not in [-90, 90]");
    if (!fixes.empty() && !(fix.time > fixes.back().time)) table.fail("time does not increase");
    fixes.push_back(fix);
  }
  return fixes;
}

}  // namespace radar_sim
