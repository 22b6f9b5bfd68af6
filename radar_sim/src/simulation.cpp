#include "simulation.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace radar_sim {
namespace {

std::vector<Fault> faultsOf(const Scenario& scenario, const std::string& radar) {
  std::vector<Fault> faults;
  const auto isItsOwn = [&](const Fault& fault) { return fault.radar == radar; };
  std::copy_if(scenario.faults.begin(), scenario.faults.end(), std::back_inserter(faults), isItsOwn);
  return faults;
}

/// When a radar reports next, and how it goes on to there.
double nextReport(const RotatingRadar& radar) { return radar.nextMark(); }
double nextReport(const SecondaryRadar& radar) { return radar.nextMark(); }
double nextReport(const ArrayRadar& radar) { return radar.nextReport(); }
double nextReport(const RangeRadar& radar) { return radar.nextProfile(); }
void goOn(RotatingRadar& radar) { radar.closeSector(); }
void goOn(SecondaryRadar& radar) { radar.closeSector(); }
void goOn(ArrayRadar& radar) { radar.runPeriod(); }
void goOn(RangeRadar& radar) { radar.takeProfile(); }

/// Index of the radar that reports first, of equal ones the first.
template <class Radar>
std::size_t earliest(const std::deque<Radar>& radars) {
  const auto isEarlier = [](const Radar& a, const Radar& b) { return nextReport(a) < nextReport(b); };
  return static_cast<std::size_t>(std::min_element(radars.begin(), radars.end(), isEarlier) - radars.begin());
}

/// Infinite without radars.
template <class Radar>
double earliestReport(const std::deque<Radar>& radars) {
  return radars.empty() ? std::numeric_limits<double>::infinity() : nextReport(radars[earliest(radars)]);
}

std::int64_t runningOf(const tws::RadarSector& sector) { return sector.running; }
std::int64_t runningOf(const SecondarySector& sector) { return sector.span.running; }
double markOf(const tws::RadarSector& sector) { return sector.leave_time; }
double markOf(const SecondarySector& sector) { return sector.span.leave_time; }

}  // namespace

Simulation::Simulation(const Scenario& scenario) : scenario_(scenario), targets_(allTargets(scenario)) {
  for (const RadarParams& radar : scenario_.radars) addRadar(radars_, radar);
  for (const SecondaryParams& radar : scenario_.secondary_radars) addRadar(secondary_radars_, radar);
  for (const ArrayParams& radar : scenario_.array_radars) addRadar(array_radars_, radar);
  for (const RangeRadarParams& radar : scenario_.range_radars) addRadar(range_radars_, radar);
  plot_counts_.resize(radars_.size());
  secondary_plot_counts_.resize(secondary_radars_.size());
}

template <class Radar, class Params>
void Simulation::addRadar(std::deque<Radar>& radars, const Params& params) {
  radars.emplace_back(params, mapToRadar(scenario_, params), targets_, faultsOf(scenario_, params.name), scenario_.seed,
                      scenario_.start_time);
  skipSilence(radars.back());
}

std::optional<double> Simulation::nextTime() const {
  const double time = std::min({truthTime(), earliestReport(radars_), earliestReport(secondary_radars_),
                                earliestReport(array_radars_), earliestReport(range_radars_)});
  return time <= scenario_.endTime() ? std::optional<double>(time) : std::nullopt;
}

std::variant<SectorReport, SecondarySectorReport, ArrayReport, RangeReport, TruthReport> Simulation::step() {
  const double time = *nextTime();
  if (truthTime() <= time) return takeTruth();
  if (earliestReport(radars_) <= time) return closeEarliest<SectorReport>(radars_, plot_counts_);
  if (earliestReport(secondary_radars_) <= time)
    return closeEarliest<SecondarySectorReport>(secondary_radars_, secondary_plot_counts_);
  if (earliestReport(array_radars_) <= time) return runArray();
  return takeProfile();
}

// The antenna turns on and the sectors count on, but nobody hears of them.
template <class Radar>
void Simulation::skipSilence(Radar& radar) const {
  while (nextReport(radar) <= scenario_.endTime() && radar.isSilentAt(nextReport(radar))) goOn(radar);
}

template <class Report, class Radar>
Report Simulation::closeEarliest(std::deque<Radar>& radars, std::vector<std::uint64_t>& counts) const {
  const std::size_t radar = earliest(radars);
  auto report = closeSector<Report>(radars[radar], counts[radar]);
  report.radar = radar;
  return report;
}

ArrayReport Simulation::runArray() {
  const std::size_t radar = earliest(array_radars_);
  ArrayReport report{radar, array_radars_[radar].runPeriod()};
  skipSilence(array_radars_[radar]);
  return report;
}

RangeReport Simulation::takeProfile() {
  const std::size_t radar = earliest(range_radars_);
  RangeReport report{radar, range_radars_[radar].takeProfile()};
  skipSilence(range_radars_[radar]);
  return report;
}

template <class Report, class Radar>
Report Simulation::closeSector(Radar& radar, std::uint64_t& count) const {
  Report report;
  report.sector = radar.closeSector();
  report.plot_count = count += report.sector.plots.size();
  report.rotation_period = radar.rotationPeriod(runningOf(report.sector) + 1);
  const double mark = markOf(report.sector);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (static_cast<const void*>(&radars_[other]) == &radar || radars_[other].isSilentAt(mark)) continue;
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
    for (const ArrayRadar& radar : array_radars_) {
      const tws::Polar polar = radar.polarOf(targets_[target], truth.time);
      entry.sightings.push_back({polar.range, polar.azimuth, radar.detectionProbability(target, truth.time)});
    }
    truth.entries.push_back(std::move(entry));
  }
  return truth;
}

}  // namespace radar_sim
