#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tws_msgs/DwellReports.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "array_radar.h"
#include "reading.h"
#include "sensor.h"

namespace radar_sim {

/// An electronically scanned array of a scenario.
struct ArraySpec : SensorSpec {
  explicit ArraySpec(ArrayParams array) : SensorSpec(array.name), params(std::move(array)) {}
  bool canHave(FaultKind fault) const override { return fault != FaultKind::kFalseAlarmBurst; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  ArrayParams params;
};

/// One entry of the scenario's list `array_radars`.
std::unique_ptr<SensorSpec> readArraySensor(ParameterReader& reader, const Scenario& scenario);

/// An array and its topics: its dwell reports go out, the track database that its dwells are planned by comes in. What
/// is wrong or late of the latter is counted.
class ArraySensor : public Sensor {
 public:
  ArraySensor(const ArraySpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return radar_.nextReport(); }
  void step() override;
  void skip() override { radar_.runPeriod(); }
  bool isSilentAt(double time) const override { return radar_.isSilentAt(time); }
  bool isReady() const override;
  void stopWaiting() override;
  bool hasSightings() const override { return true; }
  Sighting sightingOf(std::size_t target, double time) const override;

 private:
  void applyCommands();
  void onTracks(const tws_msgs::TrackDatabase& database);

  const std::vector<Target>& targets_;
  ArrayRadar radar_;
  tws_runtime::LockStep<std::vector<ArrayTrack>> loop_;
  tws_runtime::Bus* bus_ = nullptr;
  std::string database_topic_;
  tws_runtime::Publisher<tws_msgs::DwellReports> reports_;
};

}  // namespace radar_sim
