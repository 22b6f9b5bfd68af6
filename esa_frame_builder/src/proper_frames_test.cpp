// The first rule of a proper frame, over random targets and beams.
#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/random_test_helpers.h>

#include "dwell_test_helpers.h"
#include "frame_builder.h"

namespace esa_frame_builder {
namespace {

struct Target {
  double range, u, v, rate_u, rate_v;
  double uAt(double t) const { return u + rate_u * t; }
  double vAt(double t) const { return v + rate_v * t; }
};

/// Ten targets about 60 km away, up to 300 m/s, in a patch five beamwidths wide.
std::vector<Target> randomTargets(std::mt19937_64& generator) {
  std::vector<Target> targets;
  for (int i = 0; i < 10; ++i)
    targets.push_back({60e3 + 300.0 * i, tws::uniform(generator, -0.05, 0.05), tws::uniform(generator, -0.05, 0.05),
                       tws::uniform(generator, -0.003, 0.003), tws::uniform(generator, -0.003, 0.003)});
  return targets;
}

/// A beam sees what lies within its half-power width. Errors are uniform and stay inside the gate of (7). The range
/// tells the target: 60 km and 300 m for each.
Dwell lookAt(const std::vector<Target>& targets, double time, double u, double v, std::mt19937_64& generator) {
  Dwell dwell = dwellAt(time, u, v);
  for (const Target& target : targets) {
    const double at_u = target.uAt(time), at_v = target.vAt(time);
    if (std::hypot(at_u - u, at_v - v) > 0.5 * dwell.beamwidth_u) continue;
    dwell.measurements.push_back(measurementAt(target.range, at_u + tws::uniform(generator, -0.001, 0.001),
                                               at_v + tws::uniform(generator, -0.001, 0.001),
                                               tws::uniform(generator, 20.0, 500.0)));
  }
  return dwell;
}

/// The target lies further than the expansions of (7), which widen what is in and, as errors and motion go both ways,
/// what may be out, from every footprint's edge.
bool isClearOfEdges(const Target& target, const Frame& frame, const FrameBuilderParams& params) {
  double first = frame.dwells.front().time, last = frame.dwells.back().time;
  const double error = std::sqrt(params.angle_gate_chi2 * 0.5e-6);
  const double expansion = 2.0 * (params.max_speed / 60e3 * (last - first) + error);
  for (const Dwell& dwell : frame.dwells) {
    const double distance = std::hypot(target.uAt(dwell.time) - dwell.u, target.vAt(dwell.time) - dwell.v);
    if (std::abs(distance - footprintRadius(dwell, params)) <= expansion) return false;
  }
  return true;
}

int countOf(const Target& target, const std::vector<Dwell>& dwells) {
  int count = 0;
  for (const Dwell& dwell : dwells)
    for (const Measurement& measurement : dwell.measurements) count += measurement.range == target.range ? 1 : 0;
  return count;
}

class ProperFrames : public testing::TestWithParam<Algorithm> {};

// If this fails, one target is two for the tracker.
TEST_P(ProperFrames, HoldNoTargetTwiceThatIsClearOfTheFootprintsEdges) {
  auto generator = tws::seededGenerator();
  FrameBuilderParams params;
  params.algorithm = GetParam();
  params.alpha_0 = 1.0;
  params.max_speed = 300.0;
  int seen_twice = 0;
  for (int run = 0; run < 1000; ++run) {
    FrameBuilder builder(params);
    const std::vector<Target> targets = randomTargets(generator);
    std::vector<Frame> frames;
    std::vector<Dwell> looks;
    for (int n = 0; n < 10; ++n) {
      const std::size_t first = looks.size();
      while (looks.size() < first + 5) {
        const double time = 0.02 * static_cast<double>(looks.size());
        looks.push_back(lookAt(targets, time, tws::uniform(generator, -0.05, 0.05),
                               tws::uniform(generator, -0.05, 0.05), generator));
        looks.back().number = static_cast<std::uint32_t>(looks.size() - 1);
      }
      const std::vector<Dwell> news(looks.begin() + static_cast<std::ptrdiff_t>(first), looks.end());
      for (Frame& frame : builder.take({0.1, 0.0, news})) frames.push_back(std::move(frame));
    }
    for (const Frame& frame : frames) {
      std::vector<Dwell> before;
      for (const Dwell& dwell : frame.dwells) before.push_back(looks[dwell.number]);
      for (const Target& target : targets) {
        if (countOf(target, before) < 2 || !isClearOfEdges(target, frame, params)) continue;
        ++seen_twice;
        EXPECT_LE(countOf(target, frame.dwells), 1) << "frame " << frame.number << " of run " << run;
      }
    }
  }
  EXPECT_GT(seen_twice, 100) << "selection had nothing to do: the test shows little";
}

INSTANTIATE_TEST_SUITE_P(Algorithms, ProperFrames,
                         testing::Values(Algorithm::kWithinPeriod, Algorithm::kAcrossPeriods, Algorithm::kSeveralOpen));

}  // namespace
}  // namespace esa_frame_builder
