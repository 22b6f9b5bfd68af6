#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/bus.h>

#include "asterix_params.h"

namespace asterix_bridge {

/// Publishes the sectors of any number of radars: /<radar>/detections, /<radar>/plots, /<radar>/sector_marks, and their
/// sites.
class RadarOutlet {
 public:
  RadarOutlet(tws_runtime::Bus& bus, const AsterixParams& params);

  /// Opens the topics of a radar, if they are not open yet. The first radar of all is the main one.
  void open(SourceId radar);
  /// Where a radar stands, as its data say; what the parameters say outranks it. The first position is the map's
  /// origin when the parameters give none. Said again, it changes nothing.
  void place(SourceId radar, const tws::Geodetic& position);
  /// A radar whose position nobody knows stands at the map's origin.
  void placeAtOrigin(SourceId radar);
  bool isPlaced(SourceId radar) const { return placed_.count(radar) > 0; }

  void publish(SourceId radar, const CutSector& sector);
  /// What waits for a place for longer than this many sectors is put at the map's origin.
  void placeWhenLate(SourceId radar);

  const std::string& nameOf(SourceId radar);

 private:
  struct Topics {
    std::string name;
    tws_runtime::Publisher<tws_msgs::Detections> detections;
    tws_runtime::Publisher<tws_msgs::SsrPlots> plots;
    tws_runtime::Publisher<tws_msgs::SectorMark> marks;
    std::uint32_t count = 0;    // detections so far
    std::uint32_t sectors = 0;  // so far
  };
  Topics& topicsOf(SourceId radar);

  tws_runtime::Bus& bus_;
  const AsterixParams& params_;
  std::optional<tws::LocalFrame> map_;
  std::map<SourceId, Topics> topics_;
  std::set<SourceId> placed_;
};

}  // namespace asterix_bridge
