#pragma once

#include <cstdint>

#include <tws_msgs/Truth.h>
#include <tws_runtime/bus.h>

#include "sensor.h"

namespace radar_sim {

/// The truth is there in every scenario, before all sensors.
struct TruthSpec : SensorSpec {
  TruthSpec() : SensorSpec("truth") { kind = "truth"; }
  bool canHave(FaultKind) const override { return false; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;
};

/// Every target that exists, once a period, and what the sensors would measure of it; and outlines of clutter.
class TruthSensor : public Sensor {
 public:
  TruthSensor(const TruthSpec& spec, const Scene& scene) : Sensor(spec), scene_(scene) {}

  void connect(SensorPort& port) override;
  double nextTime() const override;
  void step() override;

 private:
  void addClutter(double time, tws_msgs::Truth& truth) const;
  tws_msgs::TruthTarget stateOf(std::size_t target, double time) const;

  Scene scene_;
  std::uint64_t count_ = 0;
  tws_runtime::Publisher<tws_msgs::Truth> topic_;
};

}  // namespace radar_sim
