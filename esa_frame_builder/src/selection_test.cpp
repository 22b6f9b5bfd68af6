#include "selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <tws_core/random_test_helpers.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

OpenFrame frameOf(const std::vector<Dwell>& dwells, const FrameBuilderParams& params) {
  OpenFrame frame(5, params);
  for (const Dwell& dwell : dwells) frame.add({dwell, rangeSpanOf(dwell)});
  return frame;
}

/// Ranges name the measurements: the kept ones, dwell by dwell.
std::vector<std::vector<double>> keptRanges(const Frame& frame) {
  std::vector<std::vector<double>> kept;
  for (const Dwell& dwell : frame.dwells) {
    kept.emplace_back();
    for (const Measurement& measurement : dwell.measurements) kept.back().push_back(measurement.range);
  }
  return kept;
}

using Ranges = std::vector<std::vector<double>>;
constexpr double kKm = 1000.0;

/// Footprints as wide as a beam on either side, for round numbers.
FrameBuilderParams wideFootprints() {
  FrameBuilderParams params;
  params.alpha_0 = 1.0;
  return params;
}

// Footprints of radius 0.02 about u = 0 and u = 0.03, errors of 0.002: what lies between 0.01 and 0.02 is in both.
TEST(Selection, OfTwoBeamsKeepsTheOneWithMoreInTheOverlap) {
  const FrameBuilderParams params = wideFootprints();
  const Dwell first =
      dwellAt(0.0, 0.0, 0.0, {measurementAt(10 * kKm, -0.005, 0.0), measurementAt(11 * kKm, 0.015, 0.0, 900)});
  const Dwell second = dwellAt(0.0, 0.03, 0.0,
                               {measurementAt(20 * kKm, 0.0151, 0.0, 1), measurementAt(21 * kKm, 0.016, 0.0, 1),
                                measurementAt(22 * kKm, 0.035, 0.0)});
  const Frame frame = selected(frameOf({first, second}, params), params);
  EXPECT_EQ(keptRanges(frame), (Ranges{{10 * kKm}, {20 * kKm, 21 * kKm, 22 * kKm}}));
  EXPECT_EQ(frame.discarded, 1U);
  EXPECT_EQ(frame.number, 5U);
}

TEST(Selection, OfEqualNumbersKeepsTheGreaterSumOfSnrAndThenTheEarlierDwell) {
  const FrameBuilderParams params = wideFootprints();
  const auto frame = [&](double snr_a, double snr_b) {
    const Dwell a =
        dwellAt(0.0, 0.0, 0.0, {measurementAt(10 * kKm, 0.013, 0.0, 5), measurementAt(11 * kKm, 0.015, 0.0, snr_a)});
    const Dwell b =
        dwellAt(0.0, 0.03, 0.0, {measurementAt(20 * kKm, 0.014, 0.0, 5), measurementAt(21 * kKm, 0.016, 0.0, snr_b)});
    return keptRanges(selected(frameOf({a, b}, params), params));
  };
  EXPECT_EQ(frame(10, 11), (Ranges{{}, {20 * kKm, 21 * kKm}}));
  EXPECT_EQ(frame(12, 11), (Ranges{{10 * kKm, 11 * kKm}, {}}));
  EXPECT_EQ(frame(10, 10), (Ranges{{10 * kKm, 11 * kKm}, {}}));
}

// Beams at the corners of a triangle with sides of 0.02. A1: beam 1 alone; A4: beams 1 and 2; A7: all three.
TEST(Selection, OfThreeBeamsSelectsInEachOfTheRegionsByItself) {
  const FrameBuilderParams params = wideFootprints();
  const auto a1 = [](double km) { return measurementAt(km * kKm, -0.015, 0.0); };
  const auto a4 = [](double km) { return measurementAt(km * kKm, 0.01, -0.01); };
  const auto a7 = [](double km, double snr) { return measurementAt(km * kKm, 0.01, 0.006, snr); };
  const Dwell one = dwellAt(0.0, 0.0, 0.0, {a1(10), a1(11), a4(12), a7(13, 5), a7(14, 5)});
  const Dwell two = dwellAt(0.0, 0.02, 0.0, {a4(20), a4(21), a7(22, 100)});
  const Dwell three = dwellAt(0.0, 0.01, 0.017, {a7(30, 6), a7(31, 5)});
  const Frame frame = selected(frameOf({one, two, three}, params), params);
  EXPECT_EQ(keptRanges(frame), (Ranges{{10 * kKm, 11 * kKm}, {20 * kKm, 21 * kKm}, {30 * kKm, 31 * kKm}}));
  EXPECT_EQ(frame.discarded, 4U);
}

// By hand: 0.02 + (1000 m/s / 10 km)·0.1 s + √(9.21·0.5e-6) = 0.03215.
TEST(Selection, WidensTheFootprintByMotionAndError) {
  const FrameBuilderParams params = wideFootprints();
  const Dwell n = dwellAt(7.0, 0.0, 0.0), k = dwellAt(6.9, 0.03, 0.0);
  const double rate = 1000.0 / 10e3;
  EXPECT_TRUE(isInFootprint(measurementAt(10e3, 0.03214, 0.0), k, n, rate, params));
  EXPECT_FALSE(isInFootprint(measurementAt(10e3, 0.03216, 0.0), k, n, rate, params));
  EXPECT_TRUE(isInFootprint(measurementAt(10e3, 0.9, 0.0), k, k, rate, params)) << "its own beam";
}

// If this fails, a dwell that saw nothing vanishes, and with it the misses of the tracks in its beam.
TEST(Selection, KeepsTheFieldOfViewOfEveryDwell) {
  const FrameBuilderParams params = wideFootprints();
  const Dwell saw = dwellAt(0.0, 0.0, 0.0, {measurementAt(10e3, 0.0, 0.0, 9)});
  const Dwell lost = dwellAt(0.0, 0.012, 0.0, {measurementAt(10e3, 0.0, 0.0, 3)});
  const Frame frame = selected(frameOf({dwellAt(0.0, 0.5, 0.5), saw, lost}, params), params);
  EXPECT_EQ(keptRanges(frame), (Ranges{{}, {10e3}, {}}));
  EXPECT_DOUBLE_EQ(frame.dwells[2].u, 0.012);
}

/// Equations (7) to (22) set by set, for M beams: every subset of beams is a region, and the index sets are formed by
/// intersection as in (11) to (14).
class BruteForce {
 public:
  BruteForce(const std::vector<Dwell>& dwells, const FrameBuilderParams& params) : dwells_(dwells), params_(params) {
    double least = std::numeric_limits<double>::infinity();
    for (const Dwell& dwell : dwells)
      for (const Measurement& m : dwell.measurements) least = std::min(least, m.range);
    rate_ = params.max_speed / least;
  }

  Ranges kept() const {
    std::vector<std::set<double>> kept(dwells_.size());
    for (unsigned region = 1; region < 1U << dwells_.size(); ++region) selectIn(region, kept);
    Ranges ranges;
    for (std::size_t k = 0; k < dwells_.size(); ++k) {
      ranges.emplace_back();
      for (const Measurement& m : dwells_[k].measurements)
        if (kept[k].count(m.range) > 0) ranges.back().push_back(m.range);
    }
    return ranges;
  }

 private:
  bool passes(const Measurement& m, std::size_t k, std::size_t n) const {  // (7)
    const Dwell &own = dwells_[k], &other = dwells_[n];
    const double left = std::sqrt(std::pow(m.u - other.u, 2) + std::pow(m.v - other.v, 2));
    const double size = params_.alpha_0 * std::max(other.beamwidth_u, other.beamwidth_v);
    const double noise = std::sqrt(params_.angle_gate_chi2 * m.covariance.bottomRightCorner<2, 2>().trace());
    return left < size + rate_ * std::abs(own.time - other.time) + noise;
  }

  // I_k(n, ..., ~p, ...): in all other beams of the region and in none beside it.
  std::vector<const Measurement*> indices(std::size_t k, unsigned region) const {
    std::vector<const Measurement*> found;
    for (const Measurement& m : dwells_[k].measurements) {
      bool belongs = true;
      for (std::size_t n = 0; n < dwells_.size(); ++n)
        if (n != k) belongs = belongs && passes(m, k, n) == ((region >> n & 1U) != 0);
      if (belongs) found.push_back(&m);
    }
    return found;
  }

  void selectIn(unsigned region, std::vector<std::set<double>>& kept) const {
    std::size_t best = 0, most = 0;
    double greatest = 0.0;
    for (std::size_t k = 0; k < dwells_.size(); ++k) {
      if ((region >> k & 1U) == 0) continue;
      const auto set = indices(k, region);
      double snr = 0.0;
      for (const Measurement* m : set) snr += m->snr;
      if (set.size() > most || (set.size() == most && snr > greatest)) {
        best = k;
        most = set.size();
        greatest = snr;
      }
    }
    if (most == 0) return;
    for (const Measurement* m : indices(best, region)) kept[best].insert(m->range);
  }

  const std::vector<Dwell>& dwells_;
  const FrameBuilderParams& params_;
  double rate_;
};

std::vector<Dwell> randomDwells(std::mt19937_64& generator, int beams) {
  std::vector<Dwell> dwells;
  for (int k = 0; k < beams; ++k) {
    Dwell dwell = dwellAt(0.02 * k, tws::uniform(generator, -0.03, 0.03), tws::uniform(generator, -0.03, 0.03));
    dwell.beamwidth_v = tws::uniform(generator, 0.01, 0.02);
    for (int i = tws::uniformInt(generator, 0, 8); i > 0; --i)
      dwell.measurements.push_back(
          measurementAt(tws::uniform(generator, 50e3, 60e3), dwell.u + tws::uniform(generator, -0.02, 0.02),
                        dwell.v + tws::uniform(generator, -0.02, 0.02), tws::uniform(generator, 10.0, 1000.0)));
    dwells.push_back(dwell);
  }
  return dwells;
}

// If this fails, targets are lost from frames or stand in them twice.
TEST(Selection, AgreesWithTheEquationsReadSetBySet) {
  auto generator = tws::seededGenerator();
  std::size_t discarded = 0;
  for (int run = 0; run < 2000; ++run) {
    FrameBuilderParams params;
    params.alpha_0 = tws::uniform(generator, 0.5, 1.5);
    const std::vector<Dwell> dwells = randomDwells(generator, tws::uniformInt(generator, 1, 6));
    const Frame frame = selected(frameOf(dwells, params), params);
    ASSERT_EQ(keptRanges(frame), BruteForce(dwells, params).kept()) << "run " << run;
    discarded += frame.discarded;
  }
  EXPECT_GT(discarded, 2000U) << "the beams hardly overlap: the test shows little";
}

TEST(Selection, WorksTheSameAmongHundredsOfBeamsElsewhere) {
  auto generator = tws::seededGenerator();
  const FrameBuilderParams params = wideFootprints();
  const std::vector<Dwell> near = randomDwells(generator, 6);
  std::vector<Dwell> all;
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (int n = 0; n < 50; ++n) all.push_back(dwellAt(near[k].time, 0.5, 0.01 * n, {measurementAt(55e3, 0.5, 0.9)}));
    all.push_back(near[k]);
  }
  const Ranges expected = keptRanges(selected(frameOf(near, params), params));
  const Ranges kept = keptRanges(selected(frameOf(all, params), params));
  for (std::size_t k = 0; k < near.size(); ++k) EXPECT_EQ(kept[51 * k + 50], expected[k]);
}

}  // namespace
}  // namespace esa_frame_builder
