#include "sector_marks.h"

#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>

#include "sensor_port.h"

namespace radar_sim {

void SectorMarks::connect(SensorPort& port) { topic_ = port.advertise<tws_msgs::SectorMark>("sector_marks"); }

void SectorMarks::publish(const Closed& sector) {
  plot_count_ += sector.plots;
  tws_msgs::SectorMark mark;
  mark.radar = radar_.name();
  mark.header.stamp = tws_runtime::toTime(sector.leave_time);
  mark.header.frame_id = radar_.name();
  mark.sector = static_cast<std::uint8_t>((sector.running + 1) % tws::kSectors);
  mark.running_sector = static_cast<std::uint32_t>(sector.running + 1);
  mark.closed_sector = static_cast<std::uint8_t>(sector.running % tws::kSectors);
  mark.closed_count = static_cast<std::uint32_t>(sector.plots);
  mark.running_count = static_cast<std::uint32_t>(plot_count_);
  mark.rotation_period = sector.rotation_period;
  for (const std::unique_ptr<Sensor>& other : scene_.sensors) {
    const auto beam = other.get() == &radar_ ? std::nullopt : other->beamAt(sector.time);
    if (!beam) continue;
    mark.other_radars.push_back(other->name());
    mark.other_azimuths.push_back(*beam);
  }
  topic_.publish(mark);
}

}  // namespace radar_sim
