#pragma once

#include <limits>
#include <optional>

#include <tws_core/angles.h>

namespace adit_tracker {

constexpr double kNever = -std::numeric_limits<double>::infinity();

/// Where a track or a clutter point was some scans ago (NR, RC): by it the conversions between the two judge movement.
struct ReferencePlace {
  double time = kNever;  // when it was stored
  double range = 0.0, azimuth = 0.0;

  /// Mean range rate [m/s] and azimuth rate [rad/s].
  struct Rates {
    double range, azimuth;
  };

  /// The rates since the stored place, if that is at least `least_age` old; the present place takes its place then.
  /// Nothing: it is younger, or there was none.
  std::optional<Rates> compare(double now, double range_now, double azimuth_now, double least_age) {
    const double elapsed = now - time;
    if (elapsed < least_age) return std::nullopt;
    const bool comparable = time != kNever;
    const Rates rates{(range_now - range) / elapsed, tws::angularDifference(azimuth_now, azimuth) / elapsed};
    *this = {now, range_now, azimuth_now};
    return comparable ? std::optional<Rates>(rates) : std::nullopt;
  }
};

}  // namespace adit_tracker
