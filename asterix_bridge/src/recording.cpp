#include "recording.h"

#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace asterix_bridge {
namespace {

constexpr double kDay = 86400.0;

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
  for (const TargetReport& report : block_.reports) {
    const double time =
        report.is_time_truncated ? clock_.fullFromTruncated(report.time_of_day) : clock_.full(report.time_of_day);
    if (report.source) events_.report(report, time);
    if (!report.source) events_.fault(FaultKind::kNoSource, {framed.offset, "a target report without SAC and SIC"});
  }
  for (const ServiceMessage& message : block_.messages) {
    const double time = clock_.full(message.time_of_day);
    if (message.source) events_.message(message, time);
    if (!message.source) events_.fault(FaultKind::kNoSource, {framed.offset, "a service message without SAC and SIC"});
  }
  if (block_.fault)
    events_.fault(block_.is_unknown ? FaultKind::kUnknownCategory : FaultKind::kBadRecord, *block_.fault);
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

Contents contentsOf(const Recording& recording, const DataClock& clock) {
  Contents contents;
  const auto note = [&](double time) {
    if (!(contents.start <= time)) contents.start = std::isnan(time) ? contents.start : time;
    if (!(contents.end >= time)) contents.end = std::isnan(time) ? contents.end : time;
  };
  RecordStream::Events events;
  events.report = [&](const TargetReport& report, double time) {
    ++contents.radars[*report.source].reports;
    note(time);
  };
  events.message = [&](const ServiceMessage& message, double time) {
    RadarContents& radar = contents.radars[*message.source];
    if (message.type == kNorthMarker || message.type == kSectorCrossing) ++radar.marks;
    if (!radar.position) radar.position = message.position;
    note(time);
  };
  events.fault = [&](FaultKind, const BlockFault&) { ++contents.faults; };
  RecordStream stream(clock, std::move(events));
  const std::unique_ptr<BlockFinder> blocks = recording.blocks();
  while (const auto step = blocks->next()) stream.add(*step);
  return contents;
}

}  // namespace asterix_bridge
