#pragma once

#include <string>

#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/lock_step.h>

#include "mast_sensor.h"
#include "range_radar.h"
#include "reading.h"

namespace radar_sim {

/// A radar of a scenario that stares at one target and reports range profiles.
struct RangeSpec : SensorSpec {
  explicit RangeSpec(RangeRadarParams radar) : SensorSpec(radar.name), params(std::move(radar)) {}
  bool canHave(FaultKind fault) const override { return fault == FaultKind::kOutage; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  RangeRadarParams params;
};

/// One entry of the scenario's list `range_radars`.
std::unique_ptr<SensorSpec> readRangeSensor(ParameterReader& reader, const Scenario& scenario);

/// A range radar and its topics: its profiles go out, the commands that move its gate come in. What is wrong or late of
/// the latter is counted.
class RangeSensor : public MastSensor<RangeRadar> {
 public:
  RangeSensor(const RangeSpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return radar().nextProfile(); }
  void step() override;
  void skip() override { radar().takeProfile(); }
  bool isReady() const override;
  void stopWaiting() override;

 private:
  void applyCommands();
  void onGate(const tws_msgs::RangeGate& gate);

  tws_runtime::LockStep<tws_msgs::RangeGate> loop_;
  tws_runtime::Bus* bus_ = nullptr;
  std::string gate_topic_;
  tws_runtime::Publisher<tws_msgs::RangeProfile> profiles_;
};

}  // namespace radar_sim
