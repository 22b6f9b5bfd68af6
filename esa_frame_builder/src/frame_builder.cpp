#include "frame_builder.h"

#include "selection.h"

namespace esa_frame_builder {

std::vector<Frame> FrameBuilder::take(ResourcePeriod period) {
  std::vector<Frame> closed;
  resource_period_ = period.duration;
  for (Dwell& dwell : period.dwells) {
    while (testsTime() && !open_.empty() && open_.front().isTooOldFor(dwell.time)) closeOldest(closed);  // Part I
    const RangeSpan span = rangeSpanOf(dwell);
    insert({std::move(dwell), span}, closed);  // Part II
  }
  while (!open_.empty() && mustClose(open_.front(), period.next_dwell)) closeOldest(closed);  // Part III
  return closed;
}

std::vector<Frame> FrameBuilder::closeStale(double now) {
  std::vector<Frame> closed;
  while (!open_.empty() && open_.front().isTooOldFor(now)) closeOldest(closed);
  return closed;
}

std::vector<Frame> FrameBuilder::partialFrames() const {
  std::vector<Frame> frames;
  for (const OpenFrame& frame : open_) frames.push_back(selected(frame, params_));
  return frames;
}

bool FrameBuilder::testsTime() const {
  return params_.algorithm == Algorithm::kAcrossPeriods || params_.algorithm == Algorithm::kSeveralOpen;
}

// Part II. Within a resource period only the beam point test counts; across periods (28) says which one does.
bool FrameBuilder::rejects(const OpenFrame& frame, const SpannedDwell& dwell) const {
  if (params_.algorithm == Algorithm::kDwellIsFrame) return true;
  const bool by_beam_point = !testsTime() || frame.beamPointsHold(dwell.dwell.time, resource_period_);
  return by_beam_point ? frame.beamPointTestRejects(dwell) : frame.dwellGroupTestRejects(dwell.dwell);
}

// The open frame for the dwell, by its place from the oldest; one beyond the youngest: a new one.
std::size_t FrameBuilder::placeFor(const SpannedDwell& dwell) const {
  for (std::size_t i = open_.size(); i-- > 0;) {
    if (rejects(open_[i], dwell)) return i + 1;
    if (open_[i].mayShareTargets(dwell)) return i;
  }
  return 0;
}

void FrameBuilder::insert(SpannedDwell dwell, std::vector<Frame>& closed) {
  const std::size_t greatest = params_.algorithm == Algorithm::kSeveralOpen ? params_.open_frames : 1;
  std::size_t place = placeFor(dwell);
  if (place == open_.size()) {
    if (open_.size() == greatest) {
      closeOldest(closed);
      --place;
    }
    open_.emplace_back(next_number_++, params_);
  }
  open_[place].add(std::move(dwell));
}

// Part IV: selection processing.
void FrameBuilder::closeOldest(std::vector<Frame>& closed) {
  closed.push_back(selected(open_.front(), params_));
  closed.back().closed = true;
  open_.pop_front();
}

// At the end of a resource period.
bool FrameBuilder::mustClose(const OpenFrame& frame, double next_dwell) const {
  if (!testsTime()) return true;
  return params_.expects_next_dwell && frame.willGrowStale(next_dwell);
}

}  // namespace esa_frame_builder
