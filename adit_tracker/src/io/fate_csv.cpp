#include "io/fate_csv.h"

#include <cmath>
#include <cstdio>
#include <ostream>

#include <tws_core/units.h>

namespace adit_tracker {

namespace {
constexpr const char* kNames[] = {"left", "updated", "started", "clutter", "skipped"};  // by PlotFate::Kind
}  // namespace

FateCsv::FateCsv(std::ostream& output) : output_(output) {
  output_ << "t_s,radar,range_m,az_deg,fate,track_id,chance_false,claims\n";
}

void FateCsv::add(const Adit& adit, const SectorFates& sector) {
  char text[120];
  for (const PlotFate& fate : sector.plots) {
    std::snprintf(text, sizeof text, "%.4f,", fate.plot.time);
    output_ << text << adit.params().radars[sector.radar].name;
    std::snprintf(text, sizeof text, ",%.1f,%.4f,%s,", fate.plot.range, tws::degrees(fate.plot.azimuth),
                  kNames[fate.kind]);
    output_ << text;
    if (fate.uid != 0) output_ << fate.uid;
    std::snprintf(text, sizeof text, ",%.4f,", fate.left);
    output_ << text;
    const char* space = "";
    for (const PlotClaim& claim : fate.claims) {
      std::snprintf(text, sizeof text, "%s%u:%.3f:%.1f", space, claim.uid, static_cast<double>(claim.chance),
                    static_cast<double>(claim.sigmas));
      output_ << text;
      space = " ";
    }
    output_ << '\n';
  }
}

}  // namespace adit_tracker
