#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "frame.h"

namespace esa_frame_builder {

/// The frames that a multi-frame tracker sees. Frame 1 of the paper is the open one; frames 2 to N are the closed ones
/// here, and frame N + 1 is forgotten. Several frames may be open (algorithm 4).
class FrameWindow {
 public:
  /// `size`: N, at least 2.
  explicit FrameWindow(std::size_t size) : closed_size_(size - 1) {}

  /// A frame has closed: all frames shift.
  void shift(Frame closed) {
    closed_.push_front(std::move(closed));
    if (closed_.size() > closed_size_) closed_.pop_back();
    open_.clear();
  }
  /// An early look at a frame that is open since the last shift.
  void look(Frame partial) { open_.push_back(std::move(partial)); }
  /// What was open is reported anew.
  void clearOpen() { open_.clear(); }

  const std::deque<Frame>& closed() const { return closed_; }  // the newest first
  const std::vector<Frame>& open() const { return open_; }     // the oldest first

 private:
  std::size_t closed_size_;
  std::deque<Frame> closed_;
  std::vector<Frame> open_;
};

}  // namespace esa_frame_builder
