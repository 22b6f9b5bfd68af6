#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <tws_core/plot.h>

namespace adit_tracker {

/// A plot that waits in the detection file, and what has become of it.
struct Detection {
  tws::Plot plot;
  bool used = false;               // by a track or the clutter map: it is out of the file (NB is one less)
  std::uint64_t flagged_in = 0;    // the correlation run in which it proved closer to a track in a secondary sector
  std::uint32_t claim = kNoClaim;  // clutter point on probation that would have taken it
  static constexpr std::uint32_t kNoClaim = 0xffffffff;
};

/// The detections of one sector of one radar, by range.
struct DetectionSector {
  std::int64_t running = -1;
  double enter_time = 0.0, leave_time = 0.0;
  std::vector<Detection> detections;  // in order of range
  std::vector<double> ranges;         // the same ranges, side by side for the search

  /// The detections with from ≤ range ≤ to. Cost: logarithm of the number in the sector.
  std::pair<Detection*, Detection*> inRange(double from, double to) {
    const double* const begin = ranges.data();
    const double* const end = begin + ranges.size();
    const double* const first = std::lower_bound(begin, end, from);
    const double* last = first;
    while (last != end && *last <= to) ++last;
    return {detections.data() + (first - begin), detections.data() + (last - begin)};
  }
};

/// The latest sectors of one radar (the report's input data bank: RM, AM, TM, addressed by NP and NB).
class DetectionFile {
 public:
  DetectionFile();

  /// Takes a sector in; running numbers grow. The oldest makes room. Plots must be finite with range > 0.
  DetectionSector& add(const tws::RadarSector& sector);

  /// An empty sector with running -1 when it is not there (never received, or too old).
  DetectionSector& at(std::int64_t running);

 private:
  static constexpr std::int64_t kKept = 128;  // two turns
  std::vector<DetectionSector> sectors_;
  DetectionSector empty_;
};

}  // namespace adit_tracker
