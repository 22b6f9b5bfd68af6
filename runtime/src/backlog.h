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
/// The same after a network has failed: each connection repeats by a clock of its own what was lost, and the topics
/// come back seconds one after the other. What comes is kept when a topic comes back that was silent for two seconds,
/// and for three times its usual pause, until all that were silent with it are where the newest one is.
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
  /// What is to be handed over next, once all has come. After a standstill: when nothing has come for 0.3 s that is
  /// older than its topic usually is, or after ten seconds. After a silence: after 0.3 s when no topic is still behind,
  /// or after five seconds.
  std::optional<Give> take(double wall);

  std::size_t size() const { return kept_.size(); }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  struct Topic {
    int heard = 0;             // messages
    double wall = 0.0;         // of the latest message [s]
    double stamp = 0.0;        // of the latest message [s]
    double usual_lag = 0.0;    // behind the newest stamp of all topics [s]
    double usual_step = 0.0;   // from stamp to stamp [s]
    double usual_pause = 0.0;  // from message to message [s of wall time]
    bool awaited = false;      // it was silent when the first one came back
  };

  bool isSilent(const Topic& topic, double wall) const;
  bool isBehind(const Topic& topic) const;
  void openAfterSilence(double wall);
  void learn(Topic& topic, double stamp, double wall);
  bool hasCome(double wall) const;

  std::optional<double> beat_;  // the latest
  bool open_ = false;           // what comes is kept
  bool after_silence_ = false;  // and not after a standstill
  double opened_ = 0.0;         // then
  double old_ = 0.0;            // then something old came last
  bool complete_ = false;       // all has come
  double newest_ = kNever;      // stamp of all topics [s]
  std::vector<Topic> topics_;
  std::multimap<double, Give> kept_;
};

}  // namespace tws_runtime
