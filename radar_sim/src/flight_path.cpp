#include "flight_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

namespace radar_sim {
namespace {

// Beyond it the map's plane loses the earth: no height can be told at a distance of the earth's radius.
constexpr double kEdgeOfTheMap = 5.0e6;  // [m]

Eigen::Vector2d direction(double course) { return {std::sin(course), std::cos(course)}; }

/// State of a leg after `elapsed` seconds; exact.
PathStart advance(const PathStart& start, const Leg& leg, double elapsed) {
  PathStart now = start;
  now.time += elapsed;
  now.speed += leg.acceleration * elapsed;
  now.height += leg.climb_rate * elapsed;
  now.course += leg.turn_rate * elapsed;
  if (leg.turn_rate == 0.0) {
    now.position += direction(start.course) * (start.speed + now.speed) / 2.0 * elapsed;
    return now;
  }
  // The integral of v(t) (sin ψ, cos ψ) with v linear in t and ψ' = ω:  [-v cos ψ / ω + a sin ψ / ω²,  v sin ψ / ω + a
  // cos ψ / ω²].
  const auto integral = [&](double speed, double course) {
    const Eigen::Vector2d along = direction(course);
    const Eigen::Vector2d left(-along.y(), along.x());
    return Eigen::Vector2d(left * speed / leg.turn_rate + along * leg.acceleration / (leg.turn_rate * leg.turn_rate));
  };
  now.position += integral(now.speed, now.course) - integral(start.speed, start.course);
  return now;
}

/// The turn after which `target` lies straight ahead: up to the tangent from the turning circle.
Leg turnTowards(const PathStart& from, const Eigen::Vector2d& target, double turn_rate) {
  const double bearing = tws::angularDifference(tws::azimuthOf(target - from.position), from.course);
  const double side = bearing < 0.0 ? -1.0 : 1.0;  // right is positive
  const double radius = from.speed / turn_rate;
  const Eigen::Vector2d centre = from.position + side * radius * direction(from.course + tws::kPi / 2.0);
  const double distance = (target - centre).norm();
  if (distance < radius)
    throw std::invalid_argument("lies inside the turning circle of " + std::to_string(radius) + " m");
  const double course = tws::azimuthOf(target - centre) + side * std::asin(radius / distance);
  const double angle = tws::wrapTwoPi(side * (course - from.course));
  const bool ahead_already = angle < 1e-9 || angle > tws::kTwoPi - 1e-9;
  return {ahead_already ? 0.0 : angle / turn_rate, side * turn_rate, 0.0, 0.0};
}

Leg straightTo(const PathStart& from, const Waypoint& to) {
  Leg leg;
  leg.duration = 2.0 * (to.position - from.position).norm() / (from.speed + to.speed);
  if (leg.duration <= 0.0) throw std::invalid_argument("stands at the same place as the one before");
  leg.acceleration = (to.speed - from.speed) / leg.duration;
  leg.climb_rate = (to.height - from.height) / leg.duration;
  return leg;
}

}  // namespace

FlightPath::FlightPath(const PathStart& start, const std::vector<Leg>& legs, double origin_altitude, double end)
    : FlightPath(chain(start, legs), origin_altitude, end) {}

FlightPath::FlightPath(Segments segments, double origin_altitude, double end)
    : Trajectory({TimeSpan{segments.front().start.time,
                           std::min(end, leavesForGood(segments.back().start, {0.0, 0.0}, kEdgeOfTheMap))}}),
      segments_(std::move(segments)),
      origin_altitude_(origin_altitude) {}

FlightPath::Segments FlightPath::chain(const PathStart& start, const std::vector<Leg>& legs) {
  Segments segments;
  PathStart now = start;
  for (const Leg& leg : legs) {
    segments.push_back({now, leg});
    now = advance(now, leg, leg.duration);
    if (now.speed < 0.0)
      throw std::invalid_argument("leg " + std::to_string(segments.size()) + " makes the speed negative");
  }
  segments.push_back({now, Leg{}});
  return segments;
}

double FlightPath::leavesForGood(const Eigen::Vector2d& centre, double radius) const {
  return leavesForGood(segments_.back().start, centre, radius);
}

double FlightPath::leavesForGood(const PathStart& straight, const Eigen::Vector2d& centre, double radius) {
  if (straight.speed <= 0.0) return std::numeric_limits<double>::infinity();
  const Eigen::Vector2d from = straight.position - centre;
  const double along = from.dot(direction(straight.course));
  const double passes_inside = radius * radius - from.squaredNorm() + along * along;
  if (passes_inside <= 0.0) return straight.time;
  return straight.time + std::max(0.0, std::sqrt(passes_inside) - along) / straight.speed;
}

TargetState FlightPath::at(double time) const {
  const auto startsLater = [](double t, const Segment& segment) { return t < segment.start.time; };
  const auto next = std::upper_bound(segments_.begin() + 1, segments_.end(), time, startsLater);
  const Segment& segment = *(next - 1);
  const PathStart now = advance(segment.start, segment.leg, time - segment.start.time);
  return overTheSea(now.position, direction(now.course) * now.speed, now.height, segment.leg.climb_rate,
                    origin_altitude_);
}

std::vector<Leg> legsThrough(const std::vector<Waypoint>& waypoints, double turn_rate, PathStart& start) {
  if (waypoints.size() < 2) throw std::invalid_argument("a path needs two waypoints at least");
  start.position = waypoints[0].position;
  start.height = waypoints[0].height;
  start.speed = waypoints[0].speed;
  start.course = tws::azimuthOf(waypoints[1].position - waypoints[0].position);
  std::vector<Leg> legs;
  PathStart now = start;
  const auto add = [&](const Leg& leg) {
    legs.push_back(leg);
    now = advance(now, leg, leg.duration);
  };
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    try {
      const Leg turn = turnTowards(now, waypoints[i].position, turn_rate);
      if (turn.duration > 0.0) add(turn);
      add(straightTo(now, waypoints[i]));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("waypoint " + std::to_string(i + 1) + " " + error.what());
    }
  }
  return legs;
}

}  // namespace radar_sim
