#include "sample.h"

#include <algorithm>
#include <cmath>

#include "metric_list.h"

namespace track_evaluation {
namespace {

constexpr std::size_t kMostKept = 65536;  // even

}  // namespace

void Moments::add(double value) {
  ++count_;
  sum_ += value;
  squares_ += value * value;
}

double Moments::mean() const { return ratio(sum_, static_cast<double>(count_)); }
double Moments::rootMeanSquare() const { return std::sqrt(ratio(squares_, static_cast<double>(count_))); }

void Sample::add(double value) {
  largest_ = moments_.count() == 0 ? value : std::max(largest_, value);
  if (moments_.count() % stride_ == 0 && kept_.size() == kMostKept) thin();
  if (moments_.count() % stride_ == 0) kept_.push_back(value);
  moments_.add(value);
}

void Sample::thin() {
  for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
  kept_.resize(kept_.size() / 2);
  stride_ *= 2;
}

double Sample::percentile(double percent) const {
  return percent >= 100.0 && moments_.count() > 0 ? largest_ : track_evaluation::percentile(kept_, percent);
}

}  // namespace track_evaluation
