#pragma once

#include <map>
#include <memory>
#include <set>

#include "recording.h"
#include "sector_cutter.h"

namespace asterix_bridge {

/// All radars of a feed, file or network: blocks in, the radars' sectors out.
class RadarFeed {
 public:
  struct Options {
    SectorCutter::Options sectors;
    bool test_targets = false;  // keep them
    std::set<SourceId> listed;  // radars that are known beforehand
    bool only_listed = false;
    std::size_t most_radars = 32;  // further ones: who has no beam yet makes room, the one longest silent first
  };
  struct Events {
    std::function<void(SourceId radar, CutSector&& sector)> sector;
    /// Only of a radar that gave a sector or is listed.
    std::function<void(SourceId radar, const tws::Geodetic& position)> position;
    /// Something wrong: what it is counted as, and the reason with the place.
    std::function<void(const std::string& counter, const std::string& reason)> fault;
    /// Something left out on purpose: "reports without detection", "test targets".
    std::function<void(const std::string& counter)> left_out;
  };

  RadarFeed(DataClock clock, Options options, Events events);
  RadarFeed(const RadarFeed&) = delete;
  RadarFeed& operator=(const RadarFeed&) = delete;

  /// Live, the feed's time is what advance() says; of a file, its data say it.
  /// `origin` is put before the offset in reasons, e.g. the file's name or the sender.
  void add(const FramingStep& step, const std::string& origin);
  /// The feed has come to this time since 1970 [s], by a clock that goes on without data.
  void advance(double now);
  /// From now on, see SectorCutter::Options [s].
  void setLatency(double latency);
  /// The end of a file: what waits comes out.
  void finish();
  /// Where the feed is now, since 1970 [s].
  double now() const { return stream_.clock().now(); }
  std::uint64_t records() const { return stream_.records(); }

 private:
  void add(const TargetReport& report, double time);
  void add(const ServiceMessage& message, double time);
  /// Nothing: there is no room for one more radar.
  SectorCutter* cutterOf(SourceId radar);
  bool hasRoom();
  bool isListed(SourceId radar) const { return options_.listed.count(radar) > 0; }
  void placeOf(SourceId radar, const tws::Geodetic& position);

  Options options_;
  Events events_;
  std::map<SourceId, SectorCutter> cutters_;
  std::map<SourceId, std::uint64_t> heard_;   // the number of each one's last record
  std::map<SourceId, tws::Geodetic> places_;  // of radars whose beam is not known yet
  std::set<SourceId> proven_;                 // those that gave a sector
  std::string origin_;
  RecordStream stream_;
};

}  // namespace asterix_bridge
