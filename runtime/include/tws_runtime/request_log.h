#pragma once

#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/bus.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

namespace tws_runtime {

/// What operators ask of a tracker, recorded as it takes effect, so that a replay repeats it.
///
/// A request takes effect between two sectors and is then published on ~operator_requests with the run, the radar and
/// the running sector after which that was, and that sector's data time. A replay hands all of them over ahead, on
/// ~recorded_requests; the tracker takes each one out after the very sector after which it took effect.
class RequestLog {
 public:
  using Request = tws_msgs::OperatorRequest;

  /// The sector that was processed last.
  struct Moment {
    std::string radar;
    std::int64_t running_sector;
    double time;  ///< [s]
  };
  /// Has the tracker processed this sector of this radar?
  using HasPassed = std::function<bool(const std::string& radar, std::uint32_t running_sector)>;

  /// `frame`: of positions.
  RequestLog(Bus& bus, std::string frame);

  /// A request that asks for nothing yet.
  Request blank(std::uint8_t request) const;
  /// The request has taken effect (or was refused) here: writes that into it.
  void stamp(Request& request, const Moment& moment) const;
  void publish(const Request& request) { out_.publish(request); }

  /// The next recorded request of this run that took effect after a sector that has passed; nothing: none is due.
  std::optional<Request> takeDue(const HasPassed& has_passed);
  /// The next one of this run that took effect before the first sector: no radar is named.
  std::optional<Request> takeAtStart();
  /// Hands one over as if it had been recorded.
  void add(const Request& request);
  /// A recorded request was carried out again, and is now as `repeated`: counts when it came too late, or had another
  /// effect.
  void compare(const Request& recorded, const Request& repeated);

  /// Time has gone back.
  void beginNewRun() { ++run_; }
  std::uint32_t run() const { return run_; }

 private:
  std::optional<Request> take(const std::function<bool(const Request&)>& is_due);

  Bus& bus_;
  std::string frame_;
  Publisher<Request> out_;
  std::uint32_t run_ = 0;
  std::deque<Request> recorded_;  // still to be repeated, in the order in which they came
};

/// Whether running number `a` is not before `b`, over the wrap at 2^32.
inline bool hasReached(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) >= 0; }

}  // namespace tws_runtime
