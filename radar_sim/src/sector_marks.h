#pragma once

#include <cstdint>

#include <tws_msgs/SectorMark.h>
#include <tws_runtime/bus.h>

#include "sensor.h"

namespace radar_sim {

/// The sector marks of one rotating radar, with the running count of its plots and where other beams point.
class SectorMarks {
 public:
  /// What the radar says of the sector that a mark closes.
  struct Closed {
    std::int64_t running;    ///< Sectors since the start.
    double time;             ///< Of the mark [s of data time].
    double leave_time;       ///< The same by the radar's clock.
    std::size_t plots;       ///< In that sector.
    double rotation_period;  ///< Of the latest full revolution [s]; NaN before there was one.
  };

  SectorMarks(const Sensor& radar, const Scene& scene) : radar_(radar), scene_(scene) {}

  void connect(SensorPort& port);
  void publish(const Closed& sector);

 private:
  const Sensor& radar_;
  Scene scene_;
  std::uint64_t plot_count_ = 0;  // since the start
  tws_runtime::Publisher<tws_msgs::SectorMark> topic_;
};

}  // namespace radar_sim
