#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "clutter/clutter.h"
#include "clutter/spoke_feed.h"
#include "radar_equation.h"

namespace radar_sim {

constexpr double kTestStart = 1000.0;  // [s of data time]

inline ClutterView viewOf(const std::string& radar, std::uint64_t seed = 7) {
  ClutterView view{{}, Eigen::Isometry3d::Identity(), seed};
  view.params.name = radar;
  view.params.max_range = 60e3;
  return view;
}

/// What a radar at the map's origin sees of one kind of clutter, scan by scan, from `start` on.
class ClutterScans {
 public:
  ClutterScans(const ClutterSpec& spec, const ClutterView& view, double start = kTestStart)
      : view_(view),
        start_(start),
        feed_(Antenna(view.params.rotation_period, 0.0, start), view.params.azimuth_beamwidth, start) {
    feed_.add(std::shared_ptr<const ClutterSpec>(&spec, [](const ClutterSpec*) {}), spec.seenBy(view));
  }

  std::vector<Echo> next() {
    std::vector<Echo> echoes;
    // Half a spoke early: rounding must not let the next scan's first spoke slip in.
    const double half_a_spoke = 0.5 * view_.params.azimuth_beamwidth / tws::kTwoPi * view_.params.rotation_period;
    feed_.raise(start_ + static_cast<double>(++scans_) * view_.params.rotation_period - half_a_spoke, echoes);
    return echoes;
  }
  std::vector<Echo> next(int scans) {
    std::vector<Echo> all;
    for (int i = 0; i < scans; ++i) {
      const auto echoes = next();
      all.insert(all.end(), echoes.begin(), echoes.end());
    }
    return all;
  }

 private:
  ClutterView view_;
  double start_;
  SpokeFeed feed_;
  int scans_ = 0;
};

/// The resolution cell of an echo: range cell, spoke.
inline std::pair<long, long> cellOf(const Echo& echo, const RadarParams& radar) {
  const double width = tws::kTwoPi / spokes(radar.azimuth_beamwidth);
  return {static_cast<long>(echo.range / rangeCell(radar)), static_cast<long>(echo.azimuth / width)};
}

inline Eigen::Vector2d placeOf(const Echo& echo) {
  return echo.range * Eigen::Vector2d(std::sin(echo.azimuth), std::cos(echo.azimuth));
}

/// 4.5 standard deviations of a Poisson number: a wrong alarm once in 150 000.
inline double poissonBound(double mean) { return 4.5 * std::sqrt(mean); }

}  // namespace radar_sim
