#include <tws_runtime/request_log.h>

#include <tws_runtime/conversions.h>

#include <algorithm>
#include <limits>

namespace tws_runtime {
namespace {

// A run with more than one request a second for a day.
constexpr std::size_t kMostRecorded = 100000;

}  // namespace

RequestLog::RequestLog(Bus& bus, std::string frame)
    : bus_(bus), frame_(std::move(frame)), out_(bus.advertise<Request>("~operator_requests")) {
  bus.subscribe<Request>("~recorded_requests", [this](const Request& request) {
    if (request.result != Request::BUSY) add(request);
  });
}

RequestLog::Request RequestLog::blank(std::uint8_t request) const {
  Request message;
  message.header.frame_id = frame_;
  message.tracker = bus_.name();
  message.request = request;
  message.run = run_;
  message.lower = message.upper = std::numeric_limits<double>::quiet_NaN();
  return message;
}

void RequestLog::stamp(Request& request, const Moment& moment) const {
  request.header.seq = 0;
  request.header.stamp = toTime(moment.time);
  request.run = run_;
  request.radar = moment.radar;
  request.running_sector = static_cast<std::uint32_t>(moment.running_sector);
}

std::optional<RequestLog::Request> RequestLog::takeDue(const HasPassed& has_passed) {
  // Without a radar: it should have been here before the first sector.
  return take([&](const Request& r) { return r.radar.empty() || has_passed(r.radar, r.running_sector); });
}

std::optional<RequestLog::Request> RequestLog::takeAtStart() {
  return take([](const Request& r) { return r.radar.empty(); });
}

std::optional<RequestLog::Request> RequestLog::take(const std::function<bool(const Request&)>& is_due) {
  const auto is_it = [&](const Request& request) { return request.run == run_ && is_due(request); };
  const auto found = std::find_if(recorded_.begin(), recorded_.end(), is_it);
  if (found == recorded_.end()) return std::nullopt;
  Request request = std::move(*found);
  recorded_.erase(found);
  return request;
}

void RequestLog::add(const Request& request) {
  if (recorded_.size() < kMostRecorded) return recorded_.push_back(request);
  bus_.counter("recorded requests left out").add("more than " + std::to_string(kMostRecorded) + " wait to be repeated");
}

void RequestLog::compare(const Request& recorded, const Request& repeated) {
  const std::string which = "request " + std::to_string(recorded.request) + " of sector " +
                            std::to_string(recorded.running_sector) + " of " + recorded.radar;
  if (repeated.radar != recorded.radar || repeated.running_sector != recorded.running_sector)
    bus_.counter("late recorded requests").add(which + " came after that sector");
  else if (repeated.result != recorded.result || repeated.count != recorded.count || repeated.tracks != recorded.tracks)
    bus_.counter("requests repeated with another effect").add(which);
}

}  // namespace tws_runtime
