#pragma once

#include "open_frame.h"

namespace esa_frame_builder {

/// (7): the measurement of dwell k lies within the footprint of dwell n, widened by the motion in between at
/// `angular_rate` = θ̇_max (9) [1/s] and by the measurement's own error. Always true of its own dwell.
bool isInFootprint(const Measurement& measurement, const Dwell& k, const Dwell& n, double angular_rate,
                   const FrameBuilderParams& params);

/// Selection processing, (15)–(22) for any number of beams. Each measurement has the set of the frame's dwells whose
/// footprint (7) contains it, its own always among them; measurements with the same set are a region. Of a region of
/// several dwells the measurements of one are kept: of the one that has most there, then of the one with the greatest
/// sum of signal-to-noise ratios, then of the earliest.
Frame selected(const OpenFrame& frame, const FrameBuilderParams& params);

}  // namespace esa_frame_builder
