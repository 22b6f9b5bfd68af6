#include "clutter/clutter_kinds.h"

#include <algorithm>
#include <set>

#include "clutter/angels.h"
#include "clutter/anomalous_propagation.h"
#include "clutter/cell_clutter.h"
#include "clutter/jammer.h"
#include "clutter/land_clutter.h"
#include "clutter/rain.h"
#include "clutter/sea_clutter.h"
#include "clutter/second_time_around.h"
#include "clutter/wind_farm.h"
#include "rotating_sensor.h"
#include "scenario.h"

namespace radar_sim {
namespace {

constexpr double kMostCells = 2e6;  // of one radar: each costs time on every scan

std::vector<const RadarParams*> rotatingRadars(const Scenario& scenario) {
  std::vector<const RadarParams*> radars;
  for (const auto& sensor : scenario.sensors)
    if (const auto* radar = dynamic_cast<const RotatingSpec*>(sensor.get())) radars.push_back(&radar->params);
  return radars;
}

void checkRadars(const ParameterReader& reader, const ClutterSpec& spec, const Scenario& scenario) {
  const auto radars = rotatingRadars(scenario);
  for (const std::string& name : spec.radars) {
    const auto isIt = [&](const RadarParams* radar) { return radar->name == name; };
    if (std::none_of(radars.begin(), radars.end(), isIt))
      reader.fail("radars", "there is no rotating primary radar '" + name + "'");
  }
  for (const RadarParams* radar : radars) {
    if (spec.isSeenBy(radar->name) && rangeCells(*radar) * spokes(radar->azimuth_beamwidth) > kMostCells)
      reader.fail("name", "radar '" + radar->name +
                              "' has more than 2000000 resolution cells, too many for clutter: "
                              "a longer pulse, a wider beam or a shorter max_range_m, or other radars");
  }
}

}  // namespace

const std::vector<ClutterKind>& clutterKinds() {
  static const std::vector<ClutterKind> kinds{
      {"rain", readRain},
      {"sea_clutter", readSeaClutter},
      {"land_clutter", readLandClutter},
      {"wind_farms", readWindFarm},
      {"angels", readAngels},
      {"second_time_around", readSecondTimeAround},
      {"anomalous_propagation", readAnomalousPropagation},
      {"jammers", readJammer},
  };
  return kinds;
}

void readClutterFields(ParameterReader& reader, const ReadingContext& context, Scenario& scenario) {
  std::set<std::string> names;
  for (const ClutterKind& kind : clutterKinds()) {
    for (ParameterReader& entry : reader.list(kind.key)) {
      std::shared_ptr<ClutterSpec> spec = kind.read(entry, context);
      spec->name = kind.key + "_" + std::to_string(names.size() + 1);
      readName(entry, spec->name);
      if (!names.insert(spec->name).second) entry.fail("name", "'" + spec->name + "' is used twice");
      checkRadars(entry, *spec, scenario);
      entry.done();
      scenario.clutter_fields.push_back(std::move(spec));
    }
  }
}

}  // namespace radar_sim
