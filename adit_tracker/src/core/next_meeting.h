#pragma once

#include <vector>

#include <tws_core/sector_order.h>

#include "core/radars.h"
#include "core/track_file.h"
#include "core/track_motion.h"

namespace adit_tracker {

/// Where and when a radar's beam meets a track next, and so in which azimuth sector of each site the track is filed.
class NextMeeting {
 public:
  using Slots = std::vector<TrackFile::Slot>;

  /// All are to outlive it.
  NextMeeting(const Radars& radars, const tws::SectorOrder& order, const TrackMotion& motion, TrackFile& tracks)
      : radars_(radars), order_(order), motion_(motion), tracks_(tracks) {}

  /// Has the radar met the track on this scan already, detected or not? A track that has moved on into the next sector
  /// has had its chance all the same.
  static bool metOnThisScan(const Track& track, const tws::SectorRef& sector) {
    return track.illuminated[sector.radar] > tws::Antenna::startOf(sector.running) - tws::kPi;
  }

  /// Appends the tracks in a sector that its radar has not met on this scan, each predicted for its beam.
  void list(const tws::SectorRef& sector, Slots& slots);

  /// T2 of the report: predicts the track for the earliest next time that any radar of that site illuminates it.
  void predict(Track& track, std::size_t site) const;
  /// Puts a track into the sector where its next illumination will be, unless another radar would then miss it: that
  /// radar's processing has passed the new sector, but not the old one.
  void moveOn(TrackFile::Slot slot, std::size_t radar);
  /// The plane's origin has moved, and with it the track's direction: predicts it anew and puts it into the sector
  /// there, unless its radar would then miss it. Of radars at one site.
  void refile(TrackFile::Slot slot);
  /// Puts a new track into the sectors of all sites; `site`: whose radar has detected it.
  void enter(TrackFile::Slot slot, std::size_t site);
  /// Radars of one more site, the last, take part: puts these tracks into its sectors.
  void addSite(const Slots& living);

 private:
  void aimAt(Track& track, const tws::SectorRef& sector) const;
  void renewElsewhere(TrackFile::Slot slot, std::size_t site);
  int sectorElsewhere(const Track& track, std::size_t site) const;
  bool scans(std::size_t radar, std::size_t site) const;
  double nextIllumination(const Track& track, std::size_t radar) const;
  bool wouldMiss(int from, int to, std::size_t radar) const;

  const Radars& radars_;
  const tws::SectorOrder& order_;
  const TrackMotion& motion_;
  TrackFile& tracks_;
};

}  // namespace adit_tracker
