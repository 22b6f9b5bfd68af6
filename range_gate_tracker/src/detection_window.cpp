#include "detection_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace range_gate_tracker {
namespace {

double squared(float amplitude) { return static_cast<double>(amplitude) * static_cast<double>(amplitude); }

/// sums[r]: the power in all bins before r. Four bins at a time, so that additions need not wait for each other.
void runningSums(const std::vector<float>& amplitude, std::vector<double>& sums) {
  const std::size_t n = amplitude.size();
  sums.resize(n + 1);
  const float* a = amplitude.data();
  double* out = sums.data();
  double before = out[0] = 0.0;
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    const double one = squared(a[i]), two = one + squared(a[i + 1]);
    const double third = squared(a[i + 2]), last_two = third + squared(a[i + 3]);
    out[i + 1] = before + one;
    out[i + 2] = before + two;
    out[i + 3] = before + (two + third);
    out[i + 4] = before += two + last_two;
  }
  for (; i < n; ++i) out[i + 1] = before += squared(a[i]);
}

/// A plain loop over one running maximum cannot be vectorised without -ffast-math; over eight it can.
double greatest(const std::vector<double>& values) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> most;
  most.fill(-std::numeric_limits<double>::infinity());
  const double* v = values.data();
  std::size_t i = 0;
  for (; i + kLanes <= values.size(); i += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) most[k] = v[i + k] > most[k] ? v[i + k] : most[k];
  for (; i < values.size(); ++i) most[0] = std::max(most[0], v[i]);
  return *std::max_element(most.begin(), most.end());
}

std::string badBin(const std::vector<float>& amplitude) {
  for (std::size_t i = 0; i < amplitude.size(); ++i)
    if (!std::isfinite(amplitude[i]))
      return "amplitude of bin " + std::to_string(i) + " is " + std::to_string(amplitude[i]);
  return "the amplitudes are too large";
}

}  // namespace

DetectionWindow::DetectionWindow(std::size_t bins, Background background) : bins_(bins), background_(background) {
  if (bins == 0) throw std::invalid_argument("a detection window has at least one bin");
}

WindowReading DetectionWindow::search(const RangeProfile& profile, BinSpan span) {
  profile_bins_ = profile.amplitude.size();
  if (bins_ > profile_bins_)
    throw std::invalid_argument("the detection window of " + std::to_string(bins_) +
                                " bins is larger than the gate of " + std::to_string(profile_bins_));
  runningSums(profile.amplitude, power_sums_);
  if (!std::isfinite(power_sums_.back())) throw std::invalid_argument(badBin(profile.amplitude));
  span.last = std::min(span.last, profile_bins_ - bins_);
  span.first = std::min(span.first, span.last);
  WindowReading reading;
  reading.first_bin = brightestWindow(span);
  reading.total_power = sum(reading.first_bin, reading.first_bin + bins_);
  reading.rest_power = power_sums_.back() - reading.total_power;
  const double background = backgroundAt(reading.first_bin);
  reading.power = reading.total_power - background;
  reading.range = reading.power > 0.0
                      ? profile.range_min + momentAbove(profile, reading.first_bin, background) / reading.power
                      : std::numeric_limits<double>::quiet_NaN();
  return reading;
}

// B0: eq. (3), rescaled at the ends.
double DetectionWindow::backgroundAt(std::size_t window) const {
  const double s = static_cast<double>(bins_);
  if (background_ == Background::kNone) return 0.0;
  if (background_ == Background::kGlobal) return s * power_sums_.back() / static_cast<double>(profile_bins_);
  const std::size_t left = window - std::min(window, bins_);
  const std::size_t right = std::min(profile_bins_, window + 2 * bins_);
  const std::size_t neighbours = right - left - bins_;
  if (neighbours == 0) return 0.0;
  const double beside = sum(left, window) + sum(window + bins_, right);
  return neighbours == 2 * bins_ ? 0.5 * beside : beside * s / static_cast<double>(neighbours);
}

std::size_t DetectionWindow::brightestWindow(BinSpan span) {
  net_power_.resize(span.last - span.first + 1);
  if (background_ == Background::kLocal) {
    addLocal(span);
  } else {  // a background that is the same everywhere moves no maximum
    const double* from = power_sums_.data() + span.first;
    const double* to = from + bins_;
    for (std::size_t i = 0; i < net_power_.size(); ++i) net_power_[i] = to[i] - from[i];
  }
  const auto found = std::find(net_power_.begin(), net_power_.end(), greatest(net_power_));
  return span.first + static_cast<std::size_t>(found - net_power_.begin());
}

// S0 = C0 - B0, eq. (5). Where both neighbours are whole, C0 - (all three - C0) / 2.
void DetectionWindow::addLocal(BinSpan span) {
  const std::size_t whole_end = profile_bins_ >= 2 * bins_ ? profile_bins_ - 2 * bins_ + 1 : 0;
  const std::size_t begin = std::min(std::max(span.first, bins_), span.last + 1);
  const std::size_t end = std::max(begin, std::min(span.last + 1, whole_end));
  const double* p = power_sums_.data();
  double* net = net_power_.data();
  const std::size_t s = bins_, offset = span.first;
  for (std::size_t r = begin; r < end; ++r) net[r - offset] = 1.5 * (p[r + s] - p[r]) - 0.5 * (p[r + 2 * s] - p[r - s]);
  const auto atAnEnd = [&](std::size_t r) { net[r - offset] = sum(r, r + s) - backgroundAt(r); };
  for (std::size_t r = span.first; r < begin; ++r) atAnEnd(r);
  for (std::size_t r = end; r <= span.last; ++r) atAnEnd(r);
}

// S1 = C1 - B1, eqs. (2), (4), (6), of ranges from the start of the profile.
double DetectionWindow::momentAbove(const RangeProfile& profile, std::size_t window, double background) const {
  const auto moment = [&](std::size_t from, std::size_t to) {
    double total = 0.0;
    for (std::size_t r = from; r < to; ++r) total += squared(profile.amplitude[r]) * (static_cast<double>(r) + 0.5);
    return total * profile.bin_size;
  };
  const std::size_t end = window + bins_;
  const double own = moment(window, end);
  const bool whole = window >= bins_ && end + bins_ <= profile_bins_;
  if (background_ == Background::kLocal && whole)
    return own - 0.5 * (moment(window - bins_, window) + moment(end, end + bins_));
  const double centre = (static_cast<double>(window) + 0.5 * static_cast<double>(bins_)) * profile.bin_size;
  return own - background * centre;
}

}  // namespace range_gate_tracker
