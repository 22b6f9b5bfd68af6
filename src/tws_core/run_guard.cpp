#include <tws_core/run_guard.h>

#include <algorithm>
#include <cmath>

namespace tws {
namespace {

constexpr int kFewestMessages = 3;
constexpr double kShortest = 1.0;          // [s]
constexpr double kLongestGap = 60.0;       // between messages of a slow stream that agree [s]
constexpr double kLongestPatience = 60.0;  // with sources that say nothing while another goes elsewhere [s]

}  // namespace

RunGuard::RunGuard(std::size_t streams, double restart_limit, double skew_limit)
    : sources_(0), restart_limit_(restart_limit), skew_limit_(skew_limit) {
  for (std::size_t i = 0; i < streams; ++i) addStream();
}

std::size_t RunGuard::addStream(std::optional<std::size_t> source) {
  streams_.push_back({source ? *source : sources_});
  if (!source) ++sources_;
  return streams_.size() - 1;
}

RunGuard::Verdict RunGuard::judge(std::size_t stream, double time, std::optional<double> clock) {
  Stream& own = streams_.at(stream);
  if (!newest_) begun_ = time;
  if (isInLine(own, time)) {
    take(own, time);
    return Verdict::kTake;
  }
  depart(own, time);
  compareWithRival(own, time);
  if (isConfirmed(own, clock)) return go(own);
  setAsideWhenOutvoted(own);
  return Verdict::kHold;
}

void RunGuard::take(Stream& stream, double time) {
  if (stream.departure) ++stream.rival.changes;
  stream.departure.reset();
  stream.newest = std::max(time, stream.newest.value_or(time));
  newest_ = std::max(time, newest_.value_or(time));
  stream.standing = *stream.newest < *newest_ - restart_limit_ ? Standing::kLagging : Standing::kInLine;
}

bool RunGuard::agrees(double time) const {
  return newest_ && time >= begun_ - restart_limit_ && time <= *newest_ + restart_limit_;
}

bool RunGuard::isInLine(const Stream& stream, double time) const {
  if (!newest_) return true;
  if (stepsAside(stream, time)) return false;
  if (isInRun(time)) return true;
  return stream.newest && time >= *stream.newest - restart_limit_ &&
         time <= *stream.newest + std::max(restart_limit_, 1.5 * step_);
}

bool RunGuard::isInRun(double time) const {
  return time >= *newest_ - restart_limit_ && time <= *newest_ + std::max(restart_limit_, 1.5 * step_);
}

/// Out of step with the other sources, after a step of its own: who lags or leads without one has a slow line, or the
/// others have.
bool RunGuard::stepsAside(const Stream& stream, double time) const {
  const std::optional<double> others = newestOfOthers(stream);
  if (!others || std::abs(time - *others) <= skew_limit_) return false;
  if (stream.standing == Standing::kSetAside) return true;
  return stream.newest && std::abs(*others - *stream.newest) <= restart_limit_ &&
         std::abs(time - *stream.newest) > skew_limit_;
}

std::optional<double> RunGuard::newestOfOthers(const Stream& stream) const {
  std::optional<double> newest;
  if (!std::isfinite(skew_limit_)) return newest;
  for (const Stream& other : streams_)
    if (other.source != stream.source && other.newest) newest = std::max(*other.newest, newest.value_or(*other.newest));
  return newest;
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

void RunGuard::compareWithRival(Stream& stream, double time) const {
  Rival& rival = stream.rival;
  if (rival.messages == 0 || std::abs(time - rival.newest) > restart_limit_) rival = {time, 0, 0};
  rival.newest = time;
  ++rival.messages;
  if (rival.messages >= kFewestMessages && rival.changes + 1 >= kFewestMessages) stream.standing = Standing::kRivalled;
}

void RunGuard::setAsideWhenOutvoted(Stream& stream) const {
  const Departure& departure = *stream.departure;
  if (departure.messages < kFewestMessages || *newest_ < departure.old_newest + kShortest) return;
  stream.newest.reset();
  stream.standing = Standing::kSetAside;
}

bool RunGuard::isConfirmed(const Stream& stream, std::optional<double> clock) const {
  const Departure& departure = *stream.departure;
  if (departure.messages < kFewestMessages || departure.newest - departure.first < kShortest) return false;
  std::vector<int> votes(sources_, 0);
  for (const Stream& each : streams_) {
    int& vote = votes[each.source];
    const int its = voteOf(each, departure);
    vote = vote < 0 || its < 0 ? -1 : std::max(vote, its);
  }
  int margin = clock && sources_ > 1 ? voteOf(*clock, departure) : 0;
  for (const int vote : votes) margin += vote;
  return votes[stream.source] > 0 && margin > 0;
}

int RunGuard::voteOf(const Stream& stream, const Departure& departure) const {
  if (stream.departure && std::abs(stream.departure->newest - departure.newest) <= restart_limit_) return 1;
  const double span = departure.newest - departure.first;
  // Time to follow: others may be slow, or their messages are still on their way.
  const double latest = departure.old_newest + (span < kLongestPatience ? -restart_limit_ : 0.5 * span);
  return stream.newest && *stream.newest > latest ? -1 : 0;
}

int RunGuard::voteOf(double clock, const Departure& departure) const {
  return static_cast<int>(std::abs(departure.newest - clock) <= restart_limit_) -
         static_cast<int>(std::abs(*newest_ - clock) <= restart_limit_);
}

RunGuard::Verdict RunGuard::go(Stream& stream) {
  const Departure departure = *stream.departure;
  const bool back = departure.newest < *newest_;
  step_ = departure.step;
  begun_ = departure.first;
  newest_ = departure.newest;
  if (back)
    for (Stream& each : streams_) each.newest.reset();
  stream.departure.reset();
  stream.rival = {0.0, 0, 0};
  stream.newest = newest_;
  stream.standing = Standing::kInLine;
  return back ? Verdict::kNewRun : Verdict::kResume;
}

}  // namespace tws
