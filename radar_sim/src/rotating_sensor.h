#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <tws_msgs/Detections.h>
#include <tws_runtime/bus.h>

#include "elevation_loop.h"
#include "mast_sensor.h"
#include "reading.h"
#include "rotating_radar.h"
#include "sector_marks.h"

namespace radar_sim {

/// A rotating primary radar of a scenario.
struct RotatingSpec : SensorSpec {
  explicit RotatingSpec(RadarParams radar) : SensorSpec(radar.name), params(std::move(radar)) {}
  bool canHave(FaultKind) const override { return true; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  RadarParams params;
};

/// One entry of the scenario's list `radars`.
std::unique_ptr<SensorSpec> readRotatingSensor(ParameterReader& reader, const Scenario& scenario);

/// A rotating primary radar and its topics: the plots of each sector, then the mark that closes it.
class RotatingSensor : public MastSensor<RotatingRadar> {
 public:
  RotatingSensor(const RotatingSpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return radar().nextMark(); }
  void step() override;
  void skip() override { radar().closeSector(); }
  bool isReady() const override { return !elevation_ || elevation_->isReady(); }
  void stopWaiting() override;
  std::optional<double> beamAt(double time) const override;
  bool hasSightings() const override { return true; }
  Sighting sightingOf(std::size_t target, double time) const override;

  const RadarParams& params() const { return radar().params(); }
  /// Calls `handler` with each sector that it has closed, between its plots and its mark.
  void onSector(std::function<void(const tws::RadarSector&)> handler) { on_sector_ = std::move(handler); }

 private:
  const std::vector<Target>& targets_;
  SectorMarks marks_;
  std::optional<ElevationLoop> elevation_;
  std::function<void(const tws::RadarSector&)> on_sector_;
  tws_runtime::Publisher<tws_msgs::Detections> detections_;
};

}  // namespace radar_sim
