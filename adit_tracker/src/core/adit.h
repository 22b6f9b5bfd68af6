#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <tws_core/sector_order.h>

#include "adit_params.h"
#include "clutter/clutter_maps.h"
#include "core/alignment.h"
#include "core/bifurcation.h"
#include "core/correlator.h"
#include "core/duplicate_tracks.h"
#include "core/manual_control.h"
#include "core/next_meeting.h"
#include "core/passage.h"
#include "core/radars.h"
#include "core/sector_intake.h"
#include "core/stitching.h"
#include "core/track_book.h"
#include "iff/iff_watch.h"

namespace adit_tracker {

constexpr std::int64_t kClutterAhead = 3;  // sectors that the clutter map runs ahead of the tracks
// The clutter map works on sector +3 with the detections of sector +4.
constexpr std::int64_t kSectorsAhead = kClutterAhead + 1;

/// The tracker of NRL Report 7952 for up to eight radars: detections of asynchronously scanning radars become one set
/// of tracks. The radars may stand at different sites, each with azimuth sectors of its own; a track is in one of each.
/// Same sectors in, same tracks out, whatever the order in which the radars' sectors arrive (see tws::SectorOrder).
///
/// This is the cycle of the report's figure 3: one sector after the other through clutter map, correlation, conversion
/// and initiation. The tracks are in the TrackBook, their places in sectors with NextMeeting.
class Adit {
 public:
  using Sink = std::function<void(const SectorReport&)>;

  /// Throws std::invalid_argument (see check). `sink` is called for every sector processed; it may be empty.
  Adit(const AditParams& params, Sink sink);
  Adit(const Adit&) = delete;
  Adit& operator=(const Adit&) = delete;

  /// What earth lies under the plane of the radars' places, before the first sector. Else the plane touches it at the
  /// first radar, at 45° of latitude.
  void standOn(const tws::EarthPlane& plane) { radars_.standOn(plane); }

  /// Where a radar stands, before its first sector; else with the first radar. The same again changes nothing. Throws
  /// std::invalid_argument when it stands elsewhere and the parameters cannot join it (see joinsSites).
  void place(std::size_t radar, const tws::SiteFrame& frame);

  /// What a secondary radar (index in params.iff) has received in one sector. It may come before or after the radars'
  /// data of that time, within about a second; later it is left out, and false.
  bool addIff(std::size_t iff, tws::RadarSector sector, const tws::SiteFrame& site);

  /// Takes in a closed sector of a radar (index in params.radars), see SectorIntake. Within a radar, sectors come in
  /// order: one that does not is refused by std::invalid_argument.
  ///
  /// `ship`: of a radar on own ship, which moves so: all radars are on it then. The plots are as measured; the sectors
  /// count from where azimuth 0 of the fixed frame is (see NorthSectors). Throws std::invalid_argument when the
  /// parameters cannot follow it (see joinsSites), or radars stand elsewhere.
  void add(std::size_t radar, tws::RadarSector sector, const std::optional<Passage>& ship = std::nullopt);
  /// Processes a sector that is ready. False: none is.
  bool step();
  /// Overflow: passes over all sectors that are ready. Their detections are ignored; the tracks there are not updated,
  /// and their next meetings with a beam are computed anew.
  void skip();
  /// No more data will come: processes what is left.
  void finish();

  /// From now on, `sink` is told what became of the plots of each sector, which is known one sector later. It costs
  /// time for every track that a plot may belong to.
  void tellPlots(PlotTeller::Sink sink);

  /// For operators.
  ManualControl& manual() { return manual_; }

  /// How radars that disagree are aligned.
  const tws::Registration& registration() const { return alignment_.registration(); }
  tws::Registration& registration() { return alignment_.registration(); }
  bool learnsRegistration() const { return alignment_.learns(); }

  const TrackBook& tracks() const { return tracks_; }
  const ClutterMaps& clutter() const { return clutter_; }
  const Radars& radars() const { return radars_; }
  /// What was learned of the radars' surroundings: what ManualControl::load takes.
  SavedMaps maps() const { return {clutter_.places(), radars_.counts()}; }
  /// What all positions are counted from, in the fixed frame: (0, 0) but for radars on own ship.
  const PlaneOrigin& origin() const { return radars_.origin(); }
  const tws::SectorOrder& order() const { return order_; }
  const AditCounts& counts() const { return counts_; }
  const AditParams& params() const { return params_; }

 private:
  using Slots = std::vector<TrackFile::Slot>;

  void begin(const tws::SectorRef& sector);
  void process(const tws::SectorRef& sector);
  void pass(const tws::SectorRef& sector, bool map_clutter);
  void end();
  void follow(const tws::SectorRef& sector, const Passage& ship);
  void joinSite(std::size_t radar);
  void mapClutter(const tws::SectorRef& sector);
  void correlate(const tws::SectorRef& sector);
  void update(const tws::SectorRef& sector, TrackFile::Slot slot, Detection& detection);
  void updateWeighed(const tws::SectorRef& sector, const Correlation& correlation);
  void share(const tws::SectorRef& sector, TrackFile::Slot slot, const Detection& detection);
  void miss(const tws::SectorRef& sector, TrackFile::Slot slot);
  const ClutterParams& clutterOf(const Track& track) const { return params_.in(track.volume).clutter; }
  bool clutterYieldsTo(const Track& track) const;
  void stitch(double period);
  void convertSlowTracks(const tws::SectorRef& sector);
  void convert(const tws::SectorRef& sector, TrackFile::Slot slot);
  void moveOn(const tws::SectorRef& sector);
  void initiate(const tws::SectorRef& sector);
  void learnFalse(const tws::SectorRef& sector, const Detection& detection, TrackFile::Slot slot);
  /// Nothing: there is no number left.
  std::optional<TrackFile::Slot> startTrack(std::size_t radar, const tws::Plot& plot, bool from_clutter = false);
  TrackFile::Slot startTrackOrBranch(const tws::SectorRef& sector, const Detection& detection);
  std::size_t siteOf(const tws::SectorRef& sector) const { return radars_.at(sector.radar).site; }

  AditParams params_;
  Sink sink_;
  PlotTeller teller_;
  AditCounts counts_;
  Radars radars_;
  Alignment alignment_;
  tws::SectorOrder order_;
  SectorIntake intake_;
  TrackBook tracks_;
  NextMeeting meeting_;
  ClutterMaps clutter_;
  Correlator correlator_;
  Bifurcation bifurcation_;
  DuplicateTracks duplicates_;
  Stitching stitching_;
  IffWatch iff_;
  ManualControl manual_;

  // Of the sector being processed; kept to save allocations.
  Slots primary_, secondary_;
  std::vector<PlotChance> plots_;
};

/// Takes a sector in and processes what has become ready, for a caller that may be away for long.
inline void addAndProcess(Adit& adit, std::size_t radar, tws::RadarSector sector,
                          const std::optional<Passage>& ship = std::nullopt) {
  adit.add(radar, std::move(sector), ship);
  while (adit.step()) continue;
}

}  // namespace adit_tracker
