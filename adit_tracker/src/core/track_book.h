#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "core/adit_counts.h"
#include "core/candidates.h"
#include "core/radars.h"
#include "core/track_file.h"
#include "core/track_life.h"
#include "core/track_motion.h"
#include "elevation/height_file.h"

namespace adit_tracker {

/// What happened to a track when a sector was processed.
enum class TrackEvent { kStarted, kUpdated, kCoasted, kDropped };

struct TrackUpdate {
  TrackUpdate(TrackFile::Slot of, TrackEvent what, double when) : slot(of), event(what), time(when) {}
  TrackUpdate(TrackFile::Slot of, TrackEvent what, double when, const tws::Plot& by) : TrackUpdate(of, what, when) {
    plot_range = by.range;
    plot_azimuth = by.azimuth;
  }

  TrackFile::Slot slot;
  TrackEvent event;
  double time;  // of the detection, or of the illumination without one
  // The detection that updated it: of several that may be its own, the likeliest. NaN: none.
  double plot_range = std::numeric_limits<double>::quiet_NaN(), plot_azimuth = plot_range;
};

/// One processed sector of one radar.
struct SectorReport {
  std::size_t radar = 0;
  std::int64_t running = 0;
  double enter_time = 0.0;
  bool skipped = false;              // overflow: its detections were ignored
  std::vector<TrackUpdate> updates;  // valid during the call
};

/// The living tracks: starts, updates, coasts and drops them, and reports what became of each in the sector at hand.
class TrackBook {
 public:
  using Slot = TrackFile::Slot;

  /// `radars` and `counts` are to outlive it.
  TrackBook(const AditParams& params, Radars& radars, AditCounts& counts);

  /// A sector is about to be processed: its report begins with what operators have done since the last one.
  void begin(const tws::SectorRef& sector, double enter_time);
  /// It is processed: what was dropped gives its number back.
  void end();
  /// Of the sector at hand, or processed last. Of radar 0 and at 0 s before the first one.
  const SectorReport& latest() const { return report_; }
  void markSkipped() { report_.skipped = true; }
  /// The plots of the report's updates are told as their radar has measured them.
  void tellAsMeasured(const PlaneOrigin& origin, const Passage& ship);
  /// Dropped in the sector at hand?
  bool isDropped(Slot slot) const;

  /// A new tentative track, in no sector yet; nothing: all numbers are in use, which is counted.
  std::optional<Slot> create(std::size_t radar, const tws::Plot& plot);
  /// The radar has detected a new track, by this plot if it begins with one alone; its beam was there at an unwrapped
  /// azimuth.
  void start(Slot slot, std::size_t radar, const tws::Plot* plot, double unwrapped_azimuth);
  /// A track that has just been started flies as its parent did.
  void branch(Track& track, const Parting& parting, std::size_t radar);
  /// Its first detection may have been another track's: it was its own with this chance.
  void doubtFirst(Track& track, double own) const;
  /// The detection is the track's own, or `merged` is what it says of one of its unresolved targets.
  /// `disputed`: what a clutter point on probation claims is no evidence of movement.
  void update(Slot slot, const tws::SectorRef& sector, RadarQuality& quality, const tws::Plot& plot,
              const tws::Plot* merged, bool disputed);
  /// Which of `plots` is the track's own, if any, is known by chances (`c` is weighed). False: the track is dropped.
  bool updateWeighed(const Correlation& c, const std::vector<PlotChance>& plots, const tws::SectorRef& sector,
                     bool disputed);
  /// Illuminated and not detected by itself: another track's detection, which says `merged` of it, holds it.
  void share(Slot slot, const tws::SectorRef& sector, const tws::Plot& plot, const tws::Plot& merged);
  /// Illuminated and not detected: the track coasts by its stored velocities, or is dropped: false.
  bool miss(Slot slot, const tws::SectorRef& sector);
  void drop(Slot slot, double time);
  /// Tracks that have become firm in the sector at hand.
  const std::vector<Slot>& newlyFirm() const { return newly_firm_; }
  /// `found` follows what `lost` did: it takes over number and uid, and that ends.
  void succeed(Slot found, Slot lost);

  /// By hand, between two sectors: its update comes with the next one.
  void dropByHand(Slot slot);
  void reportByHand(Slot slot, TrackEvent event) { by_hand_.push_back({slot, event, report_.enter_time}); }

  /// Whether the beam that met the track last has detected it.
  void setCoasting(Slot slot, bool coasting);
  /// Firm tracks that it has not: few of all.
  const std::set<Slot>& lost() const { return lost_; }

  /// The origin of the plane moves [m], the tracks do not.
  void moveOrigin(double dx, double dy);

  /// Radars at more than one site take part, one frame a radar. Heights are guessed from then on.
  void join(const std::vector<tws::SiteFrame>& frames, const tws::EarthPlane& plane);

  const Track& at(Slot slot) const { return tracks_.at(slot); }
  Track& at(Slot slot) { return tracks_.at(slot); }
  std::uint32_t size() const { return tracks_.size(); }
  /// Every living track, by sector.
  std::vector<Slot> living() const;
  /// The living track with that number; nothing: there is none.
  std::optional<Slot> find(std::uint32_t number) const;
  /// A track at any instant, by its filter.
  Extrapolation extrapolate(Slot slot, double time) const { return motion_.at(tracks_.at(slot), time); }
  /// Where that radar would measure it then.
  ApparentPosition apparentPosition(Slot slot, std::size_t radar, double time) const {
    return apparentPosition(tracks_.at(slot), radar, time);
  }
  /// Its height, where elevations have given it.
  std::optional<Height> height(Slot slot, double time) const { return heights_.at(tracks_.at(slot).uid, time); }
  /// Firm, and not in doubt after missed illuminations.
  bool confirmed(const Track& track) const { return judge_.confirmed(track); }

  TrackFile& file() { return tracks_; }
  const TrackMotion& motion() const { return motion_; }

 private:
  void enterVolume(Track& track) const;
  void becomeFirm(Slot slot);
  bool showsErrors(const Track& track, const tws::Plot& plot) const;
  ApparentPosition apparentPosition(const Track& track, std::size_t radar, double time) const;
  void look(const Track& track, RadarQuality& quality, double seen) const;
  bool isSilent(std::size_t radar, double time) const;
  bool leavesCover(const Track& track, double time) const;
  bool outOfReach(const Track& track, const RadarQuality& quality) const;
  void doubtOtherSites(Track& track, std::size_t radar) const;

  bool learn_noise_, reference_from_start_;
  double longest_gap_;
  Radars& radars_;
  AditCounts& counts_;
  TrackFile tracks_;
  TrackMotion motion_;
  TrackJudge judge_;
  HeightFile heights_;
  SectorReport report_;
  std::vector<Slot> dropped_, newly_firm_;
  std::set<Slot> lost_;
  std::vector<TrackUpdate> by_hand_;
};

}  // namespace adit_tracker
