// The tables that the tracker reads: plots; own ship's places; and clutter maps with what was learned of radars, which
// are written, read again and loaded.
#include <cmath>
#include <sstream>

#include "clutter/clutter_csv.h"
#include "clutter/false_plot_map.h"
#include "core/coverage_map.h"
#include "fuzzing.h"
#include "io/own_ship_csv.h"
#include "io/plot_csv.h"

namespace {

using fuzzing::found;

const std::string kName = "input";

void readPlots(const std::string& text) {
  std::istringstream input(text);
  const adit_tracker::PlotTable table = adit_tracker::readPlots(input, kName);
  std::size_t plots = 0;
  for (const auto& [radar, of_it] : table.radars) {
    plots += of_it.size();
    double last = -INFINITY;
    for (const tws::Plot& plot : of_it) {
      if (!std::isfinite(plot.range) || !std::isfinite(plot.azimuth)) found("a plot at no place");
      if (std::abs(plot.range_rate) > 1e5) found("a range rate out of all bounds");
      if (!(plot.time >= last && plot.time < INFINITY)) found("a plot out of the order of time");
      last = plot.time;
    }
  }
  if (plots != table.plots) found("the count of plots is wrong");
}

std::string written(const adit_tracker::SavedMaps& maps) {
  std::ostringstream output;
  adit_tracker::writeClutter(output, maps);
  return output.str();
}

/// What is read can be loaded, and then says what makes sense.
void load(const adit_tracker::RadarCounts& counts) {
  if (!problemOf(counts).empty()) found("counts of a radar that cannot be loaded");
  adit_tracker::FalsePlotMap false_plots;
  adit_tracker::CoverageMap cover;
  false_plots.load(counts);
  cover.load(counts);
  for (const double range : {0.0, 5e3, 50e3, 1e6}) {
    const double density = false_plots.density(range, 1.0), detection = cover.detection(range, 1.0);
    if (!(density >= 0.0 && density < INFINITY)) found("a density of false plots that is none");
    if (!(detection >= 0.0 && detection <= 1.0)) found("a chance of detection that is none");
  }
}

void readOwnShip(const std::string& text) {
  std::istringstream input(text);
  const adit_tracker::OwnShipTable table = adit_tracker::readOwnShip(input, kName);
  for (const double time :
       {table.ship.first(), 0.5 * (table.ship.first() + table.ship.latest()), table.ship.latest()}) {
    const auto pose = table.ship.at(time);
    if (pose && !(std::isfinite(pose->x) && std::isfinite(pose->y) && std::isfinite(pose->heading)))
      found("own ship at no place");
  }
  if (!table.ship.at(table.ship.latest())) found("own ship's last place is not known");
}

void readClutter(const std::string& text) {
  adit_tracker::AditParams params;
  params.radars = {{}, {}};
  params.radars[0].name = "A";
  params.radars[1].name = "B";
  const adit_tracker::ClutterLimits limits(params);
  std::istringstream input(text);
  const auto maps = adit_tracker::readClutter(input, kName, limits);
  std::istringstream again(written(maps));
  const auto reread = adit_tracker::readClutter(again, kName, limits);
  if (reread.clutter.size() != maps.clutter.size()) found("a clutter map is not read back");
  if (written(reread) != again.str()) found("maps change when they are written and read again");
  for (const adit_tracker::RadarCounts& counts : maps.radars) load(counts);
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  const std::string text(input);
  readOrComplain(kName, [&] { readPlots(text); });
  readOrComplain(kName, [&] { readOwnShip(text); });
  readOrComplain(kName, [&] { readClutter(text); });
}
