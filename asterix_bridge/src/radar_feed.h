#pragma once

#include <map>
#include <memory>

#include "recording.h"
#include "sector_cutter.h"

namespace asterix_bridge {

/// All radars of a feed, file or network: blocks in, the radars' sectors out.
class RadarFeed {
 public:
  struct Options {
    SectorCutter::Options sectors;
    bool test_targets = false;  // keep them
  };
  struct Events {
    std::function<void(SourceId radar, CutSector&& sector)> sector;
    std::function<void(SourceId radar, const tws::Geodetic& position)> position;
    /// Something wrong: what it is counted as, and the reason with the place.
    std::function<void(const std::string& counter, const std::string& reason)> fault;
    /// Something left out on purpose: "reports without detection", "test targets".
    std::function<void(const std::string& counter)> left_out;
  };

  RadarFeed(DataClock clock, Options options, Events events);
  RadarFeed(const RadarFeed&) = delete;
  RadarFeed& operator=(const RadarFeed&) = delete;

  /// `origin` is put before the offset in reasons, e.g. the file's name or the sender.
  void add(const FramingStep& step, const std::string& origin);
  /// The feed has come to this time since 1970 [s], by a clock that goes on without data.
  void advance(double now);
  /// The end of a file: what waits comes out.
  void finish();
  /// Where the feed is now, since 1970 [s].
  double now() const { return stream_.clock().now(); }
  std::uint64_t records() const { return stream_.records(); }

 private:
  void add(const TargetReport& report, double time);
  void add(const ServiceMessage& message, double time);
  SectorCutter& cutterOf(SourceId radar);

  Options options_;
  Events events_;
  std::map<SourceId, SectorCutter> cutters_;
  std::string origin_;
  RecordStream stream_;
};

}  // namespace asterix_bridge
