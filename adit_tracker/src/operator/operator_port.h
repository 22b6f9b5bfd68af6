#pragma once

#include <geometry_msgs/PointStamped.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/InitiateTrack.h>
#include <tws_msgs/OperatorCommand.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/bus.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "io/track_messages.h"
#include "operator/operator_desk.h"

namespace adit_tracker {

/// Where operators reach the tracker: services and points by hand. Each request and its effect go out as a message;
/// recorded ones that come in are repeated after the very sector after which they took effect.
class OperatorPort {
 public:
  struct Host {
    /// The tracker, when it is caught up with the radars; else null, and why.
    std::function<Adit*(std::string& why)> caught_up;
    /// Where its radars stand; valid when it is caught up.
    std::function<const Site&()> site;
  };

  /// Points on `point_topic` (empty: none) start tracks. `frame` is that of positions.
  OperatorPort(tws_runtime::Bus& bus, const std::string& frame, const std::string& point_topic, Host host);

  /// To be called before a sector may be processed: repeats what was recorded before the run's first one.
  void beforeSector(Adit& adit);
  /// To be called after each sector: repeats what was recorded there.
  void afterSector(Adit& adit);
  /// Time has gone back.
  void beginNewRun() {
    ++run_;
    at_start_.clear();
  }

  using Message = tws_msgs::OperatorRequest;
  /// A request that asks for nothing yet.
  Message blank(std::uint8_t request) const;
  /// Carries a request out if the tracker has time for it; the message then says what came of it, to all. `refusal`:
  /// why it cannot be carried out at all.
  void order(Message& message, const std::string& refusal = "");
  /// The same before the first sector of this run.
  void orderAtStart(const Message& message) { recorded_.push_back(message); }

 private:
  bool command(const tws_msgs::OperatorCommand::Request& request, tws_msgs::OperatorCommand::Response& response);
  bool initiate(const tws_msgs::InitiateTrack::Request& request, tws_msgs::InitiateTrack::Response& response);
  bool drop(const tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response);
  void hearPoint(const geometry_msgs::PointStamped& point);
  Message pointRequest(const geometry_msgs::PointStamped& point, std::string& why) const;

  Adit* readyFor(Message& message);
  OperatorAnswer carryOutAndTell(Adit& adit, Message& message);
  void tellRefusal(const Adit& adit, Message& message, const std::string& refusal);
  void hearRecorded(const Message& message);
  void repeat(Adit& adit, const Message& recorded);

  tws_runtime::Bus& bus_;
  std::string frame_;
  Host host_;
  tws_runtime::Publisher<Message> told_;
  std::uint32_t run_ = 0;
  std::deque<Message> recorded_;   // still to be repeated, in the order in which they came
  std::vector<Message> at_start_;  // took effect before the first sector: told after it, when there is a time
};

}  // namespace adit_tracker
