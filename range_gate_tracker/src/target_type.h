#pragma once

#include <cstdint>

#include "window_motion.h"
#include "window_params.h"

namespace range_gate_tracker {

/// What the target of a track seems to be (Henery 1985, section 2.4.1: the processor decides what type of target it is
/// and assigns a priority). The thesis does not say how; these rules are ours.
enum class TargetType : std::uint8_t { kUnknown = 0, kStationary = 1, kSurface = 2, kAircraft = 3 };

/// The two places from which a target's mean speed is taken: between four and eight detections ago, so that neither
/// noise nor a circle flown makes it look as if it stood still.
struct TypeBaseline {
  tws::Plot reference;
  tws::Plot next;
  int detections = 0;
};

/// By the mean speed over ground along the baseline. A target is faster than a limit when it is so by three standard
/// deviations; it is no longer when it is not by two. The detection joins the baseline.
TargetType typeOf(TargetType before, TypeBaseline& baseline, const tws::Plot& now, const WindowParams& params);

/// 1, the most urgent: an aircraft that could be at the radar within urgent_time; 2: any other aircraft; 3: a surface
/// target; 4: all else.
int priorityOf(TargetType type, const WindowKinematics& now, const WindowParams& params);

}  // namespace range_gate_tracker
