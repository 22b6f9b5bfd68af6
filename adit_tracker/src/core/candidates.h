#pragma once

#include <cstddef>
#include <vector>

#include "core/detection_file.h"
#include "core/track_file.h"

namespace adit_tracker {

/// A detection in the region of a track.
struct Candidate {
  Detection* detection;
  double distance;
  std::size_t gate;         // the smallest region that holds it
  double likelihood = 0.0;  // of the detection, if it is the track's [1/m²]; association by chances only
};

/// A track with candidates.
struct Entry {
  TrackFile::Slot slot;
  std::size_t order;  // who asks first
  bool primary;
  bool correlated;
  std::size_t first, last;  // its candidates
};

/// A detection, and the chance that a track's target made it, if there is such a target.
struct PlotChance {
  Detection* detection;
  double chance;
};

/// What the correlation gives a track in the primary sector.
struct Correlation {
  TrackFile::Slot slot;
  Detection* detection;  // its own, or of several the likeliest; nullptr: rather none
  // Weighed: any of several detections may be its own, or none.
  bool weighed = false;
  std::size_t first = 0, last = 0;  // which ones, in Correlator::chances()
  double missed = 0.0;              // chance that the target made none of them, if there is one
  double existence = 0.0;           // chance that there is a target …
  double unhidden = 0.0;            // … as far as none is hidden in another one's plot
  std::size_t cluster = 0;          // the same for tracks that compete, directly or through others
};

}  // namespace adit_tracker
