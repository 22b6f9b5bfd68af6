#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/number_file.h>
#include <tws_core/sector_file.h>

#include "core/track.h"

namespace adit_tracker {

/// All living tracks: their numbers (LISTT), their parameters, and which azimuth sector each is in (TBX, IDT), as seen
/// from each site of radars.
/// Everything is O(1). Tracks are addressed by slot, not by number: numbers wander through the whole number file, slots
/// stay dense, so that memory follows the greatest number of living tracks and not the capacity.
class TrackFile {
 public:
  using Slot = std::uint32_t;

  /// `capacity` numbers, of which one always stays unused.
  explicit TrackFile(std::uint32_t capacity);

  /// A new tentative track with a number, in no sector yet; nothing: all numbers are in use.
  std::optional<Slot> start();
  void drop(Slot slot);
  /// Takes a track out of its sectors' files: no beam meets it any more, until it is dropped.
  void withdraw(Slot slot);

  /// One more site, in whose sectors nothing is yet. There is one from the beginning.
  void addSite();
  /// Puts a track into the file of a sector: firm tracks on top, tentative ones at the bottom.
  void place(Slot slot, int sector, std::size_t site = 0);
  /// -1: in none.
  int sector(Slot slot, std::size_t site = 0) const { return sites_[site].sector(slot); }

  Track& at(Slot slot) { return tracks_[slot]; }
  const Track& at(Slot slot) const { return tracks_[slot]; }

  /// The slots in a sector, top to bottom, appended to `slots`.
  void list(int sector, std::vector<Slot>& slots, std::size_t site = 0) const;

  /// Has a track brought into the cache while other work goes on: among many tracks, waiting for memory is most of the
  /// time.
  void fetchAhead(Slot slot) const;

  std::uint32_t size() const { return size_; }
  std::uint32_t capacity() const { return numbers_.size(); }

 private:
  tws::NumberFile numbers_;
  std::vector<tws::SectorFile> sites_;
  std::vector<Track> tracks_;
  std::vector<Slot> free_;
  std::uint32_t size_ = 0;
  std::uint32_t next_uid_ = 1;
};

}  // namespace adit_tracker
