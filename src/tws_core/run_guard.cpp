#include <tws_core/run_guard.h>

#include <algorithm>
#include <cmath>

namespace tws {
namespace {

constexpr int kFewestMessages = 3;
constexpr double kShortest = 1.0;       // [s]
constexpr double kLongestGap = 60.0;    // between messages of a slow stream that agree [s]
constexpr double kLongestDelay = 60.0;  // of what a stream hands in later, all at once, behind a gap of its input [s]

}  // namespace

std::size_t RunGuard::addStream() {
  streams_.emplace_back();
  return streams_.size() - 1;
}

RunGuard::Verdict RunGuard::judge(std::size_t stream, double time) {
  Stream& own = streams_.at(stream);
  if (!newest_) begun_ = time;
  if (isInLine(time)) {
    own.newest = std::max(time, own.newest.value_or(time));
    newest_ = std::max(time, newest_.value_or(time));
    own.departure.reset();
    return Verdict::kTake;
  }
  depart(own, time);
  if (!isConfirmed(*own.departure)) return Verdict::kHold;
  const bool back = own.departure->newest < *newest_;
  step_ = own.departure->step;
  begun_ = own.departure->first;
  newest_ = own.departure->newest;
  for (Stream& each : streams_) each.newest.reset();
  own = Stream{newest_, std::nullopt};
  return back ? Verdict::kNewRun : Verdict::kResume;
}

bool RunGuard::agrees(double time) const {
  return newest_ && time >= begun_ - restart_limit_ && time <= *newest_ + restart_limit_;
}

bool RunGuard::isInLine(double time) const {
  return !newest_ || (time >= *newest_ - restart_limit_ && time <= *newest_ + std::max(restart_limit_, 1.5 * step_));
}

void RunGuard::depart(Stream& stream, double time) const {
  std::optional<Departure>& departure = stream.departure;
  const double step = departure ? time - departure->newest : 0.0;
  if (!departure || step < -restart_limit_ || step > std::max(restart_limit_, kLongestGap))
    departure = {time, time, *newest_, 0.0, 0};
  else
    departure->step = std::max(departure->step, step);
  departure->first = std::min(departure->first, time);
  departure->newest = std::max(departure->newest, time);
  ++departure->messages;
}

/// Who has gone on with the old run for half as long meanwhile speaks against it; less may have been on its way.
/// Against a step back speaks, too, who was there when it began: a stream that hands in all at once what its input
/// lacked for a while leaves the others no time to go on.
bool RunGuard::isConfirmed(const Departure& departure) const {
  const double span = departure.newest - departure.first;
  if (departure.messages < kFewestMessages || span < kShortest) return false;
  const bool may_be_late = departure.newest < departure.old_newest && span < kLongestDelay;
  int margin = 0;
  for (const Stream& stream : streams_) {
    if (stream.departure && std::abs(stream.departure->newest - departure.newest) <= restart_limit_)
      ++margin;
    else if (stream.newest && *stream.newest > departure.old_newest + (may_be_late ? -restart_limit_ : 0.5 * span))
      --margin;
  }
  return margin > 0;
}

}  // namespace tws
