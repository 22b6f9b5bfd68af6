#include "selection.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace esa_frame_builder {
namespace {

constexpr std::size_t kWordBits = 64;

double distance(double u, double v) { return std::sqrt(u * u + v * v); }

// √(G0·tr R) of (7), R the covariance of (u, v).
double errorOf(const Measurement& measurement, const FrameBuilderParams& params) {
  return std::sqrt(params.angle_gate_chi2 * (measurement.covariance(1, 1) + measurement.covariance(2, 2)));
}

/// A measurement and the set of the dwells that contain it.
struct Placed {
  std::uint32_t dwell;
  std::uint32_t index;  // within its dwell
  std::size_t set;      // where its set begins
};

/// The region of every measurement of a frame. A set is a row of bits, one a dwell.
class Regions {
 public:
  Regions(const OpenFrame& frame, const FrameBuilderParams& params)
      : frame_(frame), params_(params), words_((frame.dwells().size() + kWordBits - 1) / kWordBits) {
    for (std::size_t k = 0; k < frame.dwells().size(); ++k) place(k);
    std::sort(placed_.begin(), placed_.end(), [this](const Placed& a, const Placed& b) { return isBefore(a, b); });
  }

  /// Measurements in several dwells, region by region, in each dwell by dwell.
  const std::vector<Placed>& shared() const { return placed_; }
  bool sameRegion(const Placed& a, const Placed& b) const {
    return std::equal(bits_.begin() + offset(a), bits_.begin() + offset(a) + offsetOf(words_),
                      bits_.begin() + offset(b));
  }

 private:
  static std::ptrdiff_t offsetOf(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }
  static std::ptrdiff_t offset(const Placed& placed) { return offsetOf(placed.set); }

  void place(std::size_t k) {
    const Dwell& dwell = frame_.dwells()[k].dwell;
    if (dwell.measurements.empty()) return;
    const double rate = frame_.greatestAngularRate(), reach = reachOf(dwell);
    neighbours_.clear();
    for (std::size_t n = 0; n < frame_.dwells().size(); ++n)
      if (n != k && mayContain(frame_.dwells()[n].dwell, dwell, reach, rate)) neighbours_.push_back(n);
    if (neighbours_.empty()) return;
    for (std::size_t i = 0; i < dwell.measurements.size(); ++i) placeOne(k, i, rate);
  }

  /// No measurement of the dwell, its error included, lies further than this from the beam point.
  double reachOf(const Dwell& dwell) const {
    double reach = 0.0;
    for (const Measurement& m : dwell.measurements)
      reach = std::max(reach, distance(m.u - dwell.u, m.v - dwell.v) + errorOf(m, params_));
    return reach;
  }

  /// False: (7) fails for all measurements of dwell k.
  bool mayContain(const Dwell& n, const Dwell& k, double reach, double rate) const {
    return distance(k.u - n.u, k.v - n.v) < reach + footprintRadius(n, params_) + rate * std::abs(k.time - n.time);
  }

  void placeOne(std::size_t k, std::size_t i, double rate) {
    const std::size_t set = bits_.size();
    bits_.resize(set + words_, 0);
    const Dwell& dwell = frame_.dwells()[k].dwell;
    bool shared = false;
    for (std::size_t n : neighbours_) {
      if (!isInFootprint(dwell.measurements[i], dwell, frame_.dwells()[n].dwell, rate, params_)) continue;
      bits_[set + n / kWordBits] |= std::uint64_t{1} << (n % kWordBits);
      shared = true;
    }
    if (!shared) return bits_.resize(set);
    bits_[set + k / kWordBits] |= std::uint64_t{1} << (k % kWordBits);
    placed_.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i), set});
  }

  bool isBefore(const Placed& a, const Placed& b) const {
    for (std::size_t word = 0; word < words_; ++word)
      if (bits_[a.set + word] != bits_[b.set + word]) return bits_[a.set + word] < bits_[b.set + word];
    return std::tie(a.dwell, a.index) < std::tie(b.dwell, b.index);
  }

  const OpenFrame& frame_;
  const FrameBuilderParams& params_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
  std::vector<Placed> placed_;
  std::vector<std::size_t> neighbours_;
};

/// What one dwell has in a region.
struct Share {
  std::size_t first, end;  // of the region's measurements
  double snr;
};

// The select operator of (18), (21), (22).
bool isBetter(const Share& a, const Share& b) {
  const std::size_t count_a = a.end - a.first, count_b = b.end - b.first;
  return count_a != count_b ? count_a > count_b : a.snr > b.snr;
}

using Kept = std::vector<std::vector<bool>>;  // by dwell and measurement

/// Selects within the region that begins at `first`; returns where the next one begins.
std::size_t selectInRegion(const OpenFrame& frame, const Regions& regions, std::size_t first, Kept& kept) {
  const std::vector<Placed>& shared = regions.shared();
  Share best{first, first, 0.0};
  std::size_t end = first;
  while (end < shared.size() && regions.sameRegion(shared[first], shared[end])) {
    Share share{end, end, 0.0};
    const std::uint32_t k = shared[end].dwell;
    for (; share.end < shared.size() && shared[share.end].dwell == k &&
           regions.sameRegion(shared[first], shared[share.end]);
         ++share.end)
      share.snr += frame.dwells()[k].dwell.measurements[shared[share.end].index].snr;
    if (isBetter(share, best)) best = share;
    end = share.end;
  }
  for (std::size_t i = first; i < end; ++i) kept[shared[i].dwell][shared[i].index] = i >= best.first && i < best.end;
  return end;
}

Dwell keptOf(const Dwell& dwell, const std::vector<bool>& kept) {
  Dwell result = dwell;
  result.measurements.clear();
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) result.measurements.push_back(dwell.measurements[i]);
  return result;
}

}  // namespace

bool isInFootprint(const Measurement& measurement, const Dwell& k, const Dwell& n, double angular_rate,
                   const FrameBuilderParams& params) {
  if (&k == &n) return true;
  return distance(measurement.u - n.u, measurement.v - n.v) <
         footprintRadius(n, params) + angular_rate * std::abs(k.time - n.time) + errorOf(measurement, params);
}

Frame selected(const OpenFrame& open, const FrameBuilderParams& params) {
  Kept kept;
  for (const SpannedDwell& dwell : open.dwells()) kept.emplace_back(dwell.dwell.measurements.size(), true);
  const Regions regions(open, params);
  for (std::size_t next = 0; next < regions.shared().size();) next = selectInRegion(open, regions, next, kept);
  Frame frame;
  frame.number = open.number();
  for (std::size_t k = 0; k < kept.size(); ++k) {
    frame.dwells.push_back(keptOf(open.dwells()[k].dwell, kept[k]));
    frame.discarded += kept[k].size() - frame.dwells.back().measurements.size();
  }
  return frame;
}

}  // namespace esa_frame_builder
