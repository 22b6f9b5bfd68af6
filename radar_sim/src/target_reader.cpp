#include "target_reader.h"

#include <cmath>
#include <limits>

#include <tws_core/units.h>

#include "flight_path.h"
#include "recorded_trajectory.h"
#include "transponder_reader.h"

namespace radar_sim {
namespace {

using tws::kRadiansPerDegree;

constexpr double kGreatestHeight = 50000.0;                       // [m]
constexpr double kSlowest = 50.0 * tws::kMetresPerSecondPerKnot;  // what is faster is no slow mover [m/s]
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Clutter and slow movers hug the ground, where the radar equation over a flat sea says little: their chance is given.
Reflection defaultReflection(TargetKind kind) {
  Reflection reflection;
  if (kind == TargetKind::kClutter) reflection.detection_probability = 0.8;
  if (kind == TargetKind::kClutter) reflection.jitter = 50.0;
  if (kind == TargetKind::kSlowMover) reflection.detection_probability = 0.7;
  if (kind == TargetKind::kShip) reflection.rcs = 1000.0;
  return reflection;
}

/// Aircraft reply in modes 3/A and C, others not at all.
Transponder defaultTransponder(TargetKind kind) {
  Transponder transponder;
  transponder.altitude = kind == TargetKind::kAircraft;
  if (kind == TargetKind::kAircraft) transponder.codes[index(Mode::k3A)] = Transponder::kDrawn;
  return transponder;
}

TargetKind readKind(ParameterReader& reader) {
  std::string kind = "aircraft";
  reader.choice("kind", kind, {"aircraft", "ship", "slow_mover"});
  return kind == "aircraft" ? TargetKind::kAircraft : kind == "ship" ? TargetKind::kShip : TargetKind::kSlowMover;
}

Leg readLeg(ParameterReader& reader) {
  Leg leg;
  reader.require("duration_s");
  reader.number("duration_s", leg.duration, 0.001, kLongest);
  scaledNumber(reader, "turn_rate_deg_s", leg.turn_rate, kRadiansPerDegree, -90.0, 90.0);
  if (leg.turn_rate != 0.0 && std::abs(leg.turn_rate) < 1e-5)
    reader.fail("turn_rate_deg_s", "is too small to be a turn: 0, or 0.001 at least");
  reader.number("acceleration_mps2", leg.acceleration, -200.0, 200.0);
  reader.number("climb_mps", leg.climb_rate, -500.0, 500.0);
  reader.done();
  return leg;
}

using TrajectoryPointer = std::shared_ptr<const Trajectory>;

/// start_s and end_s, in data time.
TimeSpan readLife(ParameterReader& reader, const ReadingContext& context) {
  double start = 0.0;
  double end = kLongest;
  reader.number("start_s", start, 0.0, kLongest);
  reader.number("end_s", end, 0.0, kLongest);
  if (end <= start) reader.fail("end_s", "is not later than start_s");
  return {context.start_time + start, reader.has("end_s") ? context.start_time + end : kNoEnd};
}

TrajectoryPointer readLegs(ParameterReader& reader, const ReadingContext& context) {
  const TimeSpan life = readLife(reader, context);
  PathStart start;
  start.time = life.start;
  start.position = readPlace(reader, context);
  reader.number("height_m", start.height, 0.0, kGreatestHeight);
  scaledNumber(reader, "course_deg", start.course, kRadiansPerDegree, 0.0, 360.0);
  readSpeed(reader, start.speed);
  std::vector<Leg> legs;
  for (ParameterReader& leg : reader.list("legs")) legs.push_back(readLeg(leg));
  return orFail(reader, "legs",
                [&] { return std::make_shared<FlightPath>(start, legs, context.map.origin().altitude, life.end); });
}

Waypoint readWaypoint(ParameterReader& reader, const ReadingContext& context, const Waypoint& before) {
  Waypoint waypoint = before;
  waypoint.position = readPlace(reader, context);
  reader.number("height_m", waypoint.height, 0.0, kGreatestHeight);
  readSpeed(reader, waypoint.speed);
  if (waypoint.speed <= 0.0) reader.fail("speed_mps", "a speed above 0 is needed to reach a waypoint");
  reader.done();
  return waypoint;
}

TrajectoryPointer readWaypoints(ParameterReader& reader, const ReadingContext& context) {
  const TimeSpan life = readLife(reader, context);
  double turn_rate = tws::radians(3.0);
  scaledNumber(reader, "turn_rate_deg_s", turn_rate, kRadiansPerDegree, 0.01, 90.0);
  std::vector<Waypoint> waypoints;
  for (ParameterReader& entry : reader.list("waypoints")) {
    waypoints.push_back(
        readWaypoint(entry, context, waypoints.empty() ? Waypoint{{0.0, 0.0}, 0.0, 0.0} : waypoints.back()));
  }
  return orFail(reader, "waypoints", [&] {
    PathStart start;
    start.time = life.start;
    const std::vector<Leg> legs = legsThrough(waypoints, turn_rate, start);
    return std::make_shared<FlightPath>(start, legs, context.map.origin().altitude, life.end);
  });
}

TrajectoryPointer readRecorded(ParameterReader& reader, const ReadingContext& context) {
  RecordingWindow window;
  window.at = readLife(reader, context).start;
  if (reader.has("end_s")) reader.fail("end_s", "a recording ends by itself, or at recording.to_s");
  ParameterReader recording = reader.map("recording");
  std::string file;
  recording.require("file");
  recording.text("file", file);
  if (file.empty()) recording.fail("file", "is empty");
  recording.number("from_s", window.from, -kLongest, kLongest);
  recording.number("to_s", window.to, -kLongest, kLongest);
  if (window.to <= window.from) recording.fail("to_s", "is not later than from_s");
  recording.number("smoothing_s", window.smoothing, 0.1, 600.0);
  recording.number("max_gap_s", window.max_gap, 0.1, kLongest);
  recording.done();
  const std::string path = file.front() == '/' ? file : context.folder + file;
  return orFail(recording, "file",
                [&] { return std::make_shared<RecordedTrajectory>(readRecording(path), window, context.map); });
}

TrajectoryPointer readTrajectory(ParameterReader& reader, const ReadingContext& context) {
  if (reader.has("recording")) return readRecorded(reader, context);
  if (reader.has("waypoints")) return readWaypoints(reader, context);
  return readLegs(reader, context);
}

RandomGroup groupDefaults(TargetKind kind) {
  RandomGroup group;
  group.kind = kind;
  group.reflection = defaultReflection(kind);
  if (kind == TargetKind::kAircraft) {
    group.name = "aircraft";
    group.turning_fraction = 0.5;
    group.turn_rate = {tws::radians(1.0), tws::radians(3.0)};
    group.rebirth = true;
    group.keep_out = 5000.0;
    group.transponders = {1.0, 0.25};
    return group;
  }
  group.name = kind == TargetKind::kClutter ? "clutter" : "slow_mover";
  group.range = {5e3, 60e3};
  group.height = {5.0, 50.0};
  group.speed = {0.0, 0.0};
  if (kind == TargetKind::kSlowMover) group.speed = {tws::speedFromKnots(5.0), tws::speedFromKnots(45.0)};
  return group;
}

void readGroupMotion(ParameterReader& reader, RandomGroup& group) {
  const bool slow = group.kind == TargetKind::kSlowMover;
  readSpeed(reader, group.speed, slow ? kSlowest : 3000.0);
  reader.number("turning_fraction", group.turning_fraction, 0.0, 1.0);
  readInterval(reader, "turn_rate_deg_s", group.turn_rate, kRadiansPerDegree, 0.001, 90.0);
  readInterval(reader, "turn_duration_s", group.turn_duration, 1.0, 1.0, kLongest);
  readInterval(reader, "straight_duration_s", group.straight_duration, 1.0, 1.0, kLongest);
  reader.flag("rebirth", group.rebirth);
  reader.number("keep_out_m", group.keep_out, 0.0, kFarthest);
  if (group.turning_fraction > 0.0 && group.turn_rate.greatest <= 0.0)
    reader.fail("turn_rate_deg_s", "is required with turning_fraction");
}

}  // namespace

Target readTarget(ParameterReader& reader, const ReadingContext& context) {
  Target target;
  readName(reader, target.name);
  target.kind = readKind(reader);
  target.reflection = defaultReflection(target.kind);
  readReflection(reader, target.reflection, true);
  reader.number("length_m", target.body.length, 0.0, 2000.0);
  reader.integer("scatterers", target.body.scatterers, 1, 10000);
  reader.number("fading_time_s", target.body.fading_time, 1e-4, 1e4);
  target.trajectory = readTrajectory(reader, context);
  target.transponder = defaultTransponder(target.kind);
  readTransponder(reader, context, target.transponder);
  reader.done();
  return target;
}

Target readClutterPoint(ParameterReader& reader, const ReadingContext& context) {
  Target target;
  readName(reader, target.name);
  target.kind = TargetKind::kClutter;
  target.reflection = defaultReflection(target.kind);
  readReflection(reader, target.reflection, false);
  PathStart start;
  const TimeSpan life = readLife(reader, context);
  start.time = life.start;
  start.position = readPlace(reader, context);
  reader.number("height_m", start.height, 0.0, kGreatestHeight);
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, context.map.origin().altitude, life.end);
  reader.done();
  return target;
}

RandomGroup readGroup(ParameterReader& reader, TargetKind kind, const ReadingContext& context) {
  RandomGroup group = groupDefaults(kind);
  readName(reader, group.name);
  reader.require("count");
  reader.integer("count", group.count, 0, 1000000);
  ParameterReader centre = reader.map("centre");
  group.centre = readPlace(centre, context, Eigen::Vector2d(0.0, 0.0));
  centre.done();
  readInterval(reader, "range_m", group.range, 1.0, 0.0, kFarthest / 10.0);
  readInterval(reader, "height_m", group.height, 1.0, 0.0, kGreatestHeight);
  readReflection(reader, group.reflection, false);
  group.life = readLife(reader, context);
  if (kind != TargetKind::kClutter) readGroupMotion(reader, group);
  if (kind == TargetKind::kAircraft) readInterval(reader, "rcs_m2", group.rcs, 1.0, 1e-6, 1e7);
  if (kind != TargetKind::kClutter) readTransponderShares(reader, group.transponders);
  reader.done();
  return group;
}

}  // namespace radar_sim
