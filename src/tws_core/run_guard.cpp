#include <tws_core/run_guard.h>

#include <algorithm>
#include <cmath>

namespace tws {
namespace {

// A feed may pause; a stamp further ahead must be confirmed by the next one.
constexpr double kLongestLeap = 60.0;  // [s]

}  // namespace

RunGuard::Verdict RunGuard::judge(std::size_t stream, double time) {
  Stream& own = streams_.at(stream);
  const bool back = newest_ && time < *newest_ - restart_limit_;
  const bool ahead = newest_ && time > *newest_ + kLongestLeap;
  if (!back && !ahead) {
    newest_ = std::max(time, newest_.value_or(time));
    own = Stream{};
    return Verdict::kTake;
  }
  if (ahead && own.old_run) return Verdict::kOldRun;
  const bool confirmed = own.stray && std::abs(time - *own.stray) <= restart_limit_;
  own.stray = time;
  if (!confirmed) return Verdict::kMad;
  newest_ = time;
  if (back) streams_.assign(streams_.size(), Stream{std::nullopt, true});
  own = Stream{};
  return back ? Verdict::kNewRun : Verdict::kTake;
}

}  // namespace tws
