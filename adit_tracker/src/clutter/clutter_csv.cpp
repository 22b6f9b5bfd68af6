#include "clutter/clutter_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include <tws_core/csv_table.h>
#include <tws_core/output_file.h>
#include <tws_core/units.h>

#include "clutter/radar_counts_csv.h"

namespace adit_tracker {
namespace {

constexpr const char* kHeader = "radar,range_m,az_deg";
constexpr const char* kEnd = "# End of the map.";  // of a file with cells: one that is cut off has lost some
constexpr const char* kAllRadars = "*";            // cannot be the name of one: names are parts of topics
constexpr double kRangeSteps = 10.0;               // of the file, in a metre
constexpr double kAzimuthSteps = 1e4;              // in a degree
constexpr std::size_t kMostBytes = 16U << 20U;     // of a file: a hundred thousand points of each of three radars

struct Columns {
  explicit Columns(const tws::CsvTable& table)
      : radar(table.require("radar")), range(table.require("range_m")), azimuth(table.require("az_deg")) {}
  std::size_t radar, range, azimuth;
};

ClutterPlace placeOf(const tws::CsvTable& table, const Columns& columns) {
  const std::string& radar = table.text(columns.radar);
  if (radar.empty()) table.fail("radar is empty; * stands for all radars");
  ClutterPlace place;
  if (radar != kAllRadars) place.radar = radar;
  place.range = table.number(columns.range);
  place.azimuth = tws::radians(table.number(columns.azimuth));
  return place;
}

void writePlace(std::ostream& output, const ClutterPlace& place) {
  constexpr double kTurn = 360.0 * kAzimuthSteps;
  const double range = std::max(1.0, std::round(place.range * kRangeSteps)) / kRangeSteps;
  const double azimuth = std::fmod(std::round(tws::degrees(place.azimuth) * kAzimuthSteps), kTurn) / kAzimuthSteps;
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, ",%.1f,%.4f\n", range, azimuth);
  output << (place.radar.empty() ? kAllRadars : place.radar) << numbers;
}

}  // namespace

SavedMaps readClutter(std::istream& input, const std::string& name, ClutterLimits limits) {
  tws::CsvTable table(input, name);
  const Columns columns(table);
  RadarCountsReader cells(table, limits.radars());
  SavedMaps maps;
  while (table.next()) {
    if (cells.isCell()) {
      cells.addCell();
      continue;
    }
    maps.clutter.push_back(placeOf(table, columns));
    if (const std::string problem = limits.add(maps.clutter.back()); !problem.empty()) table.fail(problem);
  }
  maps.radars = cells.take();
  return maps;
}

void writeClutter(std::ostream& output, const SavedMaps& maps) {
  output << "# Clutter map: slant range and azimuth (clockwise from true north) from the radar; * is any radar.\n";
  if (!maps.radars.empty())
    output
        << "# Rows with a depth, what was learned of a radar: from where a cell begins, so many false plots came in so "
           "many\n"
           "# scans; targets were seen on so many of these looks. The last cell of a sector is all that lies beyond.\n";
  output << kHeader << (maps.radars.empty() ? "" : kRadarCountsColumns) << '\n';
  for (const ClutterPlace& place : maps.clutter) writePlace(output, place);
  for (const RadarCounts& counts : maps.radars) writeRadarCounts(output, counts);
  if (!maps.radars.empty()) output << kEnd << '\n';
}

SavedMaps loadClutterFile(const std::string& path, const ClutterLimits& limits) {
  const std::string text = tws::readRegularFile(path, kMostBytes);
  std::istringstream input(text);
  SavedMaps maps = readClutter(input, path, limits);
  if (!maps.radars.empty() && text.rfind(kEnd) == std::string::npos)
    throw std::runtime_error(path + ": is cut off: its last line is not '" + kEnd + "'");
  return maps;
}

void saveClutterFile(const std::string& path, const SavedMaps& maps) {
  tws::OutputFile output(path);
  writeClutter(output.stream(), maps);
  output.finish();
}

}  // namespace adit_tracker
