#include "metric_list.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace track_evaluation {

double ratio(double sum, double count) { return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN(); }

double rootMeanSquare(const std::vector<double>& values) {
  return std::sqrt(
      ratio(std::inner_product(values.begin(), values.end(), values.begin(), 0.0), static_cast<double>(values.size())));
}

double percentile(std::vector<double> values, double percent) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto lower = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), lower, values.end());
  if (below + 1 == values.size()) return *lower;
  const double upper = *std::min_element(lower + 1, values.end());
  return *lower + (place - static_cast<double>(below)) * (upper - *lower);
}

}  // namespace track_evaluation
