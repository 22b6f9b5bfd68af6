#include "operator/operator_handler.h"

#include <algorithm>

#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

using Message = OperatorHandler::Message;

/// Executes the request, unless there is a reason not to; the message then says what came of it.
OperatorAnswer executeOne(Adit& adit, Message& message, const std::string& refusal, const Site& site) {
  OperatorAnswer answer;
  answer.refusal = refusal;
  if (refusal.empty()) answer = execute(adit, requestOf(message, site));
  setEffect(message, adit, answer);
  return answer;
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

void OperatorHandler::beginNewRun() {
  ++run_;
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

void OperatorHandler::addRecorded(const Message& message) {
  if (message.result != Message::BUSY) recorded_.push_back(message);
}

/// The file that was loaded when this was recorded may have been given once more.
bool OperatorHandler::isDoneAtStart(const Message& message) const {
  return std::any_of(at_start_.begin(), at_start_.end(),
                     [&](const Message& done) { return done.clutter == message.clutter; });
}

void OperatorHandler::beforeSector(Adit& adit) {
  if (adit.counts().sectors > 0) return;
  const auto at_start = [&](const Message& m) { return m.radar.empty() && m.run == run_; };
  for (auto found = recorded_.begin();
       (found = std::find_if(recorded_.begin(), recorded_.end(), at_start)) != recorded_.end();
       recorded_.erase(found)) {
    if (isDoneAtStart(*found)) continue;
    at_start_.push_back(*found);
    executeOne(adit, at_start_.back(), "", Site{});
  }
}

/// Has the sector been processed after which the recorded request took effect?
bool OperatorHandler::isDue(const Adit& adit, const Message& m) const {
  if (m.run != run_) return false;
  if (m.radar.empty()) return true;  // it should have been here before the first sector
  const auto& radars = adit.params().radars;
  for (std::size_t i = 0; i < radars.size(); ++i) {
    if (radars[i].name != m.radar) continue;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(adit.order().front(i)) - m.running_sector) > 0;
  }
  return false;
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
  const auto due = [&](const Message& m) { return isDue(adit, m); };
  for (auto found = recorded_.begin();
       (found = std::find_if(recorded_.begin(), recorded_.end(), due)) != recorded_.end();) {
    const Message recorded = std::move(*found);
    recorded_.erase(found);
    said.push_back(repeat(adit, recorded, site));
  }
  return said;
}

Message OperatorHandler::repeat(Adit& adit, const Message& recorded, const Site& site) {
  Message message = recorded;
  message.header.seq = 0;
  // A file that could not be loaded is not here to be tried again.
  const bool refused = recorded.request == Message::LOAD_CLUTTER && recorded.result == Message::REFUSED;
  executeOne(adit, message, refused ? recorded.message : "", site);
  if (message.radar != recorded.radar || message.running_sector != recorded.running_sector)
    count_("late recorded requests", "request " + std::to_string(message.request) + " came too late");
  else if (!sameEffect(message, recorded))
    count_("requests repeated with another effect", "request " + std::to_string(message.request));
  return message;
}

}  // namespace adit_tracker
