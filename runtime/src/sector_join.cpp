#include "sector_join.h"

#include <tws_core/sectors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace tws_runtime {
namespace {

constexpr std::size_t kMostStrays = 8;
// A run goes on behind a gap when so many messages agree: one more than the two of a sector that was damaged.
constexpr std::size_t kFewestAgreeing = 3;
constexpr double kDoNotWait = -std::numeric_limits<double>::infinity();
constexpr std::int64_t kMemory = std::int64_t{8} * tws::kSectors;  // Sectors behind for which losses are remembered.

std::string seconds(double time) {
  std::ostringstream text;
  text.precision(15);
  text << time << " s";
  return text.str();
}

void remember(std::set<std::int64_t>& lost, std::int64_t number) {
  lost.insert(number);
  lost.erase(lost.begin(), lost.lower_bound(number - kMemory));
}

/// The smallest number from `least` on that leaves the same remainder as `number` modulo a turn.
std::int64_t sameSectorFrom(std::int64_t least, std::int64_t number) {
  const std::int64_t turn = tws::kSectors;
  return least + ((number - least) % turn + turn) % turn;
}

}  // namespace

SectorJoin::SectorJoin(Options options, Events events) : options_(options), events_(std::move(events)) {}

void SectorJoin::reset() {
  pace_.clear();
  strays_.clear();
  started_ = false;
  detections_.clear();
  marks_.clear();
  lost_detections_.clear();
  lost_marks_.clear();
}

void SectorJoin::beginNewRun() {
  reset();
  number_offset_ = 0;
  last_number_ = std::numeric_limits<std::int64_t>::min();
}

void SectorJoin::addMessage(Message message) {
  const Crossing crossing = crossingOf(message);
  if (!pace_.fits(crossing)) return holdBack(std::move(message));
  const auto is_of_its_kind = [&](const Message& stray) { return stray.index() == message.index(); };
  if (!strays_.empty()) strays_.erase(std::remove_if(strays_.begin(), strays_.end(), is_of_its_kind), strays_.end());
  if (!pace_.newest()) first_time_ = crossing.time;
  if (std::holds_alternative<SectorDetections>(message))
    store(crossing.running - 1, std::get<SectorDetections>(std::move(message)));
  else
    store(crossing.running, std::get<SectorCrossing>(message));
  pace_.add(crossing);
  release();
}

Crossing SectorJoin::crossingOf(const Message& message) const {
  if (const auto* detections = std::get_if<SectorDetections>(&message))
    return {pace_.unwrapped(detections->running + 1), detections->leave_time};
  const auto& mark = std::get<SectorCrossing>(message);
  return {pace_.unwrapped(mark.running), mark.time};
}

void SectorJoin::holdBack(Message message) {
  const Crossing crossing = crossingOf(message);
  events_.fault("stray messages", "running sector " + std::to_string(crossing.running) + " at " +
                                      seconds(crossing.time) +
                                      " does not fit the run: held back until others agree with it");
  std::deque<Message> agreeing = agreeingWith(message);
  strays_.push_back(message);
  if (strays_.size() > kMostStrays) strays_.pop_front();
  if (agreeing.size() + 1 < kFewestAgreeing) return;
  agreeing.push_back(std::move(message));
  continueWith(agreeing);
}

std::deque<SectorJoin::Message> SectorJoin::agreeingWith(const Message& message) const {
  std::deque<Message> agreeing;
  for (const Message& stray : strays_)
    if (agree(stray, message)) agreeing.push_back(stray);
  return agreeing;
}

/// Two different messages that fit into one run.
bool SectorJoin::agree(const Message& a, const Message& b) const {
  const Crossing first = crossingOf(a);
  const Crossing second = crossingOf(b);
  const bool same = a.index() == b.index() && first.running == second.running;
  SectorPace both;
  both.add(first);
  return !same && both.fits(second);
}

void SectorJoin::continueWith(const std::deque<Message>& messages) {
  events_.fault("gaps", "the sectors between " + seconds(pace_.newest()->time) + " and " +
                            seconds(crossingOf(messages.front()).time));
  while (started_ && releaseNext(kDoNotWait)) continue;
  reset();
  for (const Message& each : messages) addMessage(each);
}

void SectorJoin::store(std::int64_t sector, SectorDetections&& detections) {
  if (started_ && sector < next_) return refuse(lost_detections_, sector, "detections");
  if (!detections_.try_emplace(sector, std::move(detections)).second)
    events_.fault("duplicate messages", "detections of " + sectorText(sector));
}

void SectorJoin::store(std::int64_t entered, const SectorCrossing& mark) {
  if (started_ && entered <= next_) return refuse(lost_marks_, entered, "sector mark");
  if (!marks_.try_emplace(entered, mark).second)
    events_.fault("duplicate messages", "sector mark of " + sectorText(entered));
}

void SectorJoin::refuse(std::set<std::int64_t>& lost, std::int64_t number, const std::string& what) {
  const bool late = lost.erase(number) > 0 || number < first_;
  events_.fault(late ? "late messages" : "duplicate messages", what + " of " + sectorText(number));
}

/// The first release waits for one complete sector, or at most for the limit. Each stream by itself is taken to begin
/// in order.
bool SectorJoin::start() {
  if (!hasComplete() && pace_.newest()->time - first_time_ <= options_.limit) return false;
  first_ = next_ = earliestPending();
  enter_time_ = firstEnterTime();
  continueNumbers();
  marks_.erase(next_);
  return started_ = true;
}

bool SectorJoin::hasComplete() const {
  const auto complete = [&](const auto& entry) { return marks_.count(entry.first + 1) > 0; };
  return std::any_of(detections_.begin(), detections_.end(), complete);
}

std::int64_t SectorJoin::earliestPending() const {
  const std::int64_t none = std::numeric_limits<std::int64_t>::max();
  return std::min(detections_.empty() ? none : detections_.begin()->first,
                  marks_.empty() ? none : marks_.begin()->first);
}

/// The first sector's own mark, or else its end less a sector's share of the turn, as far as they are known.
double SectorJoin::firstEnterTime() const {
  const auto own = marks_.find(next_);
  if (own != marks_.end()) return own->second.time;
  const double leave_time = detections_.at(next_).leave_time;
  const auto closing = marks_.find(next_ + 1);
  const double period = closing == marks_.end() ? 0.0 : closing->second.rotation_period;
  return period > 0.0 ? leave_time - period / tws::kSectors : leave_time;
}

/// Behind a gap: a radar that has counted anew must not give a number twice.
void SectorJoin::continueNumbers() {
  if (next_ + number_offset_ <= last_number_) number_offset_ = sameSectorFrom(last_number_ + 1, next_) - next_;
}

void SectorJoin::release() {
  if (!started_ && !start()) return;
  while (releaseNext(options_.limit)) continue;
}

bool SectorJoin::releaseNext(double limit) {
  const auto detections = detections_.find(next_);
  const auto mark = marks_.find(next_ + 1);
  const bool has_detections = detections != detections_.end();
  const bool has_mark = mark != marks_.end();
  const std::optional<double> leave_time = leaveTime();
  if (!leave_time) return false;
  const bool complete = has_detections && has_mark;
  if (!complete && pace_.newest()->time - *leave_time <= limit) return false;
  reportLosses(has_detections, has_mark ? &mark->second : nullptr, *leave_time);
  emit(*leave_time, has_detections ? &detections->second : nullptr);
  if (has_detections) detections_.erase(detections);
  if (has_mark) marks_.erase(mark);
  return true;
}

/// When the beam left the next sector: its mark says it, else its detections, else the nearest later crossing gives
/// about when.
std::optional<double> SectorJoin::leaveTime() const {
  const auto mark = marks_.upper_bound(next_);
  const auto detections = detections_.lower_bound(next_);
  const std::int64_t none = std::numeric_limits<std::int64_t>::max();
  const std::int64_t marked = mark == marks_.end() ? none : mark->first;
  const std::int64_t detected = detections == detections_.end() ? none : detections->first + 1;
  if (marked == none && detected == none) return std::nullopt;
  const double time = marked <= detected ? mark->second.time : detections->second.leave_time;
  return enter_time_ + (time - enter_time_) / static_cast<double>(std::min(marked, detected) - next_);
}

void SectorJoin::reportLosses(bool has_detections, const SectorCrossing* mark, double leave_time) {
  const std::string where = sectorText(next_) + ", left at " + seconds(leave_time);
  const std::string count = mark ? "; its mark counts " + std::to_string(mark->closed_count) : "";
  if (!has_detections) {
    events_.fault("lost detections", where + count);
    remember(lost_detections_, next_);
  } else if (mark && mark->closed_count != detections_.at(next_).sent_count) {
    const std::string sent = std::to_string(detections_.at(next_).sent_count);
    events_.fault("count mismatches", where + ": " + sent + " detections came" + count);
  }
  if (mark) return;
  events_.fault("lost sector marks", "the one that closes " + where);
  remember(lost_marks_, next_ + 1);
}

void SectorJoin::emit(double leave_time, const SectorDetections* detections) {
  tws::RadarSector sector;
  sector.running = last_number_ = next_ + number_offset_;
  sector.sector = static_cast<int>(sameSectorFrom(0, next_));
  sector.enter_time = enter_time_;
  sector.leave_time = std::max(enter_time_, leave_time);
  if (detections) keepTimelyPlots(sector, detections->plots);
  enter_time_ = sector.leave_time;
  ++next_;
  events_.sector(std::move(sector));
}

void SectorJoin::keepTimelyPlots(tws::RadarSector& sector, const std::vector<tws::Plot>& plots) {
  const double from = sector.enter_time - options_.restart_limit;
  const double to = sector.leave_time + options_.restart_limit;
  for (const tws::Plot& plot : plots) {
    if (plot.time >= from && plot.time <= to)
      sector.plots.push_back(plot);
    else
      events_.fault("bad detections", "stamp " + seconds(plot.time) + " in " + sectorText(next_) + ", left at " +
                                          seconds(sector.leave_time));
  }
  const auto earlier = [](const tws::Plot& a, const tws::Plot& b) { return a.time < b.time; };
  std::stable_sort(sector.plots.begin(), sector.plots.end(), earlier);
}

std::string SectorJoin::sectorText(std::int64_t sector) const {
  return "sector " + std::to_string(sameSectorFrom(0, sector)) + " (running " + std::to_string(sector) + ")";
}

}  // namespace tws_runtime
