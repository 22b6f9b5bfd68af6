#pragma once

#include <string>

#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/bus.h>

#include "mast_sensor.h"
#include "reading.h"
#include "secondary_radar.h"
#include "sector_marks.h"

namespace radar_sim {

/// A rotating secondary radar of a scenario.
struct SecondarySpec : SensorSpec {
  explicit SecondarySpec(SecondaryParams radar) : SensorSpec(radar.name), params(std::move(radar)) {}
  /// It has no false alarms: its FRUIT is a parameter of its own.
  bool canHave(FaultKind fault) const override { return fault != FaultKind::kFalseAlarmBurst; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  SecondaryParams params;
};

/// One entry of the scenario's list `secondary_radars`.
std::unique_ptr<SensorSpec> readSecondarySensor(ParameterReader& reader, const Scenario& scenario);

/// The message of one sector of a secondary radar.
tws_msgs::SsrPlots toSsrPlots(const SecondarySector& sector, const std::string& radar);

/// A secondary radar and its topics: the plots of each sector, then the mark that closes it.
class SecondarySensor : public MastSensor<SecondaryRadar> {
 public:
  SecondarySensor(const SecondarySpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return radar().nextMark(); }
  void step() override;
  void skip() override { radar().closeSector(); }

 private:
  SectorMarks marks_;
  tws_runtime::Publisher<tws_msgs::SsrPlots> plots_;
};

}  // namespace radar_sim
