#include "rotating_radar.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "propagation.h"
#include "radar_equation.h"
#include "range_rates.h"
#include "reported_place.h"

namespace radar_sim {
namespace {

double statedSnr(const Reflection& reflection, double pfa) {
  if (std::isnan(reflection.detection_probability)) return tws::Plot::kUnknown;
  return snrForDetectionProbability(reflection.fluctuation, reflection.detection_probability, pfa);
}

double drawError(double sigma, RandomStream& random) {
  return sigma > 0.0 ? std::normal_distribution<>(0.0, sigma)(random) : 0.0;
}

bool isWithin(const Fault& burst, double azimuth) {
  return tws::wrapTwoPi(azimuth - burst.azimuth_from) < burst.azimuth_to - burst.azimuth_from;
}

}  // namespace

RotatingRadar::RotatingRadar(RadarParams params, const Eigen::Isometry3d& map_to_site,
                             const std::vector<Target>& targets, std::vector<Fault> faults, std::uint64_t seed,
                             double start_time)
    : params_(std::move(params)),
      map_to_site_(map_to_site),
      map_to_antenna_(params_.errors.toAntenna(map_to_site)),
      targets_(targets),
      faults_(std::move(faults)),
      seed_(seed),
      mast_(params_.rotation_period, params_.start_azimuth, params_.time_lsb, start_time, params_.errors),
      crossings_(
          mast_.antenna(), targets,
          [this](std::size_t target, double time) { return polarAtAntenna(target, time).azimuth; }, start_time),
      elevation_searches_(params_),
      clutter_(mast_.antenna(), params_.azimuth_beamwidth, start_time),
      next_false_alarm_sector_(mast_.nextSector()) {
  for (const Target& target : targets) {
    target_streams_.push_back(RandomStream::hash(params_.name + "/" + target.name));
    stated_snr_.push_back(statedSnr(target.reflection, params_.false_alarm_probability));
  }
}

tws::RadarSector RotatingRadar::closeSector() {
  const SectorSpan span = mast_.closeSector();
  tws::RadarSector sector;
  sector.running = span.running;
  sector.sector = static_cast<int>(span.running % tws::kSectors);
  sector.enter_time = span.enter_time;
  sector.leave_time = span.leave_time;
  for (const Echo& echo : takeEchoes(antenna().entryTime(mast_.nextSector())))
    sector.plots.push_back(measure(echo, span));
  return sector;
}

tws::Polar RotatingRadar::polarOf(const Target& target, double time) const {
  return tws::polarFromEnu(map_to_site_ * target.trajectory->at(time).position);
}

double RotatingRadar::rangeRateOf(const Target& target, double time) const {
  const TargetState state = target.trajectory->at(time);
  return radialVelocity(map_to_site_, {state.velocity}, (map_to_site_ * state.position).normalized());
}

tws::Polar RotatingRadar::polarAtAntenna(std::size_t target, double time) const {
  return tws::polarFromEnu(map_to_antenna_ * targets_[target].trajectory->at(time).position);
}

double RotatingRadar::detectionProbability(std::size_t target, double time) const {
  const Target& it = targets_[target];
  if (isBlindAt(time) || !it.trajectory->existsAt(time)) return 0.0;
  const double range = polarOf(it, time).range;
  if (!isInstrumented(range)) return 0.0;
  return radar_sim::detectionProbability(it.reflection.fluctuation, meanSnrOf(target, time, range),
                                         params_.false_alarm_probability);
}

double RotatingRadar::meanSnrOf(std::size_t target, double time, double slant_range) const {
  if (!std::isnan(stated_snr_[target])) return stated_snr_[target];
  const Target& it = targets_[target];
  return meanSnr(params_, it.reflection.rcs, slant_range, it.trajectory->at(time).height);
}

void RotatingRadar::illuminateTargets(double until) {
  while (const auto crossing = crossings_.next(until)) illuminate(crossing->target, crossing->time);
}

void RotatingRadar::illuminate(std::size_t target, double time) {
  const Target& it = targets_[target];
  const tws::Polar polar = polarAtAntenna(target, time);
  if (isBlindAt(time) || !isInstrumented(polar.range)) return;
  const double turns = (antenna().angleAt(time) - polar.azimuth) / tws::kTwoPi;
  RandomStream random(seed_, target_streams_[target], static_cast<std::uint64_t>(std::lround(turns)));
  const double power = drawPower(it.reflection.fluctuation, meanSnrOf(target, time, polar.range), random);
  const auto look = lookInElevation(target, time, polar);
  const bool is_detected = power >= -std::log(params_.false_alarm_probability);
  if (!is_detected && !look) return;
  const double delay = params_.errors.delayOf(params_.antenna_height, it.trajectory->at(time).height, polar.range);
  Echo echo{time, polar.range + delay, polar.azimuth, is_detected ? power : look->power};
  const double snr = echo.power - 1.0;
  if (look) {
    echo.elevation = look->elevation;
    echo.elevation_sigma = look->sigma;
  }
  echo.range_error = drawError(noiseSigma(params_, params_.range_sigma, rangeCell(params_), snr), random) +
                     drawError(it.reflection.jitter, random);
  echo.azimuth_error = drawError(noiseSigma(params_, params_.azimuth_sigma, params_.azimuth_beamwidth, snr), random) +
                       drawError(it.reflection.jitter, random) / polar.range;
  if (params_.measuresRangeRates()) {
    RandomStream own(seed_, params_.name + "/range rate/" + it.name, static_cast<std::uint64_t>(std::lround(turns)));
    echo.range_rate = drawRangeRate(params_, rangeRateOf(it, time), 0.0, own);
  }
  pending_.push_back(echo);
}

std::optional<ElevationLook> RotatingRadar::lookInElevation(std::size_t target, double time,
                                                            const tws::Polar& polar) const {
  const double angle = antenna().angleAt(time);
  const double gain =
      elevation_searches_.gainAt(antenna().measuredAngleAt(time), params_.errors.rangeMeasured(polar.range));
  if (gain <= 0.0) return std::nullopt;
  const Target& it = targets_[target];
  const auto turn = static_cast<std::uint64_t>(std::lround((angle - polar.azimuth) / tws::kTwoPi));
  RandomStream random(seed_, params_.name + "/elevation/" + it.name, turn);
  const double height = it.trajectory->at(time).height;
  const double elevation = std::asin(sineOfElevation(params_.antenna_height, height, polar.range));
  const double snr = std::isnan(stated_snr_[target])
                         ? meanSnr(scanningBeam(params_, elevation), it.reflection.rcs, polar.range, height)
                         : stated_snr_[target];
  // The antenna dips with its axis.
  const double dip = params_.errors.tilt > 0.0 ? polar.elevation - polarOf(it, time).elevation : 0.0;
  return look(params_, it.reflection.fluctuation, gain * snr, elevation + dip, random);
}

std::size_t RotatingRadar::setElevationSearches(const std::vector<ElevationOrder>& orders) {
  const std::int64_t north = mast_.nextSector() + 1;
  return elevation_searches_.set(orders, static_cast<double>(north) * tws::kSectorWidth);
}

void RotatingRadar::addClutter(const std::shared_ptr<const ClutterSpec>& clutter) {
  clutter_.add(clutter, clutter->seenBy({params_, map_to_site_, seed_}));
}

void RotatingRadar::raiseClutter(double until) {
  std::vector<Echo> echoes;
  clutter_.raise(until, echoes);
  const auto isSeen = [this](const Echo& echo) { return isInstrumented(echo.range) && !isBlindAt(echo.time); };
  std::copy_if(echoes.begin(), echoes.end(), std::back_inserter(pending_), isSeen);
}

void RotatingRadar::raiseFalseAlarms(double until) {
  for (; antenna().entryTime(next_false_alarm_sector_) < until; ++next_false_alarm_sector_) {
    drawFalseAlarms(next_false_alarm_sector_, params_.false_alarms_per_scan, nullptr, "/false alarms");
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      const Fault& fault = faults_[i];
      if (fault.kind != FaultKind::kFalseAlarmBurst) continue;
      drawFalseAlarms(next_false_alarm_sector_, fault.false_alarms_per_scan, &fault, "/burst/" + std::to_string(i));
    }
  }
}

void RotatingRadar::drawFalseAlarms(std::int64_t sector, double per_scan, const Fault* burst,
                                    const std::string& stream) {
  const double enter = antenna().entryTime(sector);
  const double leave = antenna().entryTime(sector + 1);
  const double mean = per_scan * (leave - enter) / params_.rotation_period;
  if (mean <= 0.0) return;
  RandomStream random(seed_, params_.name + stream, static_cast<std::uint64_t>(sector));
  RandomStream rates(seed_, params_.name + stream + "/range rate", static_cast<std::uint64_t>(sector));
  const double exponent = params_.false_alarms_by_area ? 2.0 : 1.0;
  std::uniform_real_distribution<> when(enter, leave);
  std::uniform_real_distribution<> how_far(std::pow(params_.min_range, exponent),
                                           std::pow(params_.max_range, exponent));
  std::exponential_distribution<> above_threshold(1.0);  // noise power, given that it exceeds the threshold
  for (int left = std::poisson_distribution<>(mean)(random); left > 0; --left) {
    const double time = when(random);
    const double range = std::pow(how_far(random), 1.0 / exponent);
    const double power = above_threshold(random) - std::log(params_.false_alarm_probability);
    const double azimuth = antenna().azimuthAt(time);
    if (isBlindAt(time) || (burst != nullptr && !(burst->isActiveAt(time) && isWithin(*burst, azimuth)))) continue;
    pending_.push_back({time, range, azimuth, power});
    if (params_.measuresRangeRates()) pending_.back().range_rate = drawFalseRangeRate(params_, rates);
  }
}

// Cells that begin in this sector may end in the next one, and their centre of power may lie there.
std::vector<Echo> RotatingRadar::takeEchoes(double until) {
  const double complete = until + params_.azimuth_beamwidth / antenna().rate();
  illuminateTargets(complete);
  raiseFalseAlarms(complete);
  raiseClutter(complete);
  const auto isEarlier = [](const Echo& a, const Echo& b) { return a.time < b.time; };
  std::stable_sort(pending_.begin(), pending_.end(), isEarlier);
  const auto fresh = resolve(pending_, until, rangeCell(params_), params_.azimuth_beamwidth);
  resolved_.insert(resolved_.end(), fresh.begin(), fresh.end());
  std::stable_sort(resolved_.begin(), resolved_.end(), isEarlier);
  const auto isDue = [until](const Echo& echo) { return echo.time < until; };
  const auto due = std::partition_point(resolved_.begin(), resolved_.end(), isDue);
  std::vector<Echo> echoes(resolved_.begin(), due);
  resolved_.erase(resolved_.begin(), due);
  return echoes;
}

tws::Plot RotatingRadar::measure(const Echo& echo, const SectorSpan& sector) const {
  const double snr = echo.power - 1.0;
  tws::Plot plot;
  plot.time = mast_.stampWithin(sector, echo.time);
  const ReportedPlace place(params_.errors.rangeMeasured(echo.range) + echo.range_error,
                            antenna().measured(echo.azimuth, echo.time) + echo.azimuth_error, params_.range_lsb,
                            params_.azimuth_lsb);
  plot.range = place.range;
  plot.azimuth = place.azimuth;
  plot.range_sigma = noiseSigma(params_, params_.range_sigma, rangeCell(params_), snr);
  plot.azimuth_sigma = noiseSigma(params_, params_.azimuth_sigma, params_.azimuth_beamwidth, snr);
  plot.elevation = echo.elevation;
  plot.elevation_sigma = echo.elevation_sigma;
  plot.range_rate = echo.range_rate;
  plot.snr = 10.0 * std::log10(snr);
  return plot;
}

}  // namespace radar_sim
