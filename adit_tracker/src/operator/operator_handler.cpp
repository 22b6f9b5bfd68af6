#include "operator/operator_handler.h"

#include <algorithm>

#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

using Message = OperatorHandler::Message;

tws_runtime::RequestLog::Moment momentOf(const Adit& adit) {
  const SectorReport& latest = adit.tracks().latest();
  return {adit.params().radars[latest.radar].name, latest.running, latest.enter_time};
}

bool hasPassed(const Adit& adit, const std::string& radar, std::uint32_t running_sector) {
  const auto& radars = adit.params().radars;
  for (std::size_t i = 0; i < radars.size(); ++i) {
    if (radars[i].name != radar) continue;
    return tws_runtime::hasReached(static_cast<std::uint32_t>(adit.order().front(i)), running_sector + 1);
  }
  return false;
}

std::vector<tws_msgs::Track> tracksOf(const Adit& adit, const OperatorAnswer& answer, const Site& site) {
  std::vector<tws_msgs::Track> tracks;
  for (const auto slot : answer.tracks) {
    const TrackEvent event = adit.tracks().at(slot).coasting ? TrackEvent::kCoasted : TrackEvent::kUpdated;
    tracks.push_back(trackMessage(adit, {slot, event, adit.tracks().latest().enter_time}, site));
  }
  return tracks;
}

}  // namespace

/// Executes the request, unless there is a reason not to; the message then says what came of it.
OperatorAnswer OperatorHandler::executeOne(Adit& adit, Message& message, const std::string& refusal,
                                           const Site& site) const {
  OperatorAnswer answer;
  answer.refusal = refusal;
  if (refusal.empty()) answer = adit_tracker::execute(adit, requestOf(message, originOf(adit, site)));
  log_.stamp(message, momentOf(adit));
  setEffect(message, adit, answer);
  return answer;
}

void OperatorHandler::beginNewRun() {
  log_.beginNewRun();
  at_start_.clear();
}

OperatorHandler::Ticket OperatorHandler::add(Message message, std::string refusal) {
  waiting_.push_back({next_ticket_, std::move(message), std::move(refusal)});
  return next_ticket_++;
}

std::vector<Message> OperatorHandler::execute(Adit& adit, const Site& site) {
  std::vector<Message> said;
  for (; !waiting_.empty(); waiting_.pop_front()) {
    Waiting& next = waiting_.front();
    const OperatorAnswer answer = executeOne(adit, next.message, next.refusal, site);
    said.push_back(next.message);
    outcomes_[next.ticket] = {std::move(next.message), answer.next, tracksOf(adit, answer, site)};
  }
  return said;
}

std::vector<Message> OperatorHandler::refuse(const std::string& why, ros::Time now) {
  std::vector<Message> said;
  for (; !waiting_.empty(); waiting_.pop_front()) {
    Message& message = waiting_.front().message;
    message.header.stamp = now;
    message.result = Message::BUSY;
    message.message = why;
    said.push_back(message);
    outcomes_[waiting_.front().ticket].message = std::move(message);
  }
  return said;
}

std::optional<OperatorOutcome> OperatorHandler::take(Ticket ticket) {
  const auto found = outcomes_.find(ticket);
  if (found == outcomes_.end()) return std::nullopt;
  std::optional<OperatorOutcome> outcome(std::move(found->second));
  outcomes_.erase(found);
  return outcome;
}

/// The file that was loaded when this was recorded may have been given once more.
bool OperatorHandler::isDoneAtStart(const Message& message) const {
  return std::any_of(at_start_.begin(), at_start_.end(), [&](const Message& done) {
    return done.clutter == message.clutter && done.radar_counts == message.radar_counts;
  });
}

void OperatorHandler::beforeSector(Adit& adit) {
  if (adit.counts().sectors > 0) return;
  while (const auto recorded = log_.takeAtStart()) {
    if (isDoneAtStart(*recorded)) continue;
    at_start_.push_back(*recorded);
    executeOne(adit, at_start_.back(), "", Site{});
  }
}

std::vector<Message> OperatorHandler::afterSector(Adit& adit, const Site& site) {
  std::vector<Message> said;
  for (Message& message : at_start_) {
    message.header.seq = 0;
    message.header.stamp = tws_runtime::toTime(adit.tracks().latest().enter_time);
    message.radar.clear();
    message.running_sector = 0;
    said.push_back(message);
  }
  at_start_.clear();
  const auto has_passed = [&](const std::string& radar, std::uint32_t running) {
    return hasPassed(adit, radar, running);
  };
  while (const auto recorded = log_.takeDue(has_passed)) said.push_back(repeat(adit, *recorded, site));
  return said;
}

Message OperatorHandler::repeat(Adit& adit, const Message& recorded, const Site& site) {
  Message message = recorded;
  // A file that could not be loaded is not here to be tried again.
  const bool refused = recorded.request == Message::LOAD_CLUTTER && recorded.result == Message::REFUSED;
  executeOne(adit, message, refused ? recorded.message : "", site);
  log_.compare(recorded, message);
  return message;
}

}  // namespace adit_tracker
