#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace tws_runtime {

/// What comes in after a node has stood still (it was stopped, or got no processor). Each topic has a socket of its
/// own, and what has gathered there comes topic by topic: seconds or minutes of detections, and then the marks of the
/// same time, which are late by all limits. So all is kept until it has come, and handed over in order of its stamps.
///
/// Wall times are in seconds of a clock that does not step.
class Backlog {
 public:
  using Give = std::function<void()>;

  /// One more topic; its index.
  std::size_t addTopic();
  /// The node is alive. When it was not for more than half a second, for how long that was: what comes from now on is
  /// kept.
  std::optional<double> beat(double wall);
  /// A message of that stamp [s] has come. True: `give` is kept, and is to be handed over later.
  bool keep(std::size_t topic, double stamp, double wall, Give give);
  /// What is to be handed over next, once all has come: when nothing has come for 0.3 s that is older
  /// than its topic usually is, or after ten seconds.
  std::optional<Give> take(double wall);

  std::size_t size() const { return kept_.size(); }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  std::optional<double> beat_;     // the latest
  bool open_ = false;              // what comes is kept
  double opened_ = 0.0;            // then
  double old_ = 0.0;               // then something old came last
  bool complete_ = false;          // all has come
  double newest_ = kNever;         // stamp of all topics [s]
  std::vector<double> usual_lag_;  // of each topic behind the newest stamp [s]
  std::multimap<double, Give> kept_;
};

}  // namespace tws_runtime
