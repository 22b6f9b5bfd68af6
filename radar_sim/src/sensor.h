#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fault.h"

namespace radar_sim {

struct Scenario;
class Sensor;
class SensorPort;
struct Target;

/// What the sensors of a run are made of, and where they find one another. Outlives them.
struct Scene {
  const Scenario& scenario;
  const std::vector<Target>& targets;
  const std::vector<std::unique_ptr<Sensor>>& sensors;  ///< In their order; while they are made, those before.
};

/// One sensor as a scenario describes it: its parameters, and what makes the sensor of them.
struct SensorSpec {
  explicit SensorSpec(std::string sensor) : name(std::move(sensor)) {}
  virtual ~SensorSpec() = default;

  std::string kind;  ///< The scenario's key under which it stands.
  std::string name;  ///< Also its topics' first part and its tf frame.

  /// Whether a scenario may let this go wrong with it.
  virtual bool canHave(FaultKind fault) const = 0;
  /// Throws std::invalid_argument when the scenario contradicts itself.
  virtual std::unique_ptr<Sensor> make(const Scene& scene) const = 0;
};

/// Where a sensor sees a target, and how well.
struct Sighting {
  double slant_range;            ///< [m]
  double azimuth;                ///< [rad], [0, 2π)
  double detection_probability;  ///< Chance that one look, now, detects the target.
};

/// One simulated sensor at work, step by step, in its place among the others. A kind's mathematics stands in a class
/// without ROS; the Sensor around it turns its reports into messages and closes its loops. Times in [s of data time].
class Sensor {
 public:
  explicit Sensor(const SensorSpec& spec) : kind_(spec.kind), name_(spec.name) {}
  virtual ~Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;

  const std::string& kind() const { return kind_; }
  const std::string& name() const { return name_; }

  /// Opens its topics and publishes its frame. Once, before the first step.
  virtual void connect(SensorPort& port) = 0;

  /// Time of what the next step publishes; never goes back. Infinite: it does not step by itself.
  virtual double nextTime() const { return std::numeric_limits<double>::infinity(); }
  /// Goes on to there and publishes.
  virtual void step() {}
  /// Goes on to there and publishes nothing: it is silent then.
  virtual void skip() {}
  virtual bool isSilentAt(double) const { return false; }

  /// Whether all commands have come by which the next step goes (tws_runtime/lock_step.h).
  virtual bool isReady() const { return true; }
  /// They will not come: the next step goes without them.
  virtual void stopWaiting() {}

  /// Where its beam points, for the sector marks of the others [rad]; nothing: it is silent, or has no beam that turns.
  virtual std::optional<double> beamAt(double) const { return std::nullopt; }
  /// Whether the truth states its sightings.
  virtual bool hasSightings() const { return false; }
  /// `target`: index in the scene's targets, one that exists at that time.
  virtual Sighting sightingOf(std::size_t /*target*/, double /*time*/) const { return {}; }

 private:
  std::string kind_, name_;
};

}  // namespace radar_sim
