// The tables that the tracker reads: plots, and clutter maps, which are written and read again.
#include <cmath>
#include <sstream>

#include "clutter/clutter_csv.h"
#include "fuzzing.h"
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
      if (!(plot.time >= last && plot.time < INFINITY)) found("a plot out of the order of time");
      last = plot.time;
    }
  }
  if (plots != table.plots) found("the count of plots is wrong");
}

void readClutter(const std::string& text) {
  adit_tracker::AditParams params;
  params.radars = {{}, {}};
  params.radars[0].name = "A";
  params.radars[1].name = "B";
  const adit_tracker::ClutterLimits limits(params);
  std::istringstream input(text);
  const auto places = adit_tracker::readClutter(input, kName, limits);
  std::stringstream again;
  adit_tracker::writeClutter(again, places);
  if (adit_tracker::readClutter(again, kName, limits).size() != places.size()) found("a clutter map is not read back");
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  const std::string text(input);
  readOrComplain(kName, [&] { readPlots(text); });
  readOrComplain(kName, [&] { readClutter(text); });
}
