#pragma once

#include <string>
#include <vector>

#include "frame.h"

namespace esa_frame_builder {

/// What a frame breaks of the rules of a proper frame (section 1), one line each: it has a field of view; its dwells
/// are in order of time; it begins no earlier than `previous`, the closed frame before it (nullptr: none), and its
/// number follows.
std::vector<std::string> brokenRules(const Frame& frame, const Frame* previous);

/// Takes measurements out of the frame that may be the second ones of a target: of two from different dwells that
/// differ by no more than their errors explain (χ² with three degrees of freedom of at most `chi2`), the one with the
/// lower signal-to-noise ratio. Returns how many.
std::size_t removeDuplicates(Frame& frame, double chi2);

}  // namespace esa_frame_builder
