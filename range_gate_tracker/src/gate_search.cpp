#include "gate_search.h"

#include <algorithm>
#include <cmath>

namespace range_gate_tracker {

RangeInterval gateAbout(double centre, double length, const RangeGateParams& params) {
  const double fitting = std::min(length, params.max_range - params.min_range);
  const double min = std::clamp(centre - 0.5 * fitting, params.min_range, params.max_range - fitting);
  return {min, min + fitting};
}

double lengthAfter(double unseen, const RangeGateParams& params) {
  return std::min(params.gate_length + 2.0 * params.velocity_limit * std::max(0.0, unseen), params.widest_gate);
}

void GateSearch::begin(double range, double time) {
  range_ = range;
  since_ = time;
  sweep_from_ = time + params_.widening_time;
  makePlaces(range);
}

RangeInterval GateSearch::gate(double time) const {
  if (time < sweep_from_) return gateAbout(range_, lengthAfter(time - since_, params_), params_);
  const auto turn = static_cast<std::size_t>((time - sweep_from_) / params_.sweep_dwell);
  return gateAbout(centres_[turn % centres_.size()], params_.gate_length, params_);
}

void GateSearch::makePlaces(double range) {
  const double nearest = gateAbout(params_.min_range, params_.gate_length, params_).centre();
  const double farthest = gateAbout(params_.max_range, params_.gate_length, params_).centre();
  const double step = std::max(params_.gate_length - params_.window, 0.5 * params_.gate_length);
  const double first = std::clamp(range, nearest, farthest);
  centres_ = {first};
  for (double out = step; first - out > nearest - step || first + out < farthest + step; out += step) {
    if (first + out < farthest + step) centres_.push_back(std::min(first + out, farthest));
    if (first - out > nearest - step) centres_.push_back(std::max(first - out, nearest));
  }
}

}  // namespace range_gate_tracker
