#pragma once

#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/request_log.h>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/track_messages.h"
#include "operator/operator_requests.h"

namespace adit_tracker {

/// What came of a request.
struct OperatorOutcome {
  tws_msgs::OperatorRequest message;         // the request, its result and when it took effect
  std::uint32_t next = 0;                    // least number of the next page; 0: there is none
  std::vector<tws_msgs::Track> tracks = {};  // those that it names, as they were then
};

/// Decides when operators' requests are executed: one after the other, in the order in which they came, between two
/// sectors. New ones wait in a queue until the tracker has time for them, so that sectors may be processed in between;
/// recorded ones wait for the very sector after which they took effect.
class OperatorHandler {
 public:
  using Message = tws_msgs::OperatorRequest;
  using Ticket = std::uint64_t;

  /// `log` keeps the recorded requests, and is to outlive it.
  explicit OperatorHandler(tws_runtime::RequestLog& log) : log_(log) {}

  /// Time has gone back.
  void beginNewRun();

  /// A new request; `refusal`: why it cannot be executed at all.
  Ticket add(Message message, std::string refusal = "");
  /// Executes all new requests. Returns the messages that say what came of them.
  std::vector<Message> execute(Adit& adit, const Site& site);
  /// The tracker has no time for them; `why` is the answer to all.
  std::vector<Message> refuse(const std::string& why, ros::Time now);
  /// What came of a new request; it is forgotten then. Nothing: it waits still.
  std::optional<OperatorOutcome> take(Ticket ticket);

  /// To be called before a sector may be processed: executes what was recorded before the run's first one.
  void beforeSector(Adit& adit);
  /// To be called after each sector: executes what was recorded there. Returns what came of all recorded ones.
  std::vector<Message> afterSector(Adit& adit, const Site& site);

 private:
  struct Waiting {
    Ticket ticket;
    Message message;
    std::string refusal;
  };
  bool isDoneAtStart(const Message& message) const;
  Message repeat(Adit& adit, const Message& recorded, const Site& site);

  OperatorAnswer executeOne(Adit& adit, Message& message, const std::string& refusal, const Site& site) const;

  tws_runtime::RequestLog& log_;
  Ticket next_ticket_ = 1;
  std::deque<Waiting> waiting_;
  std::map<Ticket, OperatorOutcome> outcomes_;
  std::vector<Message> at_start_;  // executed before the first sector, not said yet
};

}  // namespace adit_tracker
