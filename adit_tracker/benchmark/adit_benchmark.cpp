// Cost of the tracker alone, per detection, against the number of targets. Detections are made before the clock starts;
// the tracks are formed by then.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <tws_core/angles.h>
#include <tws_core/units.h>

#include "core/adit.h"

namespace adit_tracker {
namespace {

constexpr double kPeriods[] = {6.0, 8.0};
constexpr double kWarmUp = 48.0, kMeasured = 24.0;                       // [s]
constexpr double kDensity = 1000.0 / (tws::kPi * 100e3 * 100e3);         // targets [1/m²]
constexpr double kFalsePlotDensity = 20.0 / (tws::kPi * 100e3 * 100e3);  // false plots a scan

struct Target {
  double x, y, vx, vy;
};

struct RadarEvent {
  std::size_t radar;
  tws::RadarSector sector;
};

/// Straight flights on a disk seen by two radars, the errors those of 100 m × 0.3° at 100 km. Further out the azimuth
/// error shrinks so that it stays 520 m across: otherwise no tracker could tell targets 5 km apart from each other at
/// 1000 km. `crowd`: false plots a scan within 1 km of one place besides. Plots have range rates, too; whether they are
/// used, parameters say.
class World {
 public:
  World(long targets, double radius, long crowd = 0) : radius_(radius), crowd_(crowd), random_(1) {
    std::uniform_real_distribution<double> unit(0.0, 1.0), speed(100.0, 300.0);
    for (long i = 0; i < targets; ++i) {
      const double range = std::sqrt(unit(random_)) * radius, azimuth = unit(random_) * tws::kTwoPi;
      const double course = unit(random_) * tws::kTwoPi, v = speed(random_);
      targets_.push_back(
          {range * std::sin(azimuth), range * std::cos(azimuth), v * std::sin(course), v * std::cos(course)});
    }
    for (std::size_t radar = 0; radar < 2; ++radar) {
      for (double turn = 0.0; turn * kPeriods[radar] < kWarmUp + kMeasured; ++turn) addTurn(radar, turn);
    }
    std::stable_sort(events.begin(), events.end(), [](const RadarEvent& a, const RadarEvent& b) {
      return a.sector.leave_time < b.sector.leave_time;
    });
  }

  double azimuthSigma() const { return tws::radians(0.3) * std::min(1.0, 100e3 / radius_); }

  std::vector<RadarEvent> events;

 private:
  void addTurn(std::size_t radar, double turn) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double period = kPeriods[radar], begin = turn * period;
    std::vector<tws::RadarSector> sectors(tws::kSectors);
    for (int i = 0; i < tws::kSectors; ++i) {
      sectors[i].sector = i;
      sectors[i].running = static_cast<std::int64_t>(turn) * tws::kSectors + i;
      sectors[i].enter_time = begin + period * i / tws::kSectors;
      sectors[i].leave_time = begin + period * (i + 1) / tws::kSectors;
    }
    std::mt19937_64 random_rate(1);
    std::uniform_real_distribution<double> any_rate(-300.0, 300.0);
    const auto add = [&](double range, double beam, double azimuth, double rate) {
      tws::Plot plot;
      plot.time = begin + period * beam / tws::kTwoPi;
      plot.range = std::max(range, 100.0);
      plot.azimuth = tws::wrapTwoPi(azimuth);
      plot.range_rate = rate;
      sectors[static_cast<std::size_t>(tws::sectorOf(beam))].plots.push_back(plot);
    };
    for (const Target& target : targets_) {
      if (unit(random_) > 0.9) continue;
      double azimuth = std::atan2(target.x, target.y);
      for (int i = 0; i < 3; ++i) {
        const double t = begin + period * tws::wrapTwoPi(azimuth) / tws::kTwoPi;
        azimuth = std::atan2(target.x + target.vx * t, target.y + target.vy * t);
      }
      const double t = begin + period * tws::wrapTwoPi(azimuth) / tws::kTwoPi;
      const double range = std::hypot(target.x + target.vx * t, target.y + target.vy * t);
      const double rate = target.vx * std::sin(azimuth) + target.vy * std::cos(azimuth);
      add(range + 100.0 * normal(random_), tws::wrapTwoPi(azimuth), azimuth + azimuthSigma() * normal(random_), rate);
    }
    const double area = tws::kPi * radius_ * radius_;
    const int false_plots = std::poisson_distribution<int>(kFalsePlotDensity * area)(random_);
    for (int i = 0; i < false_plots; ++i) {
      const double azimuth = unit(random_) * tws::kTwoPi;
      add(std::sqrt(unit(random_)) * radius_, azimuth, azimuth, any_rate(random_rate));
    }
    for (long i = 0; i < crowd_; ++i) {
      const double away = 1e3 * std::sqrt(unit(random_)), course = unit(random_) * tws::kTwoPi;
      const double x = 21e3 + away * std::sin(course), y = 34e3 + away * std::cos(course);
      add(std::hypot(x, y), std::atan2(x, y), std::atan2(x, y), any_rate(random_rate));
    }
    for (tws::RadarSector& sector : sectors) {
      std::sort(sector.plots.begin(), sector.plots.end(),
                [](const tws::Plot& a, const tws::Plot& b) { return a.time < b.time; });
      events.push_back({radar, std::move(sector)});
    }
  }

  double radius_;
  long crowd_;
  std::mt19937_64 random_;
  std::vector<Target> targets_;
};

AditParams paramsOfSet(const World& world, const std::string& set, long targets, double rate_sigma) {
  AditParams params = AditParams::named(set);
  params.capacity = params.clutter.capacity = static_cast<std::uint32_t>(std::min(1000001L, 1000L + 4L * targets));
  for (const char* name : {"sps12", "sps39"}) {
    RadarParams radar;
    radar.name = name;
    radar.period = kPeriods[params.radars.size()];
    radar.azimuth_sigma = world.azimuthSigma();
    radar.range_rate_sigma = rate_sigma;
    params.radars.push_back(radar);
  }
  return params;
}

void track(benchmark::State& state, const std::string& set, const World& world, double rate_sigma = 0.0) {
  const AditParams params = paramsOfSet(world, set, state.range(0), rate_sigma);
  std::uint64_t detections = 0;
  std::uint32_t tracks = 0;
  for ([[maybe_unused]] auto round : state) {
    state.PauseTiming();
    auto adit = std::make_unique<Adit>(params, Adit::Sink{});
    std::size_t next = 0;
    for (; world.events[next].sector.leave_time < kWarmUp; ++next)
      addAndProcess(*adit, world.events[next].radar, world.events[next].sector);
    std::vector<RadarEvent> events(world.events.begin() + static_cast<std::ptrdiff_t>(next), world.events.end());
    for (const RadarEvent& event : events) detections += event.sector.plots.size();
    state.ResumeTiming();
    for (RadarEvent& event : events) addAndProcess(*adit, event.radar, std::move(event.sector));
    state.PauseTiming();
    tracks = adit->tracks().size();
    adit.reset();
    state.ResumeTiming();
  }
  state.counters["per_detection"] =
      benchmark::Counter(static_cast<double>(detections), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["tracks"] = tracks;
  state.counters["bytes_per_track"] = sizeof(Track);
}

/// Without the standard deviation of range rates [m/s], they are not used.
void constantDensity(benchmark::State& state, const std::string& set, double rate_sigma = 0.0) {
  const double radius = std::sqrt(static_cast<double>(state.range(0)) / (tws::kPi * kDensity));
  track(state, set, {state.range(0), radius}, rate_sigma);
}

void fixedDisk(benchmark::State& state, const std::string& set) { track(state, set, {state.range(0), 100e3}); }

/// So many false plots a scan within 1 km.
void crowdedPlace(benchmark::State& state, const std::string& set) {
  track(state, set, {60, 100e3, static_cast<long>(state.range(0))});
}

BENCHMARK_CAPTURE(constantDensity, default, std::string("default"))->Arg(60)->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK_CAPTURE(constantDensity, with_range_rates, std::string("default"), 2.0)->Arg(60)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(fixedDisk, default, std::string("default"))->Arg(60)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(constantDensity, nrl7952, std::string("nrl7952"))->Arg(60)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(crowdedPlace, default, std::string("default"))->Arg(100)->Arg(1000)->Arg(4000);

}  // namespace
}  // namespace adit_tracker

BENCHMARK_MAIN();
