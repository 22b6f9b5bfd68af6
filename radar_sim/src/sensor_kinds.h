#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reading.h"
#include "sensor.h"

namespace radar_sim {

/// One kind of sensor: the scenario's key, and the reader of what stands there.
struct SensorKind {
  enum class Form { kList, kOne };  ///< A list of maps, or one map.

  std::string key;
  Form form;
  /// Reads one map, all of it. Sites, targets and the sensors of the kinds above are read by then.
  std::unique_ptr<SensorSpec> (*read)(ParameterReader& reader, const Scenario& scenario);
};

/// All kinds. Their order is that of what happens at one time.
const std::vector<SensorKind>& sensorKinds();

}  // namespace radar_sim
