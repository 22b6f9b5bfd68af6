#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

#include <tws_msgs/Detections.h>
#include <tws_runtime/bus.h>

#include "elevation_loop.h"
#include "reading.h"
#include "rotating_radar.h"
#include "sector_marks.h"
#include "sensor.h"

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
class RotatingSensor : public Sensor {
 public:
  RotatingSensor(const RotatingSpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return radar_.nextMark(); }
  void step() override;
  void skip() override { radar_.closeSector(); }
  bool isSilentAt(double time) const override { return radar_.isSilentAt(time); }
  bool isReady() const override { return !elevation_ || elevation_->isReady(); }
  void stopWaiting() override;
  std::optional<double> beamAt(double time) const override;
  bool hasSightings() const override { return true; }
  Sighting sightingOf(std::size_t target, double time) const override;

  const Eigen::Isometry3d& mapToSite() const { return map_to_site_; }
  const RadarParams& params() const { return radar_.params(); }
  /// Calls `handler` with each sector that it has closed, between its plots and its mark.
  void onSector(std::function<void(const tws::RadarSector&)> handler) { on_sector_ = std::move(handler); }

 private:
  const std::vector<Target>& targets_;
  Eigen::Isometry3d map_to_site_;
  RotatingRadar radar_;
  SectorMarks marks_;
  std::optional<ElevationLoop> elevation_;
  std::function<void(const tws::RadarSector&)> on_sector_;
  tws_runtime::Publisher<tws_msgs::Detections> detections_;
};

}  // namespace radar_sim
