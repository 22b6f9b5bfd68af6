#include "detection_file.h"

#include <algorithm>
#include <tuple>

namespace adit_tracker {

DetectionFile::DetectionFile() : sectors_(kKept) {}

DetectionSector& DetectionFile::add(const tws::RadarSector& sector) {
  DetectionSector& slot = sectors_[static_cast<std::size_t>(sector.running % kKept)];
  slot.running = sector.running;
  slot.enter_time = sector.enter_time;
  slot.leave_time = sector.leave_time;
  slot.detections.clear();
  for (const tws::Plot& plot : sector.plots) slot.detections.push_back(Detection{plot, false, 0, Detection::kNoClaim});
  // Of plots at equal range the earlier goes first, so that the result is the same in every run.
  std::sort(slot.detections.begin(), slot.detections.end(), [](const Detection& a, const Detection& b) {
    return std::tie(a.plot.range, a.plot.time, a.plot.azimuth) < std::tie(b.plot.range, b.plot.time, b.plot.azimuth);
  });
  slot.places.clear();
  for (const Detection& detection : slot.detections) {
    slot.places.push_back({detection.plot.range, detection.plot.azimuth});
  }
  return slot;
}

DetectionSector& DetectionFile::at(std::int64_t running) {
  if (running >= 0) {
    DetectionSector& slot = sectors_[static_cast<std::size_t>(running % kKept)];
    if (slot.running == running) return slot;
  }
  return empty_;
}

}  // namespace adit_tracker
