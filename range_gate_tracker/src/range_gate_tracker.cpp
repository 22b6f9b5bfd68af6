#include "range_gate_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace range_gate_tracker {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void require(bool good, const std::string& reason) {
  if (!good) throw std::invalid_argument(reason);
}

std::size_t windowBins(double window, double bin_size) {
  return static_cast<std::size_t>(std::max(1.0, std::round(window / bin_size)));
}

/// Share of the window's power that exceeds what as many bins of the rest of the gate hold, 0 .. 1.
double qualityOf(const WindowReading& reading, const RangeProfile& profile, std::size_t bins) {
  const std::size_t rest = profile.amplitude.size() - bins;
  if (rest == 0 || reading.total_power <= 0.0) return 0.0;
  const double level = reading.rest_power / static_cast<double>(rest) * static_cast<double>(bins);
  return std::max(0.0, 1.0 - level / reading.total_power);
}

}  // namespace

RangeGateTracker::RangeGateTracker(const RangeGateParams& params)
    : params_(params), window_(1, params.background), filter_(makeFilter(params)), search_(params) {}

GateReport RangeGateTracker::process(const RangeProfile& profile) {
  check(profile);
  const std::size_t bins = windowBins(params_.window, profile.bin_size);
  if (bins != window_.bins()) window_ = DetectionWindow(bins, params_.background);
  const WindowReading reading = window_.search(profile, spanToLookAt(profile, bins));
  if (!time_) search_.begin(0.5 * (profile.range_min + profile.rangeMax()), profile.time);
  const double dt = time_ ? profile.time - *time_ : 0.0;
  time_ = profile.time;
  const std::optional<double> measured = measuredRange(reading, profile);
  lock_ == Lock::kSearching ? seek(measured, profile) : follow(measured, dt);
  return report(reading, measured, profile);
}

void RangeGateTracker::check(const RangeProfile& profile) const {
  require(std::isfinite(profile.time), "the time is " + std::to_string(profile.time));
  require(!time_ || profile.time > *time_, "the time is not later than that of the profile before");
  require(std::isfinite(profile.range_min), "range_min is " + std::to_string(profile.range_min));
  require(std::isfinite(profile.bin_size) && profile.bin_size > 0.0,
          "bin_size is " + std::to_string(profile.bin_size) + ", wanted: above 0");
}

BinSpan RangeGateTracker::spanToLookAt(const RangeProfile& profile, std::size_t bins) const {
  if (lock_ == Lock::kSearching || std::isinf(params_.jump_limit)) return {};
  const double dt = profile.time - *time_;
  const double centre = std::visit([dt](const auto& filter) { return filter.expected(dt); }, filter_);
  const double unseen = params_.predictor == Predictor::kKalman ? *time_ - last_seen_ : profile.time - last_seen_;
  const double reach = params_.jump_limit + params_.velocity_limit * unseen;
  const auto firstBin = [&](double range) {
    const double bin = (range - profile.range_min) / profile.bin_size - 0.5 * static_cast<double>(bins);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(profile.amplitude.size())));
  };
  return {firstBin(centre - reach), firstBin(centre + reach)};
}

// The report's threshold. A range outside its own window, which a background of mere noise can lead to, is none either.
std::optional<double> RangeGateTracker::measuredRange(const WindowReading& reading, const RangeProfile& profile) const {
  if (reading.power < params_.threshold || !(reading.power > 0.0)) return std::nullopt;
  const double start = profile.range_min + static_cast<double>(reading.first_bin) * profile.bin_size;
  const double end = start + static_cast<double>(window_.bins()) * profile.bin_size;
  return reading.range >= start && reading.range <= end ? std::optional<double>(reading.range) : std::nullopt;
}

bool RangeGateTracker::agrees(double measured) const {
  const double reach = params_.window + params_.velocity_limit * (*time_ - last_seen_);
  return agreeing_ > 0 && std::abs(measured - last_measured_) <= reach;
}

void RangeGateTracker::note(double measured) {
  agreeing_ = agrees(measured) ? agreeing_ + 1 : 1;
  last_measured_ = measured;
  last_seen_ = *time_;
  if (agreeing_ >= params_.confirming_profiles) last_agreed_ = *time_;
}

// The brightest of mere noise is now here, now there.
void RangeGateTracker::follow(std::optional<double> measured, double dt) {
  if (measured) note(*measured);
  std::visit([&](auto& filter) { measured ? filter.update(*measured, dt) : filter.coast(dt); }, filter_);
  lock_ = measured ? Lock::kLocked : Lock::kCoasting;
  if (*time_ - last_agreed_ <= params_.coast_time) return;
  lock_ = Lock::kSearching;
  agreeing_ = 0;
  search_.begin(std::visit([](const auto& filter) { return filter.range(); }, filter_), last_agreed_);
}

void RangeGateTracker::seek(std::optional<double> measured, const RangeProfile& profile) {
  if (isUnderWay(profile)) return;
  const bool was_candidate = agreeing_ > 0;
  if (!measured || isRefuted(*measured)) {
    agreeing_ = 0;
    return;
  }
  if (!was_candidate) candidate_since_ = *time_;
  note(*measured);
  if (agreeing_ >= params_.confirming_profiles) {
    std::visit([&](auto& filter) { filter.start(*measured); }, filter_);
    lock_ = Lock::kLocked;
  } else if (*time_ - candidate_since_ > params_.sweep_dwell) {
    refute();
  }
}

// The radar follows with a delay: what it had looked at before says nothing about a candidate elsewhere.
bool RangeGateTracker::isUnderWay(const RangeProfile& profile) const {
  const bool looked = last_measured_ >= profile.range_min && last_measured_ <= profile.rangeMax();
  return agreeing_ > 0 && !looked && *time_ - last_seen_ <= params_.sweep_dwell;
}

bool RangeGateTracker::isRefuted(double range) const {
  return *time_ <= refuted_until_ && std::abs(range - refuted_) < params_.gate_length;
}

// Where the noise is above the threshold there is always something; the sweep goes on.
void RangeGateTracker::refute() {
  agreeing_ = 0;
  refuted_ = last_measured_;
  refuted_until_ = *time_ + params_.sweep_dwell;
}

RangeInterval RangeGateTracker::nextGate() const {
  if (lock_ == Lock::kSearching && agreeing_ > 0) return gateAbout(last_measured_, params_.gate_length, params_);
  if (lock_ == Lock::kSearching) return search_.gate(*time_);
  const double centre = std::visit([&](const auto& f) { return f.predicted(params_.prediction_time); }, filter_);
  return gateAbout(centre, lengthAfter(*time_ - last_seen_, params_), params_);
}

GateReport RangeGateTracker::report(const WindowReading& reading, std::optional<double> measured,
                                    const RangeProfile& profile) const {
  GateReport report;
  report.time = profile.time;
  report.lock = lock_;
  report.gate = nextGate();
  report.measured = measured.value_or(kNaN);
  report.power = reading.power;
  report.quality = qualityOf(reading, profile, window_.bins());
  report.smoothed = report.predicted = report.rate = kNaN;
  if (lock_ == Lock::kSearching) return report;
  std::visit(
      [&](const auto& filter) {
        report.smoothed = filter.range();
        report.predicted = filter.predicted(params_.prediction_time);
        report.rate = filter.rate();
      },
      filter_);
  return report;
}

}  // namespace range_gate_tracker
