#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/rotation.h>

#include "block.h"
#include "data_clock.h"
#include "framing.h"

namespace asterix_bridge {

/// A file of ASTERIX blocks, read into memory.
class Recording {
 public:
  /// Throws std::runtime_error that names the file when it cannot be read or shows no known framing.
  explicit Recording(const std::string& path);

  const std::string& path() const { return path_; }
  Framing framing() const { return framing_; }
  std::size_t size() const { return bytes_.size(); }
  std::unique_ptr<BlockFinder> blocks() const { return findBlocks({bytes_.data(), bytes_.size()}, framing_); }
  /// When the file was last written, since 1970 [s].
  double writeTime() const { return write_time_; }

 private:
  std::string path_;
  std::vector<std::uint8_t> bytes_;
  Framing framing_ = Framing::kRaw;
  double write_time_ = 0.0;
};

/// What goes wrong with a feed: where it is said, what it is counted as.
enum class FaultKind { kFraming, kBadRecord, kUnknownCategory, kNoSource };
/// Its counter's name: "blocks passed over", "bad records", …
std::string toText(FaultKind kind);

/// Takes the steps through a recording, or the blocks of datagrams, and gives their records with full times.
class RecordStream {
 public:
  struct Events {
    /// `time` since 1970 [s]; NaN: the record says none.
    std::function<void(const TargetReport& report, double time)> report;
    std::function<void(const ServiceMessage& message, double time)> message;
    std::function<void(FaultKind kind, const BlockFault& fault)> fault;
  };

  RecordStream(DataClock clock, Events events) : clock_(clock), events_(std::move(events)) {}

  void add(const FramingStep& step);
  /// There will be no more: reports that wait for a mark come out without a time.
  void finish();
  const DataClock& clock() const { return clock_; }
  std::uint64_t blocks() const { return blocks_; }
  std::uint64_t records() const { return records_; }

 private:
  void add(const FramedBlock& framed);
  void add(TargetReport& report, const FramedBlock& framed);
  void addUntimed(TargetReport& report, const FramedBlock& framed);
  void add(const ServiceMessage& message, std::size_t offset);
  void release(SourceId source, double mark);

  DataClock clock_;
  Events events_;
  Block block_;
  std::map<SourceId, double> marks_;  // the time of each radar's latest, at most kMostSources
  std::deque<TargetReport> untimed_;  // wait for the first mark of their radar, at most kMostUntimed
  std::uint64_t blocks_ = 0;
  std::uint64_t records_ = 0;
};

/// What a recording holds of one radar.
struct RadarContents {
  std::uint64_t reports = 0;
  std::uint64_t marks = 0;                // north and sector marks
  std::optional<tws::Geodetic> position;  // the first one sent
  tws::TimedAzimuths first;               // plots and sector marks, at most 200
};

/// What a recording holds.
struct Contents {
  std::map<SourceId, RadarContents> radars;
  double start = kUnknown;  // time of the earliest and latest record since 1970 [s]
  double end = kUnknown;
  std::uint64_t faults = 0;
  std::map<std::string, std::uint64_t> reasons;  // of faults, the first of them
};

/// A clock for the recording's first record. `date`: midnight of the day on which that was, since 1970 [s]. Without it
/// the packets' own time says the day; without that, it is the last time before the file was written at which it was
/// that time of day.
DataClock clockFor(const Recording& recording, std::optional<double> date);
Contents contentsOf(const Recording& recording, const DataClock& clock);
/// What is in a recording in place of records that are decoded: "540 times: link type 147 is not known".
std::string whyEmpty(const Contents& contents);

}  // namespace asterix_bridge
