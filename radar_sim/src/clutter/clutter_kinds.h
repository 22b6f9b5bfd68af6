#pragma once

#include <memory>
#include <string>
#include <vector>

#include "clutter/clutter.h"
#include "reading.h"

namespace radar_sim {

/// One kind of clutter: the scenario's key, under which a list of maps stands, and the reader of one of them but its
/// name.
struct ClutterKind {
  std::string key;
  std::unique_ptr<ClutterSpec> (*read)(ParameterReader& reader, const ReadingContext& context);
};

/// All kinds.
const std::vector<ClutterKind>& clutterKinds();

/// All clutter fields of a scenario, whose sensors are read by then.
void readClutterFields(ParameterReader& reader, const ReadingContext& context, Scenario& scenario);

}  // namespace radar_sim
