#include "core/plot_fates.h"

#include <algorithm>
#include <utility>

#include "core/detection_file.h"

namespace adit_tracker {
namespace {

/// What correlation and clutter map have made of a detection.
PlotFate fateSoFar(const Detection& detection) {
  PlotFate fate{detection.plot, PlotFate::kLeft, 0, detection.left, detection.claims};
  if (detection.used && detection.left == 0.0) fate.kind = PlotFate::kSkipped;
  if (detection.absorbed) fate.kind = PlotFate::kClutter;
  for (const PlotClaim& claim : detection.claims) {
    if (!claim.took) continue;
    fate.kind = PlotFate::kUpdated;
    fate.uid = claim.uid;
  }
  return fate;
}

}  // namespace

void PlotTeller::start(Sink sink, std::size_t radars) {
  sink_ = std::move(sink);
  told_.assign(radars, -1);
}

void PlotTeller::tellBefore(std::size_t radar, DetectionFile& detections, std::int64_t running) {
  const std::int64_t first = std::max(told_[radar] + 1, running - DetectionFile::kKept);
  for (std::int64_t sector = first; sector < running; ++sector) {
    const DetectionSector& there = detections.at(sector);
    if (there.running != sector) continue;
    for (const Detection& detection : there.detections) add(detection);
    tell(radar, sector);
  }
}

void PlotTeller::add(const Detection& detection) { plots_.push_back(fateSoFar(detection)); }

void PlotTeller::started(std::uint32_t uid) {
  plots_.back().kind = PlotFate::kStarted;
  plots_.back().uid = uid;
}

void PlotTeller::tell(std::size_t radar, std::int64_t running) {
  told_[radar] = running;
  sink_({radar, running, std::exchange(plots_, {})});
}

}  // namespace adit_tracker
