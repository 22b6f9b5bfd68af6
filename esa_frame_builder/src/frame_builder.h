#pragma once

#include <deque>
#include <vector>

#include "open_frame.h"

namespace esa_frame_builder {

/// One resource period of the radar.
struct ResourcePeriod {
  double duration = 0.0;  // T_rp [s], > 0
  /// (33): t_next^min, when the next dwell on a track is expected [s]; without tracks infinite.
  double next_dwell = std::numeric_limits<double>::infinity();
  std::vector<Dwell> dwells;  // in order of time, also from period to period
};

/// Builds proper frames from dwells: Slocumb and Klusman, "Frame Building Algorithm for Electronically Scanned Array
/// Radar", section 3. Frames close in the order of their numbers, each after selection processing.
///
/// Algorithm 4 keeps several frames open. A dwell that may share targets with open frames goes into the youngest of
/// those, or, where that one rejects it, into the next younger one (new, if there is none); a dwell that shares targets
/// with none goes into the oldest. So every target comes in order of time from frame to frame, though dwells need not.
/// Algorithm 3 is the case of one open frame, 2 that without the time tests, 1 that in which every dwell is rejected.
class FrameBuilder {
 public:
  explicit FrameBuilder(const FrameBuilderParams& params) : params_(params) {}
  FrameBuilder(const FrameBuilder&) = delete;
  FrameBuilder& operator=(const FrameBuilder&) = delete;

  /// Takes the dwells of one resource period; the frames that closed, in order.
  std::vector<Frame> take(ResourcePeriod period);
  /// On a live system, at any time [s]: closes the frames that are older than T_frame^max.
  std::vector<Frame> closeStale(double now);
  /// The open frames as they are now, after selection, in the order in which they will close.
  std::vector<Frame> partialFrames() const;

 private:
  bool testsTime() const;
  bool rejects(const OpenFrame& frame, const SpannedDwell& dwell) const;
  std::size_t placeFor(const SpannedDwell& dwell) const;
  void insert(SpannedDwell dwell, std::vector<Frame>& closed);
  void closeOldest(std::vector<Frame>& closed);
  bool mustClose(const OpenFrame& frame, double next_dwell) const;

  FrameBuilderParams params_;
  double resource_period_ = 0.0;  // T_rp [s]
  std::uint32_t next_number_ = 0;
  std::deque<OpenFrame> open_;  // the oldest first
};

}  // namespace esa_frame_builder
