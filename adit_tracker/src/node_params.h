#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/radar_inputs.h>

#include <cstddef>
#include <string>
#include <vector>

#include "adit_params.h"
#include "io/own_ship_gate.h"

namespace adit_tracker {

/// The tracker's parameters and those of the node around it.
struct NodeParams {
  AditParams adit;
  std::string frame = "map";  // of positions
  tws_runtime::RadarInputs::Options inputs;
  std::size_t overflow = 20;  // sectors behind the antenna
  std::string point_topic;
  bool plot_fates = false;  // publish what becomes of each plot
  OwnShipParams own_ship;
  std::string clutter_map;         // file
  std::string clutter_map_folder;  // of what is saved and loaded by service
};

/// Throws tws_runtime::ParameterError.
NodeParams readNodeParams(tws_runtime::Bus& bus);

/// Of the radars, in their order.
std::vector<std::string> namesOf(const AditParams& params);
std::vector<tws_runtime::RadarTopics> topicsOf(const AditParams& params);

}  // namespace adit_tracker
