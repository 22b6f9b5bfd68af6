#include "array_radar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <tws_core/angles.h>

#include "propagation.h"

namespace radar_sim {
namespace {

BeamPoint directionOf(const tws::Ruv& place) { return {place.u, place.v}; }

double normal(RandomStream& random, double sigma) { return std::normal_distribution<>(0.0, sigma)(random); }

double uniform(RandomStream& random, double least, double greatest) {
  return std::uniform_real_distribution<>(least, greatest)(random);
}

double statedSnr(const Target& target, double pfa) {
  const Reflection& reflection = target.reflection;
  if (std::isnan(reflection.detection_probability)) return std::numeric_limits<double>::quiet_NaN();
  return snrForDetectionProbability(reflection.fluctuation, reflection.detection_probability, pfa);
}

}  // namespace

ArrayRadar::ArrayRadar(ArrayParams params, const Eigen::Isometry3d& map_to_array, const std::vector<Target>& targets,
                       std::vector<Fault> faults, std::uint64_t seed, double start_time)
    : params_(std::move(params)),
      map_to_array_(map_to_array),
      targets_(targets),
      faults_(std::move(faults)),
      seed_(seed),
      start_time_(start_time),
      manager_(params_) {
  for (const Target& target : targets_) {
    target_streams_.push_back(RandomStream::hash(params_.name + "/" + target.name));
    noise_streams_.push_back(RandomStream::hash(params_.name + "/" + target.name + "/noise"));
    stated_snr_.push_back(statedSnr(target, params_.false_alarm_probability));
  }
}

ResourcePeriod ArrayRadar::runPeriod() {
  const double begin = planTime();
  const std::vector<SteerableTrack> tracks = steerable(begin + params_.resource_period / 2.0);
  ResourcePeriod period{next_period_, nextReport(), nextExpectedDwell(tracks, nextReport()), {}};
  for (PlannedDwell& plan : manager_.plan(begin, tracks)) {
    const double time = begin + (static_cast<double>(period.dwells.size()) + 0.5) * params_.dwell_time;
    period.dwells.push_back({std::move(plan), time, dwells_++, {}});
    if (!isBlindAt(time)) measure(period.dwells.back());
  }
  ++next_period_;
  return period;
}

tws::Ruv ArrayRadar::placeOf(const Target& target, double time) const {
  return tws::ruvFromArray(map_to_array_ * target.trajectory->at(time).position);
}

tws::Polar ArrayRadar::polarOf(const Target& target, double time) const {
  const Eigen::Vector3d place = map_to_array_ * target.trajectory->at(time).position;
  return tws::polarFromEnu(tws::enuFromArrayRotation(params_.azimuth, params_.tilt) * place);
}

double ArrayRadar::detectionProbability(std::size_t target, double time) const {
  const Target& it = targets_[target];
  if (isBlindAt(time) || !it.trajectory->existsAt(time)) return 0.0;
  const tws::Ruv place = placeOf(it, time);
  if (!isInReach(it, place, time) || !isSearched(directionOf(place))) return 0.0;
  return radar_sim::detectionProbability(it.reflection.fluctuation, meanSnr(target, directionOf(place), place),
                                         params_.false_alarm_probability);
}

bool ArrayRadar::isSearched(const BeamPoint& direction) const {
  return canSteer(params_, direction) && direction.u >= params_.search_u_from && direction.u <= params_.search_u_to &&
         direction.v >= params_.search_v_from && direction.v <= params_.search_v_to;
}

bool ArrayRadar::isInReach(const Target& target, const tws::Ruv& place, double time) const {
  const TargetState state = target.trajectory->at(time);
  return place.range >= params_.min_range && place.range <= params_.max_range &&
         (map_to_array_ * state.position).x() > 0.0 &&
         !isBeyondHorizon(params_.antenna_height, state.height, place.range);
}

std::vector<SteerableTrack> ArrayRadar::steerable(double time) const {
  std::vector<SteerableTrack> steerable;
  for (const ArrayTrack& track : tracks_) {
    const Eigen::Vector3d place = map_to_array_ * (track.position + (time - track.time) * track.velocity);
    const BeamPoint direction = directionOf(tws::ruvFromArray(place));
    if (!(place.x() > 0.0) || !canSteer(params_, direction)) continue;
    const double revisit = std::isnan(track.revisit) ? params_.revisit_interval : track.revisit;
    steerable.push_back({track.number, direction, track.last_update, track.priority, revisit});
  }
  return steerable;
}

double ArrayRadar::meanSnr(std::size_t target, const BeamPoint& beam, const tws::Ruv& place) const {
  if (std::isnan(stated_snr_[target]))
    return arraySnr(params_, beam, directionOf(place), place.range, targets_[target].reflection.rcs);
  const double apart = beamwidthsApart(params_, beam, directionOf(place));
  const double shape = beamGain(params_, beam, directionOf(place));
  return apart > 1.0 ? 0.0 : stated_snr_[target] * shape * shape;
}

std::vector<ArrayRadar::Echo> ArrayRadar::echoes(const ArrayDwell& dwell) const {
  std::vector<Echo> echoes;
  for (std::size_t target = 0; target < targets_.size(); ++target) {
    const Target& it = targets_[target];
    if (!it.trajectory->existsAt(dwell.time)) continue;
    const tws::Ruv place = placeOf(it, dwell.time);
    const double mean = meanSnr(target, dwell.plan.beam, place);
    if (mean <= 0.0 || !isInReach(it, place, dwell.time)) continue;
    RandomStream random(seed_, target_streams_[target], next_period_);
    echoes.push_back({place, drawSignalPower(it.reflection.fluctuation, mean, random), target});
  }
  std::sort(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) { return a.place.range < b.place.range; });
  return echoes;
}

ArrayRadar::Echo ArrayRadar::merged(std::vector<Echo>::const_iterator first, std::vector<Echo>::const_iterator last) {
  Echo merged = *first;
  for (auto echo = first + 1; echo != last; ++echo) {
    merged.power += echo->power;
    const double weight = merged.power > 0.0 ? echo->power / merged.power : 0.0;
    merged.place.range += weight * (echo->place.range - merged.place.range);
    merged.place.u += weight * (echo->place.u - merged.place.u);
    merged.place.v += weight * (echo->place.v - merged.place.v);
  }
  return merged;
}

void ArrayRadar::measure(ArrayDwell& dwell) const {
  const double threshold = -std::log(params_.false_alarm_probability);
  const std::vector<Echo> all = echoes(dwell);
  for (auto first = all.begin(); first != all.end();) {
    const auto isBeyond = [&](const Echo& echo) { return echo.place.range - first->place.range >= params_.range_cell; };
    const auto last = std::find_if(first, all.end(), isBeyond);
    Echo echo = merged(first, last);
    first = last;
    RandomStream random(seed_, noise_streams_[echo.target], dwell.number);
    echo.power = addNoise(echo.power, random);
    if (echo.power > threshold) dwell.measurements.push_back(measured(echo, dwell.plan.beam, random));
  }
  drawFalseAlarms(dwell);
  std::sort(dwell.measurements.begin(), dwell.measurements.end(),
            [](const auto& a, const auto& b) { return a.place.range < b.place.range; });
}

void ArrayRadar::drawFalseAlarms(ArrayDwell& dwell) const {
  const BeamPoint& beam = dwell.plan.beam;
  RandomStream random(seed_, params_.name + "/false alarms", dwell.number);
  const int count =
      params_.false_alarms_per_dwell > 0.0 ? std::poisson_distribution<>(params_.false_alarms_per_dwell)(random) : 0;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.5 * std::sqrt(uniform(random, 0.0, 1.0)), turn = uniform(random, 0.0, tws::kTwoPi);
    const double excess = std::exponential_distribution<>(1.0)(random);
    const Echo echo{
        {uniform(random, params_.min_range, params_.max_range), beam.u + params_.beamwidth_u * radius * std::cos(turn),
         beam.v + params_.beamwidth_v * radius * std::sin(turn)},
        excess - std::log(params_.false_alarm_probability),
        targets_.size()};
    dwell.measurements.push_back(measured(echo, beam, random));
  }
}

ArrayMeasurement ArrayRadar::measured(const Echo& echo, const BeamPoint& beam, RandomStream& random) const {
  const double sigma_range = arraySigma(params_.range_sigma_floor, params_.range_cell, echo.power);
  const double sigma_u = arraySigma(params_.angle_sigma_floor, params_.beamwidth_u, echo.power);
  const double sigma_v = arraySigma(params_.angle_sigma_floor, params_.beamwidth_v, echo.power);
  ArrayMeasurement measurement;
  measurement.place.range = std::max(echo.place.range + normal(random, sigma_range), 1.0);
  measurement.place.u = std::clamp(echo.place.u + normal(random, sigma_u), -1.0, 1.0);
  measurement.place.v = std::clamp(echo.place.v + normal(random, sigma_v), -1.0, 1.0);
  measurement.covariance =
      Eigen::Vector3d(sigma_range * sigma_range, sigma_u * sigma_u, sigma_v * sigma_v).asDiagonal();
  measurement.snr = echo.power;
  measurement.rcs = echo.power / arraySnr(params_, beam, beam, measurement.place.range, 1.0);
  return measurement;
}

}  // namespace radar_sim
