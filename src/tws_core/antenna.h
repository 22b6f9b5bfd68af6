#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace tws {

/// A beam that turns evenly, clockwise: its unwrapped azimuth [rad] (each revolution adds 2π) against time [s].
struct SteadyBeam {
  double time = 0.0;     // at which it points at `azimuth` [s]
  double azimuth = 0.0;  // unwrapped [rad]
  double rate = 0.0;     // [rad/s], > 0

  double azimuthAt(double at) const { return azimuth + (at - time) * rate; }
  double timeAt(double unwrapped) const { return time + (unwrapped - azimuth) / rate; }
};

/// Where one radar's beam points, learned from its sector crossings. Angles are unwrapped: revolution n of the antenna
/// is [64 n, 64 (n + 1)) sectors, and an unwrapped azimuth is counted from there [rad].
class Antenna {
 public:
  /// `period`: duration of a revolution until crossings give it [s], > 0: those of a whole revolution, or of the latest
  /// `least_sectors` or more, 1 .. 64, as long as there are no others.
  explicit Antenna(double period, int least_sectors = kSectors)
      : crossings_(kMask + 1), period_(period), least_sectors_(least_sectors) {}

  /// The beam enters the sector of that running number, ≥ 0. Numbers and times grow; a gap in them is allowed. (Inline,
  /// as all that follows: a tracker asks at each plot.)
  void cross(std::int64_t running, double time) {
    crossings_[static_cast<std::size_t>(running & kMask)] = {running, time};
    newest_ = running;
    // A whole revolution is the best measure; before there is one, the longest part of it that is known.
    std::int64_t from = running - kSectors;
    while (running - from > least_sectors_ && at(from).running != from) ++from;
    const Crossing& before = at(from);
    if (before.running != from || time <= before.time) return;
    period_ = (time - before.time) * kSectors / static_cast<double>(running - from);
  }

  bool known() const { return newest_ >= 0; }
  /// The latest sector entered; -1: none.
  std::int64_t newest() const { return newest_; }
  /// Duration of the latest revolution, from crossings one revolution apart [s].
  double period() const { return period_; }
  double sectorDuration() const { return period_ / kSectors; }
  /// [rad/s]
  double rate() const { return kTwoPi / period_; }

  static int sectorNumber(std::int64_t running) { return wrapSector(static_cast<int>(running % kSectors)); }
  /// The unwrapped azimuth of a direction, next to the beginning of a running sector.
  static double near(double azimuth, std::int64_t running) {
    return startOf(running) + angularDifference(azimuth, sectorStart(sectorNumber(running)));
  }
  /// The unwrapped azimuth at which the running sector begins.
  static double startOf(std::int64_t running) { return static_cast<double>(running) * kSectorWidth; }

  /// When the beam is at an unwrapped azimuth [s]: between crossings by interpolation, beyond the newest by the period.
  /// Needs known().
  double timeAt(double unwrapped_azimuth) const {
    const double place = unwrapped_azimuth / kSectorWidth;
    const std::int64_t running = static_cast<std::int64_t>(std::floor(place));
    const double fraction = place - static_cast<double>(running);
    if (running >= 0 && running < newest_) {
      const Crossing &from = at(running), &to = at(running + 1);
      if (from.running == running && to.running == running + 1) return from.time + fraction * (to.time - from.time);
    }
    return at(newest_).time + (place - static_cast<double>(newest_)) * sectorDuration();
  }
  /// The same the other way round: where the beam points at a time [s] of the latest revolution or later [rad],
  /// [0, 2π). Needs known().
  double azimuthAt(double time) const {
    const Place place = placeAt(time);
    return wrapTwoPi(sectorStart(sectorNumber(place.running)) + place.sectors * kSectorWidth);
  }
  /// Running number of the sector in which the beam is at such a time.
  std::int64_t runningAt(double time) const {
    const Place place = placeAt(time);
    return place.running + static_cast<std::int64_t>(std::floor(place.sectors));
  }

 private:
  static constexpr std::int64_t kMask = 127;
  struct Crossing {
    std::int64_t running = -kMask;  // none; never a revolution before a real one
    double time = 0.0;
  };
  const Crossing& at(std::int64_t running) const { return crossings_[static_cast<std::size_t>(running & kMask)]; }

  struct Place {
    std::int64_t running;
    double sectors;  // beyond its beginning
  };
  Place placeAt(double time) const {
    std::int64_t running = newest_;
    while (time < at(running).time && at(running - 1).running == running - 1 && newest_ - running < kSectors) --running;
    const bool between = running < newest_ && time >= at(running).time;
    const double duration = between ? at(running + 1).time - at(running).time : sectorDuration();
    return {running, (time - at(running).time) / duration};
  }

  std::vector<Crossing> crossings_;  // of the latest two revolutions
  std::int64_t newest_ = -1;
  double period_;
  std::int64_t least_sectors_;
};

}  // namespace tws
