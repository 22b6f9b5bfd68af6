#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace tws {

/// Tells the messages of one run from stray stamps and from those of a run that begins anew, for several streams of
/// several sources (a radar's detections and sector marks are two streams of one source).
///
/// Taken is what goes on where its stream was, however far the stream lags behind the others (a backlog is no new run),
/// and what lies within the restart limit of the run's newest stamp. All else is held back. When at least three such
/// messages of a stream in a row, over a second or more, agree with each other, sources vote whether the run goes
/// there: a new run when time went back, a pause when it went ahead. Against it is who was there when it began and has
/// not gone there, too; a clock, where one is known, has one vote. One source alone has its way only when it is the
/// only one, or when the others have said nothing for as long as a minute. A stream that is outvoted is set aside until
/// its stamps agree with the run again.
class RunGuard {
 public:
  enum class Verdict {
    kTake,    ///< In line. What was held back of this stream before is stray.
    kHold,    ///< Out of line, so far.
    kNewRun,  ///< Time has gone back: this message and those held back that agree with it are a new run.
    kResume   ///< Time has gone ahead: this message and those held back that agree with it go on behind a pause.
  };
  enum class Standing {
    kInLine,
    kLagging,   ///< Goes on where it was, more than the restart limit behind the others: a backlog.
    kRivalled,  ///< Messages of another time come between its own, again and again: two publishers on one topic.
    kSetAside   ///< Its clock contradicts the other sources'.
  };

  /// Each of the streams is a source of its own. `restart_limit` [s], > 0: a smaller step back is late data of the same
  /// run. `skew_limit` [s], > 0: a source that was abreast of the others and steps this far from them is set aside,
  /// too; infinity: only the restart limit counts.
  RunGuard(std::size_t streams, double restart_limit, double skew_limit = std::numeric_limits<double>::infinity());

  /// One more stream; its index. `source`: of another stream with which it shares a clock.
  std::size_t addStream(std::optional<std::size_t> source = {});
  std::size_t sourceOf(std::size_t stream) const { return streams_.at(stream).source; }

  /// `time` and what the clock says now, if it is known [s].
  Verdict judge(std::size_t stream, double time, std::optional<double> clock = {});
  /// After kNewRun or kResume: does a stamp [s] that was held back belong to what has begun?
  bool agrees(double time) const;
  /// As of the stream's latest message.
  Standing standing(std::size_t stream) const { return streams_.at(stream).standing; }
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
  /// Messages that agree with each other and come between those in line.
  struct Rival {
    double newest;  // [s]
    int messages, changes;
  };
  struct Stream {
    std::size_t source;
    std::optional<double> newest = {};  // in line [s]
    std::optional<Departure> departure = {};
    Rival rival = {0.0, 0, 0};
    Standing standing = Standing::kInLine;
  };

  bool isInLine(const Stream& stream, double time) const;
  bool isInRun(double time) const;
  bool stepsAside(const Stream& stream, double time) const;
  std::optional<double> newestOfOthers(const Stream& stream) const;
  void take(Stream& stream, double time);
  void depart(Stream& stream, double time) const;
  void compareWithRival(Stream& stream, double time) const;
  void setAsideWhenOutvoted(Stream& stream) const;
  bool isConfirmed(const Stream& stream, std::optional<double> clock) const;
  int voteOf(const Stream& stream, const Departure& departure) const;
  int voteOf(double clock, const Departure& departure) const;
  Verdict go(Stream& stream);

  std::vector<Stream> streams_;
  std::size_t sources_;
  double restart_limit_, skew_limit_;
  double step_ = 0.0;   // the longest between the messages that the run went to [s]
  double begun_ = 0.0;  // where the run, or what follows its latest pause, began [s]
  std::optional<double> newest_;
};

}  // namespace tws
