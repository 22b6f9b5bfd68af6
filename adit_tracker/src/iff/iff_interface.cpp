#include "iff/iff_interface.h"

#include <tws_runtime/conversions.h>

#include <tws_core/sectors.h>

namespace adit_tracker {
IffInterface::IffInterface(tws_runtime::Bus& bus, const std::string& frame, const std::vector<IffParams>& params,
                           double restart_limit)
    : bus_(bus), restart_limit_(restart_limit) {
  for (std::size_t i = 0; i < params.size(); ++i) {
    interrogators_.push_back({params[i].name, {bus, frame, kPatience}});
    bus.subscribe<tws_msgs::SsrPlots>(params[i].name + "/plots",
                                      [this, i](const auto& m) { onPlots(interrogators_[i], m); });
  }
}

void IffInterface::beginNewRun(double time) {
  radars_at_ = time;
  for (Interrogator& iff : interrogators_) {
    iff.gate.clear();
    iff.waiting.clear();
    iff.gone_back = false;
  }
}

void IffInterface::onPlots(Interrogator& iff, const tws_msgs::SsrPlots& message) {
  tws::RadarSector sector;
  sector.sector = message.sector % tws::kSectors;
  sector.running = message.running_sector;
  sector.leave_time = tws_runtime::toSeconds(message.header.stamp);
  for (const tws_msgs::SsrPlot& p : message.plots) {
    const std::string fault = tws_runtime::faultOf(p, sector.leave_time);
    if (!fault.empty()) {
      bus_.counter("bad IFF plots").add(fault + " in " + iff.name + "/plots");
      continue;
    }
    tws::Plot& plot = sector.plots.emplace_back();
    plot.time = tws_runtime::toSeconds(p.stamp);
    plot.range = p.range;
    plot.azimuth = p.azimuth;
  }
  addSector(iff, message.header.frame_id, std::move(sector));
}

void IffInterface::addSector(Interrogator& iff, const std::string& frame, tws::RadarSector sector) {
  iff.gone_back = iff.gone_back || sector.leave_time <= radars_at_ + restart_limit_;
  if (!iff.gone_back) {
    bus_.counter("messages of the old run")
        .add(iff.name + ": up to " + std::to_string(sector.leave_time) + " s, the radars are at " +
             std::to_string(radars_at_) + " s");
    return;
  }
  iff.gate.add(frame, std::move(sector), [this, &iff](tws::RadarSector& placed) { await(iff, std::move(placed)); });
}

void IffInterface::await(Interrogator& iff, tws::RadarSector sector) {
  iff.waiting.push_back(std::move(sector));
  if (iff.waiting.size() <= kMostWaiting) return;
  iff.waiting.pop_front();
  bus_.counter("dropped IFF sectors")
      .add("more than " + std::to_string(kMostWaiting) + " of " + iff.name +
           " wait: the radars are silent, or its clock is ahead of theirs");
}

void IffInterface::handOver(Adit& adit, const RadarSites& sites) {
  for (std::size_t i = 0; i < interrogators_.size(); ++i) {
    Interrogator& iff = interrogators_[i];
    if (iff.waiting.empty()) continue;
    const auto& site = iff.gate.site();
    std::deque<tws::RadarSector> ahead;
    for (tws::RadarSector& sector : iff.waiting) {
      const std::size_t plots = sector.plots.size();
      const std::string which = "up to " + std::to_string(sector.leave_time) + " s, of " + iff.name;
      if (!site)
        leaveOut("unplaced IFF plots", plots, which);
      else if (sector.leave_time > radars_at_)
        ahead.push_back(std::move(sector));
      else if (!adit.addIff(i, std::move(sector), sites.onPlane(*site)))
        leaveOut("late IFF plots", plots, which);
    }
    iff.waiting = std::move(ahead);
  }
}

void IffInterface::leaveOut(const char* counter, std::size_t plots, const std::string& reason) {
  for (std::size_t i = 0; i < plots; ++i) bus_.counter(counter).add(reason);
}

}  // namespace adit_tracker
