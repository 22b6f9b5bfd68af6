#include "sample.h"

#include <algorithm>
#include <cmath>

#include "metric_list.h"

namespace track_evaluation {
namespace {

constexpr std::size_t kMostKept = 65536;

}  // namespace

void Sample::add(double value) {
  largest_ = count_ == 0 ? value : std::max(largest_, value);
  sum_ += value;
  squares_ += value * value;
  if (count_++ % stride_ == 0) kept_.push_back(value);
  if (kept_.size() > kMostKept) thin();
}

void Sample::thin() {
  for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
  kept_.resize((kept_.size() + 1) / 2);
  stride_ *= 2;
}

double Sample::mean() const { return ratio(sum_, static_cast<double>(count_)); }
double Sample::rootMeanSquare() const { return std::sqrt(ratio(squares_, static_cast<double>(count_))); }

double Sample::percentile(double percent) const {
  return percent >= 100.0 && count_ > 0 ? largest_ : track_evaluation::percentile(kept_, percent);
}

}  // namespace track_evaluation
