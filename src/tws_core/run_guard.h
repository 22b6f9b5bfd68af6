#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tws {

/// Tells the messages of one run from stray stamps and from those of a run that begins anew, for several streams.
///
/// A stamp in line lies within the restart limit of the newest one. One out of line is held back. When at least three
/// of a stream in a row, over a second or more, agree with each other, and more streams agree with them than have gone
/// on with the old run meanwhile, the run goes there: a new run when time went back, a pause when it went ahead. So no
/// single message, and no single source of several, ends a run.
class RunGuard {
 public:
  enum class Verdict {
    kTake,    ///< In line. What was held back of this stream before is stray.
    kHold,    ///< Out of line, so far.
    kNewRun,  ///< Time has gone back: this message and those held back that agree with it are a new run.
    kResume   ///< Time has gone ahead: this message and those held back that agree with it go on behind a pause.
  };

  /// `restart_limit` [s], > 0: a smaller step back is late data of the same run.
  RunGuard(std::size_t streams, double restart_limit) : streams_(streams), restart_limit_(restart_limit) {}

  /// One more stream; its index.
  std::size_t addStream();
  /// `time` [s].
  Verdict judge(std::size_t stream, double time);
  /// After kNewRun or kResume: does a stamp [s] that was held back belong to what has begun?
  bool agrees(double time) const;
  /// The newest time of the run [s]; nothing before the first message.
  const std::optional<double>& newest() const { return newest_; }

 private:
  /// Messages of a stream in a row that are out of line and agree with each other.
  struct Departure {
    double first, newest;  // stamps [s]
    double old_newest;     // where the old run was when it began [s]
    double step;           // the longest from one to the next [s]
    int messages;
  };
  struct Stream {
    std::optional<double> newest;  // in line [s]
    std::optional<Departure> departure;
  };

  bool isInLine(double time) const;
  void depart(Stream& stream, double time) const;
  bool isConfirmed(const Departure& departure) const;

  std::vector<Stream> streams_;
  double restart_limit_;
  double step_ = 0.0;   // the longest between the messages that the run went to [s]
  double begun_ = 0.0;  // where the run, or what follows its latest pause, began [s]
  std::optional<double> newest_;
};

}  // namespace tws
