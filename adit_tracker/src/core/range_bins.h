#pragma once

#include <algorithm>
#include <cmath>

namespace adit_tracker {

/// The ranges that a radar covers, cut into bins of one depth. Whoever learns of a range beyond them doubles the depth:
/// two bins become one, and hold what both held.
class RangeBins {
 public:
  static constexpr int kBins = 64;
  static constexpr double kLeastReach = 10e3;  // [m]

  RangeBins() = default;
  /// `depth`: one that these bins can have.
  explicit RangeBins(double depth) : depth_(depth) {}
  /// Can a bin be so deep [m]? Doubled ten times, all reach beyond 10 000 km.
  static bool isDepth(double depth) {
    const double ratio = std::log2(depth / (kLeastReach / kBins));
    return ratio >= 0.0 && ratio <= 10.0 && ratio == std::floor(ratio);
  }

  /// Of a bin [m].
  double depth() const { return depth_; }
  /// Where the last bin ends [m].
  double reach() const { return kBins * depth_; }
  /// The bin of a range [m]; kBins: it lies beyond them.
  int binOf(double range) const {
    return static_cast<int>(std::clamp(range / depth_, 0.0, static_cast<double>(kBins)));
  }
  /// The caller sums up what its bins hold.
  void doubleDepth() { depth_ *= 2.0; }

  /// Of each two of kBins values, their sum; the second half begins anew. A Value has +=, and begins as zero.
  template <class Value>
  static void sumUp(Value* bins) {
    for (int bin = 0; bin < kBins; ++bin) {
      Value sum{};
      for (int half = 2 * bin; half < std::min(2 * bin + 2, kBins); ++half) sum += bins[half];
      bins[bin] = sum;
    }
  }

 private:
  double depth_ = kLeastReach / kBins;
};

}  // namespace adit_tracker
