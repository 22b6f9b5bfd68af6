#pragma once

#include <cstddef>
#include <optional>

#include "clutter/clutter_maps.h"
#include "clutter/saved_maps.h"
#include "core/next_meeting.h"
#include "core/track_book.h"

namespace adit_tracker {

/// What operators do. It takes effect between two sectors, and the updates of tracks come with the next one.
class ManualControl {
 public:
  /// All are to outlive it.
  ManualControl(TrackBook& tracks, NextMeeting& meeting, ClutterMaps& clutter, Radars& radars)
      : tracks_(tracks), meeting_(meeting), clutter_(clutter), radars_(radars) {}

  void handOff(TrackFile::Slot slot, bool on) { tracks_.at(slot).handed_off = on; }
  void designate(TrackFile::Slot slot, bool on) { tracks_.at(slot).designated = on; }
  /// Starts a track where an operator has seen something: range [m] in (0, 10 000 km], azimuth [rad], to within `sigma`
  /// [m]. Nothing: all numbers are in use, which is counted.
  std::optional<TrackFile::Slot> start(double range, double azimuth, double sigma);
  void drop(TrackFile::Slot slot) { tracks_.dropByHand(slot); }
  /// All or nothing. See ClutterMaps::load and Radars::load.
  std::size_t load(const SavedMaps& maps);

 private:
  TrackBook& tracks_;
  NextMeeting& meeting_;
  ClutterMaps& clutter_;
  Radars& radars_;
};

}  // namespace adit_tracker
