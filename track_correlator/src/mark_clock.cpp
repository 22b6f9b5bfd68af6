#include "mark_clock.h"

#include <tws_core/sectors.h>

namespace track_correlator {
namespace {

constexpr std::int64_t kLongestGap = std::int64_t{8} * tws::kSectors;

}  // namespace

MarkClock::Step MarkClock::add(const Mark& mark) {
  Step step;
  std::int64_t gap = newest_ ? mark.running - newest_->running : 1;
  if (gap <= 0 || gap > kLongestGap) {
    step.restarted = stray_ && mark.running == *stray_ + 1;
    stray_ = mark.running;
    step.stray = !step.restarted;
    if (step.stray) return step;
    marks_.clear();
    gap = 1;
  }
  stray_.reset();
  for (std::int64_t n = 1; n < gap; ++n) {
    ++step.lost;
    const double part = static_cast<double>(n) / static_cast<double>(gap);
    enter({newest_->running + n, newest_->time + part * (mark.time - newest_->time)}, step);
  }
  enter(mark, step);
  newest_ = mark;
  return step;
}

void MarkClock::enter(const Mark& mark, Step& step) {
  marks_.push_back(mark);
  if (marks_.size() <= delay_) return;
  step.due.push_back(marks_.front());
  marks_.pop_front();
}

}  // namespace track_correlator
