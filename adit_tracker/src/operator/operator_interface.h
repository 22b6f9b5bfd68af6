#pragma once

#include <geometry_msgs/PointStamped.h>
#include <tws_msgs/DropTrack.h>
#include <tws_msgs/InitiateTrack.h>
#include <tws_msgs/OperatorCommand.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/bus.h>

#include <functional>
#include <string>
#include <vector>

#include "io/track_messages.h"
#include "operator/operator_handler.h"

namespace adit_tracker {

/// Where operators reach the tracker: services and points by hand. Each request and its effect go out as a message;
/// recorded ones that come in are repeated (see OperatorHandler).
class OperatorInterface {
 public:
  using Message = OperatorHandler::Message;
  struct Host {
    /// The tracker, caught up with the radars; else null, and why. It may process sectors meanwhile.
    std::function<Adit*(std::string& why)> catch_up;
    /// Where its radars stand; valid when it is caught up.
    std::function<const Site&()> site;
  };

  /// Points on `point_topic` (empty: none) start tracks. `frame` is that of positions.
  OperatorInterface(tws_runtime::Bus& bus, const std::string& frame, const std::string& point_topic, Host host);

  /// To be called before a sector may be processed.
  void beforeSector(Adit& adit) { handler_.beforeSector(adit); }
  /// To be called after each sector.
  void afterSector(Adit& adit) { publish(handler_.afterSector(adit, host_.site())); }
  /// Time has gone back.
  void beginNewRun() { handler_.beginNewRun(); }

  /// A request that asks for nothing yet.
  Message blank(std::uint8_t request) const { return log_.blank(request); }
  /// Executes a request if the tracker has time for it. `refusal`: why it cannot be executed at all.
  OperatorOutcome ask(const Message& message, const std::string& refusal = "");
  /// The same before the first sector of this run.
  void askAtStart(const Message& message) { log_.add(message); }

 private:
  bool onCommand(const tws_msgs::OperatorCommand::Request& request, tws_msgs::OperatorCommand::Response& response);
  bool onInitiate(const tws_msgs::InitiateTrack::Request& request, tws_msgs::InitiateTrack::Response& response);
  bool onDrop(const tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response);
  void onPoint(const geometry_msgs::PointStamped& point);
  Message pointRequest(const geometry_msgs::PointStamped& point, std::string& why) const;
  void serve();
  void publish(const std::vector<Message>& messages);

  tws_runtime::Bus& bus_;
  std::string frame_;
  Host host_;
  tws_runtime::RequestLog log_;
  OperatorHandler handler_;
};

}  // namespace adit_tracker
