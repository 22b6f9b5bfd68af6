#pragma once

#include <functional>
#include <optional>
#include <string>

#include <tws_core/geodesy.h>
#include <tws_runtime/parameters.h>

#include "random_group.h"
#include "target.h"

namespace radar_sim {

struct Scenario;

/// What the parts of a scenario file are read against. Internal to the scenario reader.
struct ReadingContext {
  tws::LocalFrame map;
  double start_time;   ///< [s of data time]; times in the file count from it.
  std::string folder;  ///< Of the scenario file, with a trailing slash.
};

using tws_runtime::ParameterReader;
using tws_runtime::scaledNumber;

constexpr double kFarthest = 1e7;  ///< Bounds of positions [m].
constexpr double kLongest = 1e6;   ///< Bounds of times [s].

/// A key in decibels for a power ratio; the bounds are in decibels.
void readDecibels(ParameterReader& reader, const std::string& key, double& ratio, double least, double greatest);

/// Two numbers, the smaller one first.
void readInterval(ParameterReader& reader, const std::string& key, Interval& value, double unit, double least,
                  double greatest);

/// `speed_mps` or `speed_kn`, one number or (Interval) two.
void readSpeed(ParameterReader& reader, double& speed);
void readSpeed(ParameterReader& reader, Interval& speed, double greatest);

/// The place in the map frame that is given by one of east_m and north_m, latitude_deg and longitude_deg, or range_m
/// and azimuth_deg (from the origin); `fallback` when none of them is there.
Eigen::Vector2d readPlace(ParameterReader& reader, const ReadingContext& context,
                          const std::optional<Eigen::Vector2d>& fallback = std::nullopt);

/// swerling, detection_probability, jitter_m and, for `with_rcs`, rcs_m2.
void readReflection(ParameterReader& reader, Reflection& reflection, bool with_rcs);

/// `name`: letters, digits, - and _; required unless there is a default.
void readName(ParameterReader& reader, std::string& name);

/// Checks the `site` that a sensor's map names. Where there is one site only, it need not name it.
void settleSite(std::string& site, const Scenario& scenario, const ParameterReader& reader);

/// Runs `build` and turns what it throws into an error about `key`, with its line.
template <class Build>
auto orFail(const ParameterReader& reader, const std::string& key, Build build) -> decltype(build()) {
  try {
    return build();
  } catch (const tws_runtime::ParameterError&) {
    throw;
  } catch (const std::exception& error) {
    reader.fail(key, error.what());
  }
}

}  // namespace radar_sim
