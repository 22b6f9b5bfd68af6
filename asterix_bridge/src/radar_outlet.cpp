#include "radar_outlet.h"

#include <tws_runtime/conversions.h>

#include "conversions.h"
#include "report_csv.h"

namespace asterix_bridge {

RadarOutlet::RadarOutlet(tws_runtime::Bus& bus, const AsterixParams& params) : bus_(bus), params_(params) {
  if (params.origin) map_.emplace(*params.origin);
}

RadarOutlet::Topics& RadarOutlet::topicsOf(SourceId radar) {
  const auto found = topics_.find(radar);
  if (found != topics_.end()) return found->second;
  Topics topics;
  const auto setting = params_.radars.find(radar);
  if (setting != params_.radars.end())
    topics.name = setting->second.name;
  else
    topics.name = topics_.empty() && !params_.main_radar.empty() ? params_.main_radar : radarName(radar);
  const std::string path = topics.name + "/";
  topics.detections = bus_.advertise<tws_msgs::Detections>(path + "detections");
  topics.plots = bus_.advertise<tws_msgs::SsrPlots>(path + "plots");
  topics.marks = bus_.advertise<tws_msgs::SectorMark>(path + "sector_marks");
  return topics_.emplace(radar, std::move(topics)).first->second;
}

const std::string& RadarOutlet::nameOf(SourceId radar) { return topicsOf(radar).name; }

void RadarOutlet::open(SourceId radar) {
  topicsOf(radar);
  const auto setting = params_.radars.find(radar);
  if (setting != params_.radars.end() && setting->second.position) place(radar, *setting->second.position);
}

void RadarOutlet::place(SourceId radar, const tws::Geodetic& position) {
  if (isPlaced(radar)) return;
  const auto setting = params_.radars.find(radar);
  const bool is_set = setting != params_.radars.end() && setting->second.position;
  const tws::Geodetic site = is_set ? *setting->second.position : position;
  if (!map_) map_.emplace(site);
  bus_.publishStaticTransform(toTransform(*map_, site, params_.frame, nameOf(radar)));
  placed_.insert(radar);
}

void RadarOutlet::placeAtOrigin(SourceId radar) {
  if (isPlaced(radar)) return;
  if (!placed_.empty())
    bus_.counter("unknown sites")
        .add(nameOf(radar) + " says no position: it stands at the map's origin, as others do; see parameter radars");
  bus_.publishStaticTransform(atOrigin(params_.frame, nameOf(radar)));
  placed_.insert(radar);
}

void RadarOutlet::placeWhenLate(SourceId radar) {
  constexpr std::uint32_t kTurn = 64;
  if (topicsOf(radar).sectors >= kTurn) placeAtOrigin(radar);
}

void RadarOutlet::publish(SourceId radar, const CutSector& cut) {
  Topics& topics = topicsOf(radar);
  const tws::RadarSector sector = toRadarSector(cut, params_.primary_only);
  topics.count += static_cast<std::uint32_t>(sector.plots.size());
  ++topics.sectors;
  bus_.counter("sectors").add();
  bus_.counter("detections").add(sector.plots.size());
  topics.detections.publish(tws_runtime::toDetections(sector, topics.name, topics.name));
  topics.plots.publish(toSsrPlots(cut, topics.name));
  topics.marks.publish(toSectorMark(cut, topics.name, sector.plots.size(), topics.count));
}

}  // namespace asterix_bridge
