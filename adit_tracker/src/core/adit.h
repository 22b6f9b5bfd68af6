#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <tws_core/sector_order.h>
#include "adit_params.h"
#include "clutter/clutter_map.h"
#include "core/bifurcation.h"
#include "core/correlator.h"
#include "core/radar_state.h"
#include "core/track_file.h"
#include "core/track_life.h"
#include "core/track_motion.h"
#include "elevation/height_file.h"
#include "iff/iff_watch.h"

namespace adit_tracker {

constexpr std::int64_t kClutterAhead = 3;  // sectors that the clutter map runs ahead of the tracks
// The clutter map works on sector +3 with the detections of sector +4.
constexpr std::int64_t kSectorsAhead = kClutterAhead + 1;

/// What happened to a track when a sector was processed.
enum class TrackEvent { kStarted, kUpdated, kCoasted, kDropped };

struct TrackWord {
  TrackFile::Slot slot;
  TrackEvent event;
  double time;  // of the detection, or of the illumination without one
};

/// One processed sector of one radar.
struct SectorReport {
  std::size_t radar = 0;
  std::int64_t running = 0;
  double enter_time = 0.0;
  bool skipped = false;          // overflow: its detections were ignored
  std::vector<TrackWord> words;  // valid during the call
};

/// Totals since the start.
struct AditCounts {
  std::uint64_t sectors = 0, plots = 0, rejected_plots = 0, late_plots = 0, duplicate_plots = 0;
  std::uint64_t late_sectors = 0;
  std::uint64_t skipped_sectors = 0;
  std::uint64_t tracks_started = 0, tracks_firm = 0, tracks_dropped = 0;
  std::uint64_t refused_tracks = 0, refused_clutter = 0;  // for want of numbers
  std::uint64_t to_clutter = 0, to_track = 0;             // conversions
};

/// The tracker of NRL Report 7952 for up to eight radars: detections of asynchronously scanning radars become one set
/// of tracks. The radars may stand at different sites, each with azimuth sectors of its own; a track is in one of each.
/// Same sectors in, same tracks out, whatever the order in which the radars' sectors arrive (see tws::SectorOrder).
class Adit {
 public:
  using Sink = std::function<void(const SectorReport&)>;

  /// Throws std::invalid_argument (see check). `sink` is called for every sector processed; it may be empty.
  Adit(const AditParams& params, Sink sink);

  /// Where a radar stands, before its first sector; else with the first radar. The same again changes nothing. Throws
  /// std::invalid_argument when it stands elsewhere and the parameters cannot join it (see joinsSites).
  void place(std::size_t radar, const tws::SiteFrame& frame);

  /// What a secondary radar (index in params.iff) has received in one sector. It may come before or after the radars'
  /// data of that time, within about a second; later it is left out, and false.
  bool hearIff(std::size_t iff, tws::RadarSector sector, const tws::SiteFrame& site) {
    return iff_.add(iff, std::move(sector), site);
  }

  /// Takes in a closed sector of a radar (index in params.radars) and processes what has become ready. Within a radar,
  /// sectors come in order: one that does not is refused by std::invalid_argument. Plots that are not finite or whose
  /// range is not in (0, 10 000 km] are left out and counted; so are late ones, of which the beam met the target more
  /// than a sector before it entered this one, and copies of plots.
  void add(std::size_t radar, tws::RadarSector sector);
  /// The same in two steps, for who must not be away for long: takes in the sector; processes one that is ready. False:
  /// none is.
  void take(std::size_t radar, tws::RadarSector sector);
  bool step();
  /// Sectors taken in and not processed yet, of all radars.
  std::size_t waiting() const { return taken_ - counts_.sectors; }
  /// Sectors that step() would process by now, of each radar.
  std::vector<std::size_t> ready() const { return order_.ready(); }
  /// Overflow: passes over all sectors that are ready. Their detections are ignored; the tracks there are not updated,
  /// and their next meetings with a beam are computed anew.
  void skip();

  /// No more data will come: processes what is left.
  void finish();

  /// What operators do. It takes effect between two sectors, and its words come with the next one.
  /// The living track with that number; nothing: there is none.
  std::optional<TrackFile::Slot> find(std::uint32_t number) const;
  void handOff(TrackFile::Slot slot, bool on) { tracks_.at(slot).handed_off = on; }
  void designate(TrackFile::Slot slot, bool on) { tracks_.at(slot).designated = on; }
  /// Starts a track where an operator has seen something: range [m] in (0, 10 000 km], azimuth [rad], to within `sigma`
  /// [m]. Nothing: all numbers are in use, which is counted.
  std::optional<TrackFile::Slot> startByHand(double range, double azimuth, double sigma);
  void dropByHand(TrackFile::Slot slot);
  /// Clutter is known to stand there, from now on (see ClutterMap::load). The map of a radar that was not heard yet
  /// gets its points with the radar's first sector. Places of all radars go into every map, and a common map takes
  /// those of each radar; what two radars say of one point there is one point. Returns for how many points there was no
  /// number, which is counted. Throws std::invalid_argument when ClutterLimits refuses a place.
  std::size_t loadClutter(const std::vector<ClutterPlace>& places);

  /// The sector processed last; its words are not valid. Of radar 0 and at 0 s as long as counts() has no sector.
  const SectorReport& latest() const { return report_; }
  /// Has the tracker given up waiting for this radar, or never heard it?
  bool silent(std::size_t radar) const { return order_.silent(radar); }
  /// The running number of the radar's next sector.
  std::int64_t front(std::size_t radar) const { return order_.front(radar); }
  std::size_t referenceRadar() const { return reference_; }
  /// Do the radars stand at several sites?
  bool severalSites() const { return sites_.size() > 1; }
  const tws::Antenna& antenna(std::size_t radar) const { return radars_[radar].antenna; }
  const TrackFile& tracks() const { return tracks_; }
  /// Every living track, by sector.
  std::vector<TrackFile::Slot> living() const;
  /// A track at any instant, by its filter.
  Extrapolation at(TrackFile::Slot slot, double time) const { return motion_.at(tracks_.at(slot), time); }
  /// How that radar sees it then.
  Seen seenBy(TrackFile::Slot slot, std::size_t radar, double time) const;
  /// Its height, where elevations have told it.
  std::optional<Height> height(TrackFile::Slot slot, double time) const {
    return heights_.at(tracks_.at(slot).uid, time);
  }
  /// Firm, and not in doubt after missed illuminations.
  bool believed(const Track& track) const { return judge_.believed(track); }
  /// The clutter maps: one, or one for each radar.
  const std::vector<ClutterMap>& clutter() const { return clutter_; }
  /// The points that are surely clutter (ClutterMap::known), by radar and azimuth: what loadClutter takes.
  std::vector<ClutterPlace> clutterPlaces() const;
  const RadarQuality& quality(std::size_t radar) const { return radars_[radar].quality; }
  const AditCounts& counts() const { return counts_; }
  const AditParams& params() const { return params_; }

 private:
  using Slots = std::vector<TrackFile::Slot>;

  void sift(std::size_t radar, tws::RadarSector& sector);
  bool cameBefore(std::size_t radar, std::int64_t running, const tws::Plot& plot);
  void begin(const tws::SectorRef& turn);
  void end();
  void pass(const tws::SectorRef& turn, bool map_clutter);
  void process(const tws::SectorRef& turn);
  void admit(const tws::SectorRef& turn);
  void mapClutter(std::size_t radar, std::int64_t running);
  void loadAwaitedClutter(const tws::SectorRef& turn);
  std::size_t loadClutterInto(std::size_t map, std::vector<ClutterPlace>& awaited);
  void correlate(const tws::SectorRef& turn);
  bool tellsErrors(const Track& track, const tws::Plot& plot) const;
  bool clutterYieldsTo(const Track& track) const;
  void update(const tws::SectorRef& turn, TrackFile::Slot slot, Detection& detection);
  void miss(const tws::SectorRef& turn, TrackFile::Slot slot);
  void hide(const tws::SectorRef& turn, TrackFile::Slot slot, const Detection& detection);
  void initiate(const tws::SectorRef& turn);
  /// nullptr: there is no number left.
  Track* startTrack(std::size_t radar, const tws::Plot& plot);
  void startTrackOrBranch(const tws::SectorRef& turn, const Detection& detection);
  /// As far as no beam has met it yet.
  std::optional<TrackFile::Slot> newTrack(std::size_t radar, const tws::Plot& plot);
  void convertSlowTracks(const tws::SectorRef& turn);
  std::size_t latestOf(const Track& track) const;
  bool hasBecomeSlow(Track& track, double judge_after) const;
  void moveOn(TrackFile::Slot slot, std::size_t radar);
  void drop(TrackFile::Slot slot, double time);

  static bool metOnThisScan(const Track& track, std::size_t radar, std::int64_t running);
  void joinSite(std::size_t radar);
  void enterSectors(TrackFile::Slot slot, std::size_t site);
  void renewElsewhere(TrackFile::Slot slot, std::size_t site);
  int sectorElsewhere(const Track& track, std::size_t site) const;
  bool outOfReach(const Track& track, const RadarQuality& quality) const;
  void doubtOtherSites(Track& track, std::size_t radar) const;
  void listSector(const tws::SectorRef& turn, std::int64_t running, Slots& slots);
  void aimAt(Track& track, std::size_t radar, std::int64_t running);
  void predictNext(Track& track, std::size_t site);
  double nextIllumination(const Track& track, std::size_t radar) const;
  bool wouldMissUpdate(int from, int to, std::size_t radar) const;
  std::optional<double> judgeAfter(std::size_t radar, std::int64_t running, long offset) const;
  std::size_t clutterIndex(std::size_t radar) const { return clutter_.size() == 1 ? 0 : radar; }
  ClutterMap& clutterOf(std::size_t radar) { return clutter_[clutterIndex(radar)]; }
  RadarState& radarOf(const tws::SectorRef& turn) { return radars_[turn.radar]; }

  AditParams params_;
  Sink sink_;
  std::size_t reference_;
  tws::SectorOrder order_;
  std::vector<RadarState> radars_;
  std::vector<tws::SiteFrame> sites_{tws::SiteFrame{}};  // those whose radars have been heard, the first radar's always
  TrackFile tracks_;
  std::vector<ClutterMap> clutter_;
  std::vector<std::vector<ClutterPlace>> awaited_clutter_;  // of each map: loaded with the first sector
  Correlator correlator_;
  TrackMotion motion_;
  Bifurcation bifurcation_;
  TrackJudge judge_;
  HeightFile heights_;
  IffWatch iff_;
  AditCounts counts_;
  std::uint64_t taken_ = 0;  // sectors

  // Of the sector being processed; kept to save allocations.
  SectorReport report_;
  Slots primary_, secondary_, dropped_;
  std::vector<TrackWord> by_hand_;  // said with the next sector
};

}  // namespace adit_tracker
