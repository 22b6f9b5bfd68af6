#include "random_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/units.h>

#include "flight_path.h"

namespace radar_sim {
namespace {

constexpr double kPathLength = 4.0 * 3600.0;  // [s]; a path is checked and manoeuvres as far as this

double draw(const Interval& interval, RandomStream& random) {
  return std::uniform_real_distribution<>(interval.least, interval.greatest)(random);
}

Eigen::Vector2d direction(double azimuth) { return {std::sin(azimuth), std::cos(azimuth)}; }

PathStart drawInside(const RandomGroup& group, RandomStream& random) {
  const double area = draw({std::pow(group.range.least, 2), std::pow(group.range.greatest, 2)}, random);
  PathStart start;
  start.position = group.centre + std::sqrt(area) * direction(draw({0.0, tws::kTwoPi}, random));
  start.course = draw({0.0, tws::kTwoPi}, random);
  return start;
}

PathStart drawOnRim(const RandomGroup& group, RandomStream& random) {
  const double azimuth = draw({0.0, tws::kTwoPi}, random);
  PathStart start;
  start.position = group.centre + group.range.greatest * direction(azimuth);
  start.course = tws::wrapTwoPi(azimuth + tws::kPi + tws::radians(draw({-60.0, 60.0}, random)));
  return start;
}

std::vector<Leg> drawLegs(const RandomGroup& group, double speed, RandomStream& random) {
  std::vector<Leg> legs;
  if (draw({0.0, 1.0}, random) >= group.turning_fraction) return legs;
  double time = draw({0.0, group.straight_duration.greatest}, random);
  legs.push_back({time, 0.0, 0.0, 0.0});
  while (time < kPathLength) {
    const double side = draw({-1.0, 1.0}, random) < 0.0 ? -1.0 : 1.0;
    const double rate = std::min(draw(group.turn_rate, random), group.greatest_acceleration / std::max(speed, 1.0));
    const double turning = draw(group.turn_duration, random);
    const double straight = draw(group.straight_duration, random);
    legs.push_back({turning, side * rate, 0.0, 0.0});
    legs.push_back({straight, 0.0, 0.0, 0.0});
    time += turning + straight;
  }
  return legs;
}

struct Life {
  PathStart start;
  std::vector<Leg> legs;
  double end;
};

/// When the path leaves the group's disk, to a second while it manoeuvres; a negative time when it enters the keep-out
/// circle before that.
double leavingTime(const RandomGroup& group, const FlightPath& path, double start) {
  const bool matters = group.rebirth || group.keep_out > 0.0;
  for (double time = start; matters && time < start + kPathLength; time += 1.0) {
    const double distance = (path.at(time).position.head<2>() - group.centre).norm();
    if (distance < group.keep_out) return -1.0;
    if (group.rebirth && distance > group.range.greatest + 1.0) return time;
  }
  return group.rebirth ? path.leavesForGood(group.centre, group.range.greatest + 1.0)
                       : std::numeric_limits<double>::infinity();
}

Life drawLife(const RandomGroup& group, bool first, double origin_altitude, double time, RandomStream& random) {
  for (int trial = 0; trial < 1000; ++trial) {
    Life life{first ? drawInside(group, random) : drawOnRim(group, random), {}, 0.0};
    life.start.time = time;
    life.start.speed = draw(group.speed, random);
    life.start.height = draw(group.height, random);
    life.legs = drawLegs(group, life.start.speed, random);
    life.end = leavingTime(group, FlightPath(life.start, life.legs, origin_altitude), time);
    if (life.end > time) return life;
  }
  throw std::invalid_argument("random group '" + group.name + "': no path stays out of the keep-out circle");
}

Target makeTarget(const RandomGroup& group, const std::string& name, const Life& life, double origin_altitude,
                  RandomStream& random) {
  Target target{name, group.kind, group.reflection, nullptr, {}};
  target.reflection.rcs = std::exp(draw({std::log(group.rcs.least), std::log(group.rcs.greatest)}, random));
  target.trajectory = std::make_shared<FlightPath>(life.start, life.legs, origin_altitude, life.end);
  return target;
}

}  // namespace

std::vector<Target> drawGroup(const RandomGroup& group, std::uint64_t seed, double origin_altitude, double start,
                              double end) {
  std::vector<Target> targets;
  start = std::max(start, group.life.start);
  end = std::min(end, group.life.end);
  for (long slot = 0; slot < group.count; ++slot) {
    const std::string name = group.name + "/" + std::to_string(slot);
    double time = start;
    for (std::uint64_t life_index = 0; time < end; ++life_index) {
      RandomStream random(seed, name, life_index);
      Life life = drawLife(group, life_index == 0, origin_altitude, time, random);
      life.end = std::min(life.end, group.life.end);
      const std::string full_name = group.rebirth ? name + "/" + std::to_string(life_index) : name;
      targets.push_back(makeTarget(group, full_name, life, origin_altitude, random));
      targets.back().transponder = drawTransponder(group.transponders, seed, full_name);
      time = life.end;
    }
  }
  return targets;
}

}  // namespace radar_sim
