#include "recording.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace asterix_bridge {
namespace {

constexpr double kDay = 86400.0;
constexpr std::size_t kMostUntimed = 1000;
constexpr std::size_t kMostSources = 1000;

// The first block that has a time, and that time: since 1970, or of the day [s].
struct FirstTime {
  std::optional<double> time;
  std::optional<double> time_of_day;
};

std::optional<double> timeOfDayIn(const Block& block) {
  for (const ServiceMessage& message : block.messages)
    if (!std::isnan(message.time_of_day)) return message.time_of_day;
  for (const TargetReport& report : block.reports)
    if (!std::isnan(report.time_of_day) && !report.is_time_truncated) return report.time_of_day;
  return std::nullopt;
}

FirstTime firstTimeOf(const Recording& recording) {
  const std::unique_ptr<BlockFinder> blocks = recording.blocks();
  Block block;
  while (const auto step = blocks->next()) {
    if (!step->block) continue;
    if (step->block->time) return {step->block->time, std::nullopt};
    if (step->block->time_of_day) return {std::nullopt, step->block->time_of_day};
    decodeBlock(step->block->bytes, 0, block);
    if (const auto time_of_day = timeOfDayIn(block)) return {std::nullopt, time_of_day};
  }
  return {};
}

}  // namespace

Recording::Recording(const std::string& path) : path_(path) {
  struct stat status {};
  std::ifstream file(path, std::ios::binary);
  if (!file || stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    throw std::runtime_error(path + ": cannot be read");
  write_time_ = static_cast<double>(status.st_mtime);
  bytes_.resize(static_cast<std::size_t>(status.st_size));
  file.read(reinterpret_cast<char*>(bytes_.data()), static_cast<std::streamsize>(bytes_.size()));
  bytes_.resize(static_cast<std::size_t>(file.gcount()));
  try {
    framing_ = detectFraming({bytes_.data(), bytes_.size()});
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::string toText(FaultKind kind) {
  switch (kind) {
    case FaultKind::kFraming:
      return "bytes passed over";
    case FaultKind::kBadRecord:
      return "bad blocks";
    case FaultKind::kUnknownCategory:
      return "blocks of other categories";
    case FaultKind::kNoSource:
      break;
  }
  return "records without a source";
}

void RecordStream::add(const FramingStep& step) {
  if (step.block) add(*step.block);
  if (step.fault) events_.fault(FaultKind::kFraming, {step.fault->offset, step.fault->reason});
}

void RecordStream::add(const FramedBlock& framed) {
  ++blocks_;
  if (framed.time) clock_.receiveAt(*framed.time);
  if (framed.time_of_day) clock_.receiveAtTimeOfDay(*framed.time_of_day);
  decodeBlock(framed.bytes, framed.offset, block_);
  records_ += block_.reports.size() + block_.messages.size();
  for (TargetReport& report : block_.reports) add(report, framed);
  for (const ServiceMessage& message : block_.messages) add(message, framed.offset);
  if (block_.fault)
    events_.fault(block_.is_unknown ? FaultKind::kUnknownCategory : FaultKind::kBadRecord, *block_.fault);
}

void RecordStream::add(TargetReport& report, const FramedBlock& framed) {
  if (!report.source)
    return events_.fault(FaultKind::kNoSource, {framed.offset, "a target report without SAC and SIC"});
  if (std::isnan(report.time_of_day)) return addUntimed(report, framed);
  const double time = report.time_of_day;
  events_.report(report, report.is_time_truncated ? clock_.fullFromTruncated(time) : clock_.full(time));
}

void RecordStream::addUntimed(TargetReport& report, const FramedBlock& framed) {
  const auto mark = marks_.find(*report.source);
  report.time_from = mark != marks_.end() ? TimeFrom::kMark : TimeFrom::kReception;
  if (mark != marks_.end()) return events_.report(report, mark->second);
  if (framed.time || framed.time_of_day) return events_.report(report, clock_.now());
  report.time_from = TimeFrom::kMark;
  untimed_.push_back(report);
  if (untimed_.size() <= kMostUntimed) return;
  events_.report(untimed_.front(), std::nan(""));
  untimed_.pop_front();
}

void RecordStream::add(const ServiceMessage& message, std::size_t offset) {
  const double time = clock_.full(message.time_of_day);
  if (!message.source) return events_.fault(FaultKind::kNoSource, {offset, "a service message without SAC and SIC"});
  events_.message(message, time);
  if (!std::isnan(time)) release(*message.source, time);
}

void RecordStream::release(SourceId source, double mark) {
  if (marks_.size() < kMostSources || marks_.count(source) > 0) marks_[source] = mark;
  const auto isOf = [&](const TargetReport& report) {
    return !(*report.source < source) && !(source < *report.source);
  };
  for (const TargetReport& report : untimed_)
    if (isOf(report)) events_.report(report, mark);
  untimed_.erase(std::remove_if(untimed_.begin(), untimed_.end(), isOf), untimed_.end());
}

void RecordStream::finish() {
  for (const TargetReport& report : untimed_) events_.report(report, std::nan(""));
  untimed_.clear();
}

DataClock clockFor(const Recording& recording, std::optional<double> date) {
  const FirstTime first = firstTimeOf(recording);
  const double within_day = first.time          ? std::fmod(*first.time, kDay)
                            : first.time_of_day ? std::fmod(*first.time_of_day, kDay)
                                                : 0.0;
  if (date) return DataClock(*date + within_day);
  if (first.time) return DataClock(*first.time);
  const double time = std::floor(recording.writeTime() / kDay) * kDay + within_day;
  return DataClock(time > recording.writeTime() ? time - kDay : time);
}

namespace {

void noteFirst(RadarContents& radar, double time, double azimuth) {
  constexpr std::size_t kMost = 200;
  if (radar.first.size() < kMost && std::isfinite(time) && std::isfinite(azimuth))
    radar.first.push_back({time, azimuth});
}

}  // namespace

Contents contentsOf(const Recording& recording, const DataClock& clock) {
  Contents contents;
  const auto note = [&](double time) {
    if (!(contents.start <= time)) contents.start = std::isnan(time) ? contents.start : time;
    if (!(contents.end >= time)) contents.end = std::isnan(time) ? contents.end : time;
  };
  RecordStream::Events events;
  events.report = [&](const TargetReport& report, double time) {
    RadarContents& radar = contents.radars[*report.source];
    ++radar.reports;
    if (report.range > 0.0 && !report.test_target && report.time_from == TimeFrom::kReport)
      noteFirst(radar, time, report.azimuth);
    note(time);
  };
  events.message = [&](const ServiceMessage& message, double time) {
    RadarContents& radar = contents.radars[*message.source];
    if (message.type == kSectorCrossing) noteFirst(radar, time, message.sector_azimuth);
    if (message.type == kNorthMarker || message.type == kSectorCrossing) ++radar.marks;
    if (!radar.position) radar.position = message.position;
    note(time);
  };
  events.fault = [&](FaultKind, const BlockFault& fault) {
    constexpr std::size_t kMostReasons = 100;
    ++contents.faults;
    if (contents.reasons.size() < kMostReasons || contents.reasons.count(fault.reason) > 0)
      ++contents.reasons[fault.reason];
  };
  RecordStream stream(clock, std::move(events));
  const std::unique_ptr<BlockFinder> blocks = recording.blocks();
  while (const auto step = blocks->next()) stream.add(*step);
  stream.finish();
  return contents;
}

std::string whyEmpty(const Contents& contents) {
  if (contents.reasons.empty()) return "no record of a radar";
  const auto rarer = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto most = std::max_element(contents.reasons.begin(), contents.reasons.end(), rarer);
  return "no record of a radar, but " + std::to_string(most->second) + " times: " + most->first +
         " (CAT001, 002, 034 and 048 are decoded)";
}

}  // namespace asterix_bridge
