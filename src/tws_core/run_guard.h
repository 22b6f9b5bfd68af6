#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tws {

/// Tells the messages of one run from mad stamps and from those of a run that begins anew, for several streams.
///
/// A stamp that goes back, or far ahead, is held to be mad unless the next one of its stream agrees with it. When two
/// agree that time has gone back, a new run begins; what the other streams still bring of the old one is refused.
class RunGuard {
 public:
  enum class Verdict { kTake, kMad, kOldRun, kNewRun };

  /// `restart_limit` [s], > 0: a smaller step back is late data of the same run.
  RunGuard(std::size_t streams, double restart_limit) : streams_(streams), restart_limit_(restart_limit) {}

  /// `time` [s]. After kNewRun the message is the first one of the new run; kMad and kOldRun: leave it out.
  Verdict judge(std::size_t stream, double time);

 private:
  struct Stream {
    std::optional<double> stray;  // the last stamp that did not fit
    bool old_run = false;         // has not gone back yet
  };

  std::vector<Stream> streams_;
  double restart_limit_;
  std::optional<double> newest_;
};

}  // namespace tws
