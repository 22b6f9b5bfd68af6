#include "simulation.h"

#include <algorithm>

namespace radar_sim {

Simulation::Simulation(const Scenario& scenario) : scenario_(scenario), targets_(allTargets(scenario)) {
  for (const RadarParams& radar : scenario_.radars) {
    std::vector<Fault> faults;
    for (const Fault& fault : scenario_.faults) {
      if (fault.radar == radar.name) faults.push_back(fault);
    }
    radars_.emplace_back(radar, mapToRadar(scenario_, radar), targets_, std::move(faults), scenario_.seed,
                         scenario_.start_time);
    skipSilence(radars_.back());
  }
  plot_counts_.resize(radars_.size());
}

std::optional<double> Simulation::nextTime() const {
  double time = truthTime();
  if (!radars_.empty()) time = std::min(time, radars_[earliestRadar()].nextMark());
  return time <= scenario_.endTime() ? std::optional<double>(time) : std::nullopt;
}

std::variant<SectorReport, TruthReport> Simulation::step() {
  if (radars_.empty() || truthTime() <= radars_[earliestRadar()].nextMark()) return takeTruth();
  return closeSector(earliestRadar());
}

std::size_t Simulation::earliestRadar() const {
  const auto isEarlier = [](const RotatingRadar& a, const RotatingRadar& b) { return a.nextMark() < b.nextMark(); };
  return static_cast<std::size_t>(std::min_element(radars_.begin(), radars_.end(), isEarlier) - radars_.begin());
}

// The antenna turns on and the sectors count on, but nobody hears of them.
void Simulation::skipSilence(RotatingRadar& radar) const {
  while (radar.nextMark() <= scenario_.endTime() && radar.isSilentAt(radar.nextMark())) radar.closeSector();
}

SectorReport Simulation::closeSector(std::size_t index) {
  RotatingRadar& radar = radars_[index];
  SectorReport report{index, radar.closeSector(), 0, 0.0, {}};
  report.plot_count = plot_counts_[index] += report.sector.plots.size();
  report.rotation_period = radar.rotationPeriod(report.sector.running + 1);
  const double mark = report.sector.leave_time;
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (other == index || radars_[other].isSilentAt(mark)) continue;
    report.others.push_back({other, radars_[other].antenna().azimuthAt(mark)});
  }
  skipSilence(radar);
  return report;
}

TruthReport Simulation::takeTruth() {
  TruthReport truth{truthTime(), {}};
  ++truth_count_;
  for (std::size_t target = 0; target < targets_.size(); ++target) {
    if (!targets_[target].trajectory->existsAt(truth.time)) continue;
    TruthReport::Entry entry{target, targets_[target].trajectory->at(truth.time), {}};
    for (const RotatingRadar& radar : radars_) {
      const tws::Polar polar = radar.polarOf(targets_[target], truth.time);
      entry.sightings.push_back({polar.range, polar.azimuth, radar.detectionProbability(target, truth.time)});
    }
    truth.entries.push_back(std::move(entry));
  }
  return truth;
}

}  // namespace radar_sim
