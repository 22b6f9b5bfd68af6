#pragma once

#include <string>
#include <utility>
#include <vector>

namespace track_evaluation {

/// Names and values in the order of a report. A value that is not defined for a run is NaN. doc/metrics.md defines the
/// names.
using MetricList = std::vector<std::pair<std::string, double>>;

/// Sum over count; NaN without any.
double ratio(double sum, double count);
double rootMeanSquare(const std::vector<double>& values);
/// Percentile in [0, 100], linear between the two nearest values; NaN without any.
double percentile(std::vector<double> values, double percent);

}  // namespace track_evaluation
