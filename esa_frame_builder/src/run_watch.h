#pragma once

#include <optional>

namespace esa_frame_builder {

/// Tells late data from a run that begins anew.
class RunWatch {
 public:
  enum class Verdict { kTake, kLate, kNewRun };

  /// `restart_limit` [s], > 0: a smaller step back is late data of the same run.
  explicit RunWatch(double restart_limit) : restart_limit_(restart_limit) {}

  /// `time` [s].
  Verdict judge(double time) {
    const bool back = newest_ && time < *newest_;
    if (back && time >= *newest_ - restart_limit_) return Verdict::kLate;
    newest_ = time;
    return back ? Verdict::kNewRun : Verdict::kTake;
  }

 private:
  double restart_limit_;
  std::optional<double> newest_;
};

}  // namespace esa_frame_builder
