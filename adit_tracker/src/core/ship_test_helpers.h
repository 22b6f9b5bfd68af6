#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/plot.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include "core/passage.h"

namespace adit_tracker {

/// A ship that holds its speed and swings about its course by so much each way.
struct TestShip {
  double speed = 10.0, swing = 1.0, swing_period = 120.0;  // [m/s], [rad], [s]

  Pose at(double time) const {
    constexpr double kStep = 0.01;  // [s]
    for (; tabulated_ < time + kStep; tabulated_ += kStep) {
      const double heading = headingAt(tabulated_);
      const Pose& last = table_.back();
      table_.push_back(
          {last.x + kStep * speed * std::sin(heading), last.y + kStep * speed * std::cos(heading), heading});
    }
    const double place = time / kStep;
    const auto i = static_cast<std::size_t>(place);
    Pose pose = between(table_[i], table_[i + 1], place - static_cast<double>(i));
    pose.heading = headingAt(time);
    return pose;
  }

 private:
  double headingAt(double time) const { return 0.7 + swing * std::sin(tws::kTwoPi * time / swing_period); }

  mutable double tabulated_ = 0.0;
  mutable std::vector<Pose> table_ = {{0.0, 0.0, 0.7}};
};

/// What moves straight, or stands, over ground: place at t = 0 [m], velocity [m/s].
struct TestBoat {
  double x, y, vx = 0.0, vy = 0.0;

  double xAt(double time) const { return x + vx * time; }
  double yAt(double time) const { return y + vy * time; }
};

/// A radar on a ship, its antenna turning evenly against the bow; its beam passes the bow at t = 0.
struct TestShipRadar {
  double period = 2.5, detected = 0.9;  // [s]
  double range_sigma = 5.0, azimuth_sigma = tws::radians(0.5), reach = 8000.0;
  bool from_bow = true;  // azimuths; else from north

  /// The sectors up to a time, against the bow, with what is seen of these, in noise. By small steps of time: is the
  /// beam past the target now and was not before?
  std::vector<tws::RadarSector> see(const TestShip& ship, const std::vector<TestBoat>& boats, double to,
                                    std::mt19937_64& generator) const {
    std::vector<tws::RadarSector> sectors;
    const double duration = period / tws::kSectors;
    for (std::int64_t i = 0; static_cast<double>(i + 1) * duration < to; ++i) {
      tws::RadarSector& sector = sectors.emplace_back();
      sector.running = i;
      sector.sector = static_cast<int>(i % tws::kSectors);
      sector.enter_time = duration * static_cast<double>(i);
      sector.leave_time = duration * static_cast<double>(i + 1);
    }
    for (const TestBoat& boat : boats) look(ship, boat, sectors, generator);
    for (tws::RadarSector& sector : sectors)
      std::sort(sector.plots.begin(), sector.plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return sectors;
  }

 private:
  double ahead(const TestShip& ship, const TestBoat& boat, double time) const {
    const Pose pose = ship.at(time);
    const double azimuth = std::atan2(boat.xAt(time) - pose.x, boat.yAt(time) - pose.y) - pose.heading;
    return tws::wrapPi(azimuth - tws::kTwoPi * time / period);
  }

  void look(const TestShip& ship, const TestBoat& boat, std::vector<tws::RadarSector>& sectors,
            std::mt19937_64& generator) const {
    constexpr int kSteps = 4;  // of a sector
    for (tws::RadarSector& sector : sectors) {
      const double step = (sector.leave_time - sector.enter_time) / kSteps;
      for (int i = 0; i < kSteps; ++i) {
        const double time = sector.enter_time + i * step;
        const double before = ahead(ship, boat, time), after = ahead(ship, boat, time + step);
        if (!(before >= 0.0 && before < 1.0 && after < 0.0)) continue;
        measure(ship, boat, time + step * before / (before - after), sector, generator);
      }
    }
  }

  void measure(const TestShip& ship, const TestBoat& boat, double time, tws::RadarSector& sector,
               std::mt19937_64& generator) const {
    std::normal_distribution<double> normal;
    const Pose pose = ship.at(time);
    const double x = boat.xAt(time) - pose.x, y = boat.yAt(time) - pose.y;
    if (std::hypot(x, y) > reach || tws::uniform(generator, 0.0, 1.0) > detected) return;
    tws::Plot& plot = sector.plots.emplace_back();
    plot.time = time;
    plot.range = std::max(1.0, std::hypot(x, y) + range_sigma * normal(generator));
    const double heading = from_bow ? pose.heading : 0.0;
    plot.azimuth = tws::wrapTwoPi(std::atan2(x, y) - heading + azimuth_sigma * normal(generator));
  }
};

}  // namespace adit_tracker
