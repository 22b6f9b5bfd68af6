#pragma once

#include <tws_core/kalman.h>

#include <cstdint>
#include <vector>

#include "frame_window.h"

namespace esa_frame_builder {

/// The paper's three cases of a track in a frame.
enum class FrameCase { kSeen, kMissed, kOutOfView };

enum class TrackStage { kTentative, kFirm };

/// One track of a frame tracker.
struct FrameTrack {
  std::uint32_t number = 0;  // from 1, never used twice in one run
  TrackStage stage = TrackStage::kTentative;
  double time = 0.0;  // at which the state holds [s]
  tws::SpatialState state;
  double first_detection = 0.0;  // [s]
  double last_update = 0.0;      // [s]
  double score = 0.0;            // log-likelihood ratio, target against no target
  double snr = 0.0;              // mean linear power ratio at a beam's centre
};

/// What became of a track in a frame.
struct TrackUpdate {
  FrameTrack track;
  FrameCase seen = FrameCase::kSeen;
  bool dropped = false;  // its final update
};

/// What a frame tracker says.
struct TrackReport {
  std::vector<TrackUpdate> updates;  // tracks seen, missed or dropped since the last report, each once
  std::vector<FrameTrack> living;    // all tracks, each at its own time
};

/// The seam between frames and tracks. A multi-frame tracker gets a window of proper frames and decides when it will:
/// at once, or when a frame leaves the window.
class FrameTracker {
 public:
  virtual ~FrameTracker() = default;

  /// A frame has closed: it is the newest of the window. Called once for each, in order.
  virtual void take(const FrameWindow& window) = 0;
  /// The tracks now, with an early look at the window's open frames, which commits to nothing.
  virtual TrackReport report(const FrameWindow& window) = 0;
};

}  // namespace esa_frame_builder
