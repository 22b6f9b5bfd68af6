#pragma once

#include "frame.h"
#include "frame_builder_params.h"

namespace esa_frame_builder {

/// What the tests need to know of a dwell's measurements.
struct RangeSpan {
  double least = std::numeric_limits<double>::infinity();      // r^min [m]
  double greatest = -std::numeric_limits<double>::infinity();  // r^max [m]
  double sigma = 0.0;                                          // (5): σ_r, the greatest of the measurements' [m]
  bool empty() const { return least > greatest; }
};
RangeSpan rangeSpanOf(const Dwell& dwell);

/// A dwell and the span of its ranges.
struct SpannedDwell {
  Dwell dwell;
  RangeSpan span;
};

/// (8): Θ_n^max = α0·max(Θ_U, Θ_V), the radius of the dwell's footprint in sine space.
double footprintRadius(const Dwell& dwell, const FrameBuilderParams& params);

/// (1), (2): the beam points are close, in both axes.
bool beamPointsAreClose(const Dwell& k, const Dwell& n, const FrameBuilderParams& params);
/// (3), (4): the ranges may come from the same targets, with γ_r = v_max·|t_k − t_n| + √G0·σ_r. A dwell without
/// measurements has no range: passed.
bool rangesMeet(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params);
/// Test 1, the coarse one: (1)–(4).
bool passesCoarseTest(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params);
/// Test 2, the fine one: (6). True: the beams overlap too much for one frame.
bool passesFineTest(const Dwell& k, const Dwell& n, const FrameBuilderParams& params);
/// The beam point test of a dwell against one dwell of the open frame; true: merging is rejected. By the letter, (6) is
/// tested for all dwells once any has passed the coarse test; here only for those that have passed it themselves.
bool beamPointTestRejects(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params);

/// The footprints (8) meet and the ranges may come from the same targets: a target could be in both dwells.
bool mayShareTargets(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params);

}  // namespace esa_frame_builder
