#include "detection_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include <tws_core/random_test_helpers.h>

namespace range_gate_tracker {
namespace {

/// The report's equations (1) to (6), one sum at a time, in long double.
struct BruteForce {
  const RangeProfile& profile;
  std::size_t s;
  Background background;

  long double power(std::size_t r) const {
    return static_cast<long double>(profile.amplitude[r]) * static_cast<long double>(profile.amplitude[r]);
  }
  long double rangeOf(std::size_t r) const {
    return profile.range_min + (static_cast<long double>(r) + 0.5L) * profile.bin_size;
  }
  std::size_t size() const { return profile.amplitude.size(); }
  /// {sum of powers, sum of powers times ranges, bins} of the bins in [from, to) that exist.
  std::array<long double, 3> sums(long from, long to) const {
    std::array<long double, 3> total{0, 0, 0};
    for (long r = std::max(from, 0L); r < std::min(to, static_cast<long>(size())); ++r) {
      const auto bin = static_cast<std::size_t>(r);
      total[0] += power(bin);
      total[1] += power(bin) * rangeOf(bin);
      total[2] += 1;
    }
    return total;
  }
  /// {S0, S1} of the window that begins at r.
  std::array<long double, 2> net(std::size_t r) const {
    const long first = static_cast<long>(r), bins = static_cast<long>(s);
    const auto own = sums(first, first + bins);
    const long double centre = profile.range_min + (r + s / 2.0L) * profile.bin_size;
    if (background == Background::kNone) return {own[0], own[1]};
    if (background == Background::kGlobal) {
      const long double b0 = s * sums(0, static_cast<long>(size()))[0] / size();
      return {own[0] - b0, own[1] - b0 * centre};
    }
    const auto left = sums(first - bins, first), right = sums(first + bins, first + 2 * bins);
    if (left[2] == bins && right[2] == bins)
      return {own[0] - 0.5L * (left[0] + right[0]), own[1] - 0.5L * (left[1] + right[1])};
    const long double there = left[2] + right[2];
    const long double b0 = there > 0 ? s * (left[0] + right[0]) / there : 0;
    return {own[0] - b0, own[1] - b0 * centre};
  }
};

RangeProfile noise(std::size_t bins, std::mt19937_64& random) {
  RangeProfile profile;
  profile.range_min = 8123.25;
  profile.bin_size = 1.5;
  std::normal_distribution<float> normal;
  for (std::size_t i = 0; i < bins; ++i) {
    const float in_phase = normal(random), quadrature = normal(random);
    profile.amplitude.push_back(std::hypot(in_phase, quadrature));
  }
  return profile;
}

void expectBruteForce(const RangeProfile& profile, std::size_t s, Background background) {
  const BruteForce truth{profile, s, background};
  const WindowReading reading = DetectionWindow(s, background).search(profile);
  const auto [power, moment] = truth.net(reading.first_bin);
  const double total = static_cast<double>(truth.sums(0, static_cast<long>(truth.size()))[0]);
  EXPECT_NEAR(reading.power, static_cast<double>(power), 1e-12 * total);
  for (std::size_t r = 0; r + s <= truth.size(); ++r)
    EXPECT_LE(static_cast<double>(truth.net(r)[0]), reading.power + 1e-12 * total) << "a brighter window at " << r;
  if (reading.power > 1e-6 * total) {
    EXPECT_NEAR(reading.range, static_cast<double>(moment / power), 1e-6 * profile.rangeMax());
  }
}

constexpr Background kAll[] = {Background::kNone, Background::kLocal, Background::kGlobal};

// Whoever reads a range relies on the sums being the report's, for every size of window and gate.
TEST(DetectionWindow, FindsWhatTheEquationsSayOneByOne) {
  auto random = tws::seededGenerator();
  for (int trial = 0; trial < 300; ++trial) {
    const auto bins = static_cast<std::size_t>(tws::uniformInt(random, 1, 120));
    const auto s = static_cast<std::size_t>(tws::uniformInt(random, 1, static_cast<int>(bins)));
    const RangeProfile profile = noise(bins, random);
    for (const Background background : kAll) {
      SCOPED_TRACE("bins " + std::to_string(bins) + ", s " + std::to_string(s));
      expectBruteForce(profile, s, background);
    }
  }
}

// Large cross-sections must not drown a small one in rounding errors of the running sum.
TEST(DetectionWindow, KeepsItsPrecisionBehindAStrongEcho) {
  RangeProfile profile;
  profile.amplitude.assign(4000, 0.01F);
  profile.amplitude[3] = 3000.0F;
  const WindowReading behind = DetectionWindow(10, Background::kNone).search(profile, {3000, 3010});
  EXPECT_NEAR(behind.power, 10 * 1e-4, 1e-7);
  for (const Background background : kAll) expectBruteForce(profile, 10, background);
}

RangeProfile flatWith(std::size_t bins, float level, std::size_t first, std::size_t width, float amplitude) {
  RangeProfile profile;
  profile.range_min = 1000.0;
  profile.bin_size = 2.0;
  profile.amplitude.assign(bins, level);
  for (std::size_t r = first; r < first + width; ++r) profile.amplitude[r] = amplitude;
  return profile;
}

// By hand: three bins of 4 m² at 20, 21, 22 of noise 1 m² a bin; s = 5, so C0 = 3·4 + 2·1 = 14 and any window that
// holds all three is a maximum: the nearest begins at 18. Centre of bin 21: 1000 + 21.5·2 = 1043 m.
TEST(DetectionWindow, MeasuresCrossSectionAndRangeOfAHandMadeEcho) {
  const RangeProfile profile = flatWith(60, 1.0F, 20, 3, 2.0F);
  const WindowReading none = DetectionWindow(5, Background::kNone).search(profile);
  EXPECT_EQ(none.first_bin, 18u);
  EXPECT_DOUBLE_EQ(none.power, 14.0);
  // Bins 18 and 19 of 1 m² at 1037 and 1039 m pull: (12·1043 + 1037 + 1039) / 14.
  EXPECT_DOUBLE_EQ(none.range, (12.0 * 1043.0 + 1037.0 + 1039.0) / 14.0);
  const WindowReading local = DetectionWindow(5, Background::kLocal).search(profile);
  EXPECT_DOUBLE_EQ(local.power, 9.0);  // 14 less 5 of noise
  EXPECT_DOUBLE_EQ(local.total_power, 14.0);
  EXPECT_DOUBLE_EQ(local.range, 1043.0);
  const WindowReading global = DetectionWindow(5, Background::kGlobal).search(profile);
  EXPECT_DOUBLE_EQ(global.power, 14.0 - 5.0 * (57.0 + 12.0) / 60.0);
}

// A gate in flat noise: no end may look brighter than the middle, else the gate runs off to its own end.
TEST(DetectionWindow, SeesNothingAboveAFlatBackgroundNotEvenAtTheEnds) {
  const RangeProfile flat = flatWith(100, 1.0F, 0, 0, 0.0F);
  for (std::size_t s : {1u, 7u, 30u, 49u, 60u, 99u})
    for (std::size_t r = 0; r + s <= 100; ++r)
      EXPECT_NEAR(DetectionWindow(s, Background::kLocal).search(flat, {r, r}).power, 0.0, 1e-9) << s << " at " << r;
}

TEST(DetectionWindow, MeasuresAnEchoAtEitherEndOfTheGate) {
  for (const std::size_t first : {0u, 57u}) {
    const WindowReading reading = DetectionWindow(3, Background::kLocal).search(flatWith(60, 1.0F, first, 3, 2.0F));
    EXPECT_EQ(reading.first_bin, first);
    EXPECT_DOUBLE_EQ(reading.power, 9.0);
    EXPECT_DOUBLE_EQ(reading.range, 1000.0 + (static_cast<double>(first) + 1.5) * 2.0);
  }
}

TEST(DetectionWindow, TakesTheNearestOfEqualEchoes) {
  RangeProfile profile = flatWith(60, 0.0F, 10, 1, 2.0F);
  profile.amplitude[40] = 2.0F;
  for (const Background background : kAll) EXPECT_LE(DetectionWindow(4, background).search(profile).first_bin, 10u);
}

TEST(DetectionWindow, LooksOnlyWhereItIsToldTo) {
  RangeProfile profile = flatWith(60, 0.1F, 10, 1, 9.0F);
  profile.amplitude[40] = 2.0F;
  for (const Background background : kAll) {
    const WindowReading reading = DetectionWindow(4, background).search(profile, {30, 50});
    EXPECT_LE(reading.first_bin, 40u);
    EXPECT_GT(reading.first_bin, 36u);
  }
}

TEST(DetectionWindow, FindsNoRangeWhereThereIsNothing) {
  const RangeProfile empty = flatWith(60, 0.0F, 0, 0, 0.0F);
  for (const Background background : kAll) {
    const WindowReading reading = DetectionWindow(4, background).search(empty);
    EXPECT_EQ(reading.power, 0.0);
    EXPECT_TRUE(std::isnan(reading.range));
  }
}

std::string refusal(const RangeProfile& profile, std::size_t s) {
  try {
    DetectionWindow(s, Background::kLocal).search(profile);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(DetectionWindow, SaysWhatIsWrongWithAProfile) {
  RangeProfile profile = flatWith(60, 1.0F, 0, 0, 0.0F);
  EXPECT_EQ(refusal(profile, 61), "the detection window of 61 bins is larger than the gate of 60");
  profile.amplitude[17] = std::nanf("");
  EXPECT_EQ(refusal(profile, 5), "amplitude of bin 17 is nan");
  profile.amplitude[17] = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal(profile, 5), "amplitude of bin 17 is -inf");
  EXPECT_THROW(DetectionWindow(0, Background::kNone), std::invalid_argument);
}

}  // namespace
}  // namespace range_gate_tracker
