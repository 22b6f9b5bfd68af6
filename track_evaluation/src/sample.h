#pragma once

#include <cstddef>
#include <vector>

namespace track_evaluation {

/// Mean, root mean square and percentiles of any number of values, in bounded memory. Mean, root mean square and the
/// largest value are those of all values; the other percentiles, too, up to 65536 values, then those of evenly thinned
/// ones: at least 32768 of them. Without any value all are NaN.
class Sample {
 public:
  void add(double value);

  double mean() const;
  double rootMeanSquare() const;
  /// `percent` in [0, 100], linear between the two nearest values.
  double percentile(double percent) const;

 private:
  void thin();

  std::size_t count_ = 0;
  double sum_ = 0.0, squares_ = 0.0, largest_ = 0.0;
  std::size_t stride_ = 1;  // one in so many values is kept
  std::vector<double> kept_;
};

}  // namespace track_evaluation
