#pragma once

#include <cstddef>
#include <vector>

namespace track_evaluation {

/// Mean and root mean square of any number of values; NaN without any.
class Moments {
 public:
  void add(double value);

  std::size_t count() const { return count_; }
  double mean() const;
  double rootMeanSquare() const;

 private:
  std::size_t count_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
};

/// The same, and percentiles, in bounded memory. The percentiles are those of all values up to 65536 of them, then
/// those of evenly thinned ones: at least 32768. The largest value is always that of all.
class Sample {
 public:
  void add(double value);

  double rootMeanSquare() const { return moments_.rootMeanSquare(); }
  /// `percent` in [0, 100], linear between the two nearest values.
  double percentile(double percent) const;

 private:
  void thin();

  Moments moments_;
  double largest_ = 0.0;
  std::size_t stride_ = 1;  // one in so many values is kept
  std::vector<double> kept_;
};

}  // namespace track_evaluation
