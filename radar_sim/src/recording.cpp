#include "recording.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

/// Four finite numbers between commas and nothing else.
bool parseRow(std::string line, double (&numbers)[4]) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::istringstream stream(line);
  for (int i = 0; i < 4; ++i) {
    if (i > 0 && stream.get() != ',') return false;
    if (!(stream >> numbers[i]) || !std::isfinite(numbers[i])) return false;
  }
  return stream.peek() == std::istringstream::traits_type::eof();
}

RecordedFix parseFix(const std::string& line) {
  double row[4];
  if (!parseRow(line, row)) throw std::runtime_error("expected four numbers, found '" + line + "'");
  if (std::abs(row[1]) > 90.0) throw std::runtime_error("latitude " + std::to_string(row[1]) + " is not in [-90, 90]");
  return {row[0], {tws::radians(row[1]), tws::radians(row[2]), row[3]}};
}

std::vector<RecordedFix> parseFixes(std::istream& file, int& line_number) {
  std::string line;
  line_number = 1;
  if (!std::getline(file, line) || line.rfind("t_s,lat_deg,lon_deg,alt_m", 0) != 0) {
    throw std::runtime_error("expected the header t_s,lat_deg,lon_deg,alt_m");
  }
  std::vector<RecordedFix> fixes;
  while (++line_number, std::getline(file, line)) {
    fixes.push_back(parseFix(line));
    if (fixes.size() > 1 && !(fixes.back().time > fixes[fixes.size() - 2].time))
      throw std::runtime_error("time does not increase");
  }
  return fixes;
}

}  // namespace

std::vector<RecordedFix> readRecording(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  int line_number = 0;
  try {
    return parseFixes(file, line_number);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ":" + std::to_string(line_number) + ": " + error.what());
  }
}

}  // namespace radar_sim
