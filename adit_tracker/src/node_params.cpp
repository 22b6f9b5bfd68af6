#include "node_params.h"

#include <tws_runtime/parameters.h>
#include <tws_runtime/track_writer.h>

#include <algorithm>
#include <stdexcept>

#include "adit_params_reader.h"

namespace adit_tracker {
namespace {

// Clocks that jump by less than this lose no track [s].
constexpr double kLeastSkew = 1.0;

void readOwnShip(tws_runtime::ParameterReader& reader, OwnShipParams& params) {
  reader.text("own_ship_frame", params.frame);
  reader.number("own_ship_wait_s", params.wait, 0.0, 60.0);
}

void checkOwnShip(tws_runtime::ParameterReader& reader, const NodeParams& params) {
  if (params.own_ship.frame.empty()) return;
  if (!joinsSites(params.adit))
    reader.fail("own_ship_frame", "needs filter: turning, gates: statistical, clutter/per_radar: true");
  if (!params.adit.iff.empty()) reader.fail("own_ship_frame", "does not go with iff");
  if (!params.clutter_map.empty()) reader.fail("own_ship_frame", "does not go with clutter_map, which is of one place");
}

}  // namespace

NodeParams readNodeParams(tws_runtime::Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  reader.require("radars");
  params.adit = readAditParams(reader);
  reader.text("frame", params.frame);
  if (const auto place = tws_runtime::readPlace(reader)) params.adit.map.emplace(*place);
  reader.number("wait_limit_s", params.inputs.wait_limit, 0.0, 60.0);
  reader.number("restart_limit_s", params.inputs.restart_limit, 0.5, 3600.0);
  reader.integer("overflow_sectors", params.overflow, 0, 1000000);
  reader.text("point_topic", params.point_topic);
  reader.flag("plot_fates", params.plot_fates);
  readOwnShip(reader, params.own_ship);
  reader.text("clutter_map", params.clutter_map);
  reader.text("clutter_map_folder", params.clutter_map_folder);
  reader.done();
  if (params.inputs.wait_limit >= params.adit.skew_limit) {
    reader.fail("wait_limit_s", "must be less than skew_limit_s, or what replaces lost messages comes too late");
  }
  checkOwnShip(reader, params);
  params.inputs.skew_limit = std::max(kLeastSkew, params.adit.skew_limit);
  try {
    check(params.adit);
  } catch (const std::invalid_argument& error) {
    throw tws_runtime::ParameterError(bus.name() + ": " + error.what());
  }
  return params;
}

std::vector<std::string> namesOf(const AditParams& params) {
  std::vector<std::string> names;
  for (const RadarParams& radar : params.radars) names.push_back(radar.name);
  return names;
}

std::vector<tws_runtime::RadarTopics> topicsOf(const AditParams& params) {
  std::vector<tws_runtime::RadarTopics> topics;
  for (const RadarParams& radar : params.radars) topics.push_back(tws_runtime::usualTopics(radar.name));
  return topics;
}

}  // namespace adit_tracker
