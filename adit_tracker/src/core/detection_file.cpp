#include "core/detection_file.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <tws_core/sectors.h>

namespace adit_tracker {

void DetectionSector::index() {
  // Of plots at equal range the earlier goes first, so that the result is the same in every run.
  std::sort(detections.begin(), detections.end(), [](const Detection& a, const Detection& b) {
    return std::tie(a.plot.range, a.plot.time, a.plot.azimuth) < std::tie(b.plot.range, b.plot.time, b.plot.azimuth);
  });
  places.clear();
  middle = tws::sectorStart(tws::wrapSector(static_cast<int>(running % tws::kSectors))) + 0.5 * tws::kSectorWidth;
  spread = 0.0;
  for (const Detection& detection : detections) {
    places.push_back({detection.plot.range, detection.plot.azimuth});
    spread = std::max(spread, std::abs(tws::angularDifference(detection.plot.azimuth, middle)));
  }
  begins.assign(places.size(), 0);
  if (places.empty()) return;
  bin = places.back().range / static_cast<double>(places.size());
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    for (const std::size_t its_bin = binOf(places[i].range); next <= its_bin; ++next) begins[next] = i;
  }
}

DetectionFile::DetectionFile() : sectors_(kKept) {}

DetectionSector& DetectionFile::add(const tws::RadarSector& sector) {
  DetectionSector& slot = sectors_[static_cast<std::size_t>(sector.running % kKept)];
  slot.running = sector.running;
  slot.enter_time = sector.enter_time;
  slot.leave_time = sector.leave_time;
  slot.detections.clear();
  for (const tws::Plot& plot : sector.plots) slot.detections.emplace_back().plot = plot;
  slot.ship.reset();
  slot.taken = {};
  slot.index();
  return slot;
}

void DetectionFile::moveOrigin(double dx, double dy) {
  for (DetectionSector& sector : sectors_) {
    if (sector.detections.empty()) continue;
    for (Detection& each : sector.detections) adit_tracker::moveOrigin(each.plot.range, each.plot.azimuth, dx, dy);
    sector.index();
  }
}

DetectionSector& DetectionFile::at(std::int64_t running) {
  if (running >= 0) {
    DetectionSector& slot = sectors_[static_cast<std::size_t>(running % kKept)];
    if (slot.running == running) return slot;
  }
  return empty_;
}

}  // namespace adit_tracker
