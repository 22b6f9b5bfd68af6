#include <tws_core/run_guard.h>

#include <algorithm>
#include <cmath>

namespace tws {
namespace {

constexpr int kFewestMessages = 3;
constexpr double kShortest = 1.0;  // [s]

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
  begun_ = own.departure->first;
  newest_ = own.departure->newest;
  for (Stream& each : streams_) each.newest.reset();
  own = Stream{newest_, std::nullopt};
  return back ? Verdict::kNewRun : Verdict::kResume;
}

bool RunGuard::agrees(double time) const {
  return newest_ && time >= begun_ - restart_limit_ && time <= *newest_ + restart_limit_;
}

bool RunGuard::isInLine(double time) const { return !newest_ || std::abs(time - *newest_) <= restart_limit_; }

void RunGuard::depart(Stream& stream, double time) const {
  std::optional<Departure>& departure = stream.departure;
  if (!departure || std::abs(time - departure->newest) > restart_limit_) departure = {time, time, *newest_, 0};
  departure->first = std::min(departure->first, time);
  departure->newest = std::max(departure->newest, time);
  ++departure->messages;
}

/// Who has gone on with the old run for half as long meanwhile speaks against it; less may have been on its way.
bool RunGuard::isConfirmed(const Departure& departure) const {
  const double span = departure.newest - departure.first;
  if (departure.messages < kFewestMessages || span < kShortest) return false;
  int margin = 0;
  for (const Stream& stream : streams_) {
    if (stream.departure && std::abs(stream.departure->newest - departure.newest) <= restart_limit_)
      ++margin;
    else if (stream.newest && *stream.newest > departure.old_newest + 0.5 * span)
      --margin;
  }
  return margin > 0;
}

}  // namespace tws
