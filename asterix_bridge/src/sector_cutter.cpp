#include "sector_cutter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

constexpr std::size_t kMostWaiting = 100000;

std::string seconds(double time) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f s", time);
  return text;
}

}  // namespace

void SectorCutter::add(const TargetReport& report, double time) {
  if (!isPossible(time)) return;
  if (report.time_from != TimeFrom::kMark) beam_.add(time, report.azimuth);
  time = placed(report, time);
  if (running_ && time < enter_time_)
    events_.fault(
        "late reports",
        "one of " + seconds(time) + " came after its sector was closed, which was left before " + seconds(enter_time_));
  const auto later = [](double t, const TimedReport& other) { return t < other.time; };
  reports_.insert(std::upper_bound(reports_.begin(), reports_.end(), time, later), TimedReport{time, report});
  if (reports_.size() > kMostWaiting) reports_.erase(reports_.begin());
}

// A report without a time of its own has the time at which the beam was there: after the mark that lent it one, or
// before it was received.
double SectorCutter::placed(const TargetReport& report, double time) const {
  if (report.time_from == TimeFrom::kReport || !beam_.isKnown()) return time;
  const double beam = beam_.azimuthAt(time);
  double ahead = tws::angularDifference(report.azimuth, beam);
  if (report.time_from == TimeFrom::kMark && ahead < -tws::kPi / 2.0) ahead += tws::kTwoPi;
  if (report.time_from == TimeFrom::kReception && ahead > tws::kPi / 2.0) ahead -= tws::kTwoPi;
  return beam_.timeAt(beam + ahead);
}

void SectorCutter::placeAll() {
  for (TimedReport& timed : reports_) timed.time = placed(timed.report, timed.time);
  std::stable_sort(reports_.begin(), reports_.end(),
                   [](const TimedReport& a, const TimedReport& b) { return a.time < b.time; });
}

void SectorCutter::mark(double time, double azimuth) {
  if (!isPossible(time)) return;
  azimuth == 0.0 ? beam_.addNorth(time) : beam_.addMark(time, azimuth);
}

// A time far from the radar's others is wrong, unless those that follow agree with it.
bool SectorCutter::isPossible(double time) {
  constexpr double kFarAhead = 60.0, kAheadOfFeed = 5.0;
  constexpr int kEnough = 5;
  if (std::isnan(time)) return false;
  const bool back = newest_ && time < *newest_ - options_.restart;
  const bool ahead = feed_time_ ? time > *feed_time_ + kAheadOfFeed : newest_ && time > *newest_ + kFarAhead;
  impossible_ = back || ahead ? impossible_ + 1 : 0;
  if (impossible_ > 0 && impossible_ < kEnough) {
    events_.fault("reports at impossible times",
                  seconds(time) + ", the feed is at " + seconds(feed_time_.value_or(newest_.value_or(time))));
    return false;
  }
  if (back) {
    events_.fault("new runs", "time went back from " + seconds(*newest_) + " to " + seconds(time));
    finish();
    beginAnew();
  } else if (newest_ && time > *newest_ + silence()) {
    events_.fault("silences", "nothing from " + seconds(*newest_) + " to " + seconds(time));
    finish();
    beam_.interrupt();
    running_.reset();
    reports_.clear();
    earliest_.reset();
  }
  impossible_ = 0;
  newest_ = std::max(newest_.value_or(time), time);
  earliest_ = std::min(earliest_.value_or(time), time);
  return true;
}

void SectorCutter::beginAnew() {
  beam_ = Beam();
  next_ = 0;
  reports_.clear();
  running_.reset();
  newest_.reset();
  earliest_.reset();
}

void SectorCutter::advance(double feed_time) {
  if (options_.steady) feed_time_ = feed_time;
  if (!newest_) return;
  followBreak();
  const double fixed = running_ ? enter_time_ : -std::numeric_limits<double>::infinity();
  if (!beam_.learn(*newest_, fixed)) return sayThatUnknown();
  said_unknown_ = false;
  // Of a radar that has sent nothing for a turn, not even a mark, nobody knows that its beam still turns.
  constexpr double kTurns = 1.25;
  const double led = std::min(feed_time - options_.latency, *newest_ + kTurns * beam_.period());
  const double until = options_.steady ? led : std::max(*newest_, led) - options_.settle;
  release(std::min(until, beam_.doubtfulSince().value_or(until)));
}

// A live feed has no end at which it would be said.
void SectorCutter::sayThatUnknown() {
  constexpr double kPatience = 60.0;  // [s]
  constexpr std::size_t kMany = 100;
  if (said_unknown_ || reports_.size() < kMany || *newest_ - *earliest_ < kPatience) return;
  said_unknown_ = true;
  events_.fault("unknown beams", std::to_string(reports_.size()) + " reports from " + seconds(*earliest_) + " to " +
                                     seconds(*newest_) + ": " + beam_.whyUnknown());
}

// The antenna changed its speed, was restarted, or the radar's clock was set: the sectors go on along the new beam.
void SectorCutter::followBreak() {
  if (const auto line = beam_.findBreak()) return turnAlong(*line);
  if (!beam_.isLost()) return;
  const double since = *beam_.doubtfulSince();
  events_.fault("beams lost", beam_.scansToAndFro()
                                  ? "from " + seconds(since) + " on the antenna scans to and fro: that is not read"
                                  : "from " + seconds(since) + " on the reports do not show how the antenna turns");
  release(since);
  beam_.interrupt();
  running_.reset();
  earliest_ = since;
}

void SectorCutter::turnAlong(const tws::SteadyBeam& line) {
  const double period = beam_.period();
  release(line.time);
  char text[160];
  std::snprintf(text, sizeof text, "at %s: the beam was %+.1f degrees off, the period %.3f s, now %.3f s",
                seconds(line.time).c_str(),
                tws::degrees(tws::angularDifference(line.azimuth, beam_.azimuthAt(line.time))), period,
                tws::kTwoPi / line.rate);
  events_.fault("beam breaks", text);
  // A revolution more, so that nobody measures the period across the break.
  const double start = std::max(line.time, enter_time_);
  beam_.turnAlong(line);
  beam_.raise(start, static_cast<double>(*running_ + tws::kSectors + 1) * tws::kSectorWidth);
  running_ = static_cast<std::int64_t>(std::ceil(beam_.azimuthAt(start) / tws::kSectorWidth));
  enter_time_ = beam_.timeAt(static_cast<double>(*running_) * tws::kSectorWidth);
  placeAll();
}

void SectorCutter::finish() {
  if (!newest_) return;
  if (!beam_.isKnown() && !beam_.learnNow(*newest_, 0.0)) {
    if (!reports_.empty())
      events_.fault("reports of an unknown beam",
                    std::to_string(reports_.size()) + " up to " + seconds(*newest_) + ": " + beam_.whyUnknown());
    return reports_.clear();
  }
  if (!running_) start();
  if (!beam_.doubtfulSince()) beam_.learnNow(*newest_, enter_time_);
  while (enter_time_ <= *newest_) close();
}

void SectorCutter::release(double until) {
  if (!running_) start();
  while (beam_.timeAt(static_cast<double>(*running_ + 1) * tws::kSectorWidth) <= until) close();
}

double SectorCutter::silence() const {
  constexpr double kTurns = 2.5;
  const double period = beam_.period();
  return period > 0.0 ? std::max(options_.silence, kTurns * period) : options_.silence;
}

// The beam may have been found only after some turns: what was kept of them counts, but not what lies so far back that
// the beam then is a guess.
void SectorCutter::start() {
  constexpr double kFarBack = 400.0;
  placeAll();
  const double oldest = *newest_ - kFarBack;
  const auto first = std::find_if(reports_.begin(), reports_.end(), [&](const auto& r) { return r.time >= oldest; });
  const auto lost = first - reports_.begin();
  if (lost > 0) events_.fault("reports before the beam was known", std::to_string(lost) + " before " + seconds(oldest));
  reports_.erase(reports_.begin(), first);
  earliest_ = std::max(*earliest_, oldest);
  beam_.startAt(followed_ = *earliest_);
  beam_.raise(*earliest_, static_cast<double>(next_) * tws::kSectorWidth);
  running_ = static_cast<std::int64_t>(std::floor(beam_.azimuthAt(*earliest_) / tws::kSectorWidth));
  enter_time_ = beam_.timeAt(static_cast<double>(*running_) * tws::kSectorWidth);
}

// What is released at once may be many turns: the beam is followed through them.
void SectorCutter::close() {
  constexpr double kAtLeast = 1.0;  // [s]
  CutSector sector;
  sector.running = *running_;
  sector.sector = static_cast<int>(((*running_ % tws::kSectors) + tws::kSectors) % tws::kSectors);
  sector.enter_time = enter_time_;
  next_ = *running_ + 1;
  running_ = next_;
  if (sector.enter_time - followed_ > std::max(kAtLeast, beam_.period())) {
    beam_.followFrom(followed_ = sector.enter_time);
  }
  enter_time_ = sector.leave_time = beam_.timeAt(static_cast<double>(*running_) * tws::kSectorWidth);
  sector.period = beam_.period();
  const auto first = reports_.begin();
  const auto last = std::find_if(first, reports_.end(), [&](const auto& r) { return r.time >= sector.leave_time; });
  sector.reports.assign(first, last);
  reports_.erase(first, last);
  events_.sector(std::move(sector));
}

}  // namespace asterix_bridge
