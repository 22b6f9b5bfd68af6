#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include <tws_msgs/Detections.h>
#include <tws_runtime/bus.h>

#include "reading.h"
#include "sensor.h"

namespace radar_sim {

/// A kind of sensor that stands outside of the package's own, to be copied (doc/new_radar.md): a buoy that reports all
/// that is within its reach, once a period, without errors.
struct BuoySpec : SensorSpec {
  explicit BuoySpec(std::string buoy) : SensorSpec(std::move(buoy)) {}
  bool canHave(FaultKind fault) const override { return fault == FaultKind::kOutage; }
  std::unique_ptr<Sensor> make(const Scene& scene) const override;

  std::string site;
  double period = 2.0;  ///< [s]
  double reach = 10e3;  ///< Slant range [m].
};

/// One entry of the scenario's list `buoys`.
std::unique_ptr<SensorSpec> readBuoy(ParameterReader& reader, const Scenario& scenario);

/// What is in reach goes out as detections.
class BuoySensor : public Sensor {
 public:
  BuoySensor(const BuoySpec& spec, const Scene& scene);

  void connect(SensorPort& port) override;
  double nextTime() const override { return start_time_ + static_cast<double>(count_) * spec_.period; }
  void step() override;
  void skip() override { ++count_; }
  bool isSilentAt(double time) const override { return isFaulty(faults_, FaultKind::kOutage, time); }

 private:
  BuoySpec spec_;
  const std::vector<Target>& targets_;
  std::vector<Fault> faults_;
  double start_time_;
  Eigen::Isometry3d map_to_site_;
  std::uint32_t count_ = 0;
  tws_runtime::Publisher<tws_msgs::Detections> detections_;
};

}  // namespace radar_sim
