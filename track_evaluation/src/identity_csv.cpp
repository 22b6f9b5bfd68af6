#include "identity_csv.h"

#include <tws_core/csv_table.h>
#include <tws_core/geometry.h>
#include <tws_core/units.h>

namespace track_evaluation {

void readPlots(std::istream& input, const std::string& name, IdentityMetrics& metrics) {
  tws::CsvTable table(input, name);
  const std::size_t time = table.require("t_s"), range = table.require("range_m"), azimuth = table.require("az_deg"),
                    code = table.require("mode3a");
  while (table.next()) {
    if (table.text(code).empty()) continue;
    metrics.addPlot(table.time(time), table.whole(code, 8),
                    tws::planarFromPolar(table.number(range), tws::radians(table.number(azimuth))));
  }
}

void readPlotFile(const std::string& path, IdentityMetrics& metrics) { readPlots(*tws::openText(path), path, metrics); }

}  // namespace track_evaluation
