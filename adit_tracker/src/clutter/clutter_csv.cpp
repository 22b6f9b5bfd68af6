#include "clutter/clutter_csv.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <tws_core/units.h>

#include "io/csv_fields.h"

namespace adit_tracker {
namespace {

constexpr const char* kHeader = "radar,range_m,az_deg";
constexpr const char* kAllRadars = "*";  // cannot be the name of one: names are parts of topics
constexpr double kRangeSteps = 10.0;     // of the file, in a metre
constexpr double kAzimuthSteps = 1e4;    // in a degree

ClutterPlace placeOf(std::string_view line) {
  std::string_view fields[3];
  if (!splitFields(line, fields) || std::count(line.begin(), line.end(), ',') != 2)
    throw std::runtime_error(std::string("has not the three columns ") + kHeader);
  if (fields[0].empty()) throw std::runtime_error("radar is empty; * stands for all radars");
  ClutterPlace place;
  if (fields[0] != kAllRadars) place.radar = fields[0];
  place.range = numberIn(fields[1], "range_m");
  place.azimuth = tws::radians(numberIn(fields[2], "az_deg"));
  return place;
}

bool isComment(std::string_view line) { return line.empty() || line.front() == '#'; }

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

std::vector<ClutterPlace> readClutter(std::istream& input, const std::string& name, ClutterLimits limits) {
  std::vector<ClutterPlace> places;
  bool in_body = false;
  std::string line;
  for (std::size_t number = 1; std::getline(input, line); ++number) {
    const auto refuse = [&](const std::string& reason) {
      throw std::runtime_error((name + ':' + std::to_string(number)).append(": ").append(reason));
    };
    const std::string_view text = trimmed(line);
    if (isComment(text)) continue;
    if (!std::exchange(in_body, true)) {
      if (text != kHeader) refuse(std::string("the first line must be the header ") + kHeader);
      continue;
    }
    try {
      places.push_back(placeOf(text));
    } catch (const std::runtime_error& error) {
      refuse(error.what());
    }
    if (const std::string problem = limits.add(places.back()); !problem.empty()) refuse(problem);
  }
  if (input.bad()) throw std::runtime_error(name + ": cannot be read");
  if (!in_body) throw std::runtime_error(name + ": is empty: even a map without points has the header " + kHeader);
  return places;
}

void writeClutter(std::ostream& output, const std::vector<ClutterPlace>& places) {
  output << "# Clutter map: slant range and azimuth (clockwise from true north) from the radar; * is any radar.\n"
         << kHeader << '\n';
  const double turn = 360.0 * kAzimuthSteps;
  for (const ClutterPlace& place : places) {
    const double range = std::max(1.0, std::round(place.range * kRangeSteps)) / kRangeSteps;
    const double azimuth = std::fmod(std::round(tws::degrees(place.azimuth) * kAzimuthSteps), turn) / kAzimuthSteps;
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, ",%.1f,%.4f\n", range, azimuth);
    output << (place.radar.empty() ? kAllRadars : place.radar) << numbers;
  }
}

std::vector<ClutterPlace> loadClutterFile(const std::string& path, const ClutterLimits& limits) {
  std::ifstream input(path);
  if (!input) fail(path, "cannot be read");
  return readClutter(input, path, limits);
}

void saveClutterFile(const std::string& path, const std::vector<ClutterPlace>& places) {
  const std::string part = path + ".part";
  std::ofstream output(part);
  if (!output) fail(path, "cannot be written");
  writeClutter(output, places);
  output.close();
  if (!output || std::rename(part.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    std::remove(part.c_str());
    errno = reason;
    fail(path, "cannot be written");
  }
}

}  // namespace adit_tracker
