#include "open_frame.h"

#include <algorithm>
#include <iterator>

namespace esa_frame_builder {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices unionOf(const Indices& a, const Indices& b) {
  Indices all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

// (31)
std::size_t countCommon(const Indices& a, const Indices& b) {
  Indices common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size();
}

}  // namespace

void OpenFrame::add(SpannedDwell dwell) {
  start_time_ = std::min(start_time_, dwell.dwell.time);
  least_range_ = std::min(least_range_, dwell.span.least);
  widest_ = std::max(widest_, footprintRadius(dwell.dwell, *params_));
  if (!dwell.dwell.group_indices.empty()) group_indices_ = unionOf(group_indices_, dwell.dwell.group_indices);
  dwells_.push_back(std::move(dwell));
}

double OpenFrame::greatestAngularRate() const { return params_->max_speed / least_range_; }

double OpenFrame::beamPointAllowance(double resource_period) const {
  const double least = params_->least_allowance_periods * resource_period;
  const double greatest = params_->greatest_allowance_periods * resource_period;
  const double rate = greatestAngularRate();
  const double allowance = rate > 0.0 ? widest_ / rate : greatest;  // (25)
  return std::max(std::min(allowance, greatest), least);            // (27)
}

bool OpenFrame::beamPointTestRejects(const SpannedDwell& dwell) const {
  return std::any_of(dwells_.begin(), dwells_.end(), [&](const SpannedDwell& other) {
    return esa_frame_builder::beamPointTestRejects(dwell, other, *params_);
  });
}

bool OpenFrame::dwellGroupTestRejects(const Dwell& dwell) const {
  const std::size_t common = countCommon(group_indices_, dwell.group_indices);
  if (params_->strict_group_rule || common == 0) return common > 0;
  return static_cast<double>(common) >= params_->group_ratio * static_cast<double>(group_indices_.size());
}

bool OpenFrame::mayShareTargets(const SpannedDwell& dwell) const {
  return std::any_of(dwells_.begin(), dwells_.end(), [&](const SpannedDwell& other) {
    return esa_frame_builder::mayShareTargets(dwell, other, *params_);
  });
}

}  // namespace esa_frame_builder
