#include "core/adit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/stray_plots.h"

namespace adit_tracker {
namespace {

constexpr std::int64_t kInitiationBehind = 1;  // sectors that initiation runs behind the tracks
constexpr int kSecondarySectors = 2;           // sectors ahead whose tracks take part in the correlation

AditParams checked(const AditParams& params) {
  check(params);
  return params;
}

/// The radar that updated a track last: at another site, it may be the only one that detects it.
std::size_t latestOf(const Track& track, std::size_t radars) {
  const auto end = track.updated.begin() + static_cast<std::ptrdiff_t>(radars);
  return static_cast<std::size_t>(std::max_element(track.updated.begin(), end) - track.updated.begin());
}

/// What has hardly been measured yet may look slow and be fast. Where false plots come from, that does not count.
bool isSurelySlow(const Extrapolation& now, double false_density, const ConversionParams& params) {
  if (params.speed_sigmas == 0.0 || !now.has_covariance || false_density > params.quiet_density) return true;
  const double sigma = std::sqrt(std::max(now.planar.velocity.xx, now.planar.velocity.yy));
  return std::hypot(now.planar.vx, now.planar.vy) + params.speed_sigmas * sigma < params.speed_down;
}

/// Compares the place with the one stored eight scans ago, and stores the present one.
bool hasBecomeSlow(Track& track, const TrackMotion& motion, const FalsePlotMap& map, double judge_after,
                   const ConversionParams& params) {
  const Kinematics& k = track.smoothed;
  const auto rates = track.reference.compare(k.time, k.range, k.azimuth, judge_after);
  return rates && !isFaster(rates->range, rates->azimuth, k.range, params.speed_down, params) &&
         isSurelySlow(motion.at(track, k.time), map.density(k.range, k.azimuth), params);
}

}  // namespace

Adit::Adit(const AditParams& params, Sink sink)
    : params_(checked(params)),
      sink_(std::move(sink)),
      radars_(params),
      alignment_(params, radars_),
      order_(params.radars.size(), params.skew_limit, kSectorsAhead),
      intake_(radars_, counts_, alignment_, kSectorsAhead),
      tracks_(params, radars_, counts_),
      meeting_(radars_, order_, tracks_.motion(), tracks_.file()),
      clutter_(params, radars_, counts_),
      correlator_(params),
      bifurcation_(params),
      stitching_(params),
      iff_(params.iff),
      manual_(tracks_, meeting_, clutter_, radars_) {}

void Adit::place(std::size_t radar, const tws::SiteFrame& frame) {
  if (order_.newest(radar) >= 0 || tws::sameSite(frame, radars_.sites().front())) return;
  if (!joinsSites(params_)) {
    throw std::invalid_argument("radar " + params_.radars[radar].name +
                                ": radars at different sites need the turning filter and a clutter map for each radar");
  }
  radars_.place(radar, frame);
}

bool Adit::addIff(std::size_t iff, tws::RadarSector sector, const tws::SiteFrame& site) {
  return iff_.add(iff, std::move(sector), site);
}

void Adit::add(std::size_t radar, tws::RadarSector sector, const std::optional<Passage>& ship) {
  if (ship && (!joinsSites(params_) || radars_.severalSites())) {
    throw std::invalid_argument("radar " + params_.radars[radar].name +
                                ": own ship that moves needs the turning filter and a clutter map for each radar, and "
                                "all radars on it");
  }
  const std::int64_t newest = order_.newest(radar);
  if (sector.running <= newest) {
    throw std::invalid_argument("radar " + params_.radars[radar].name + ": sector " + std::to_string(sector.running) +
                                " comes after sector " + std::to_string(newest));
  }
  if (!order_.add({radar, sector.running}, sector.enter_time, sector.leave_time)) ++counts_.late_sectors;
  intake_.add(radar, std::move(sector), ship);
}

bool Adit::step() {
  const auto sector = order_.next();
  if (sector) process(*sector);
  return sector.has_value();
}

void Adit::skip() {
  std::vector<std::size_t> left = order_.ready();
  while (true) {
    const auto sector = order_.next();
    if (!sector) return;
    pass(*sector, static_cast<std::int64_t>(left[sector->radar]--) <= kClutterAhead);
  }
}

void Adit::tellPlots(PlotTeller::Sink sink) {
  const auto tell = [this, sink = std::move(sink)](const SectorFates& sector) {
    const auto& ship = radars_.at(sector.radar).detections.at(sector.running).ship;
    const auto& taken = radars_.at(sector.radar).detections.at(sector.running).taken;
    if (!ship && taken == tws::RegistrationTerms{}) return sink(sector);
    SectorFates measured = sector;
    for (PlotFate& fate : measured.plots) {
      asTold(taken, fate.plot.time, fate.plot.range, fate.plot.azimuth);
      if (ship) asMeasured(origin(), *ship, fate.plot.time, fate.plot.range, fate.plot.azimuth);
    }
    sink(measured);
  };
  teller_.start(tell, radars_.size());
  correlator_.keepClaims();
}

void Adit::finish() {
  order_.finish();
  while (step()) continue;
  for (std::size_t radar = 0; teller_.isOn() && radar < radars_.size(); ++radar)
    teller_.tellBefore(radar, radars_.at(radar).detections, order_.newest(radar) + 1);
}

/// Figure 3 of the report: one sector of the radar whose data are the oldest.
void Adit::process(const tws::SectorRef& sector) {
  begin(sector);
  mapClutter({sector.radar, sector.running + kClutterAhead});
  correlate(sector);
  stitch(radars_.antenna(sector.radar).period());
  convertSlowTracks(sector);
  moveOn(sector);
  initiate(sector);
  end();
}

void Adit::begin(const tws::SectorRef& sector) {
  if (!radars_.at(sector.radar).joined) joinSite(sector.radar);
  alignment_.advance(radars_.antenna(sector.radar).timeAt(tws::Antenna::startOf(sector.running)));
  intake_.admit(sector);
  const double enter_time = radars_.antenna(sector.radar).timeAt(tws::Antenna::startOf(sector.running));
  iff_.apply(enter_time, tracks_.file(), tracks_.motion());
  tracks_.begin(sector, enter_time);
  if (!clutter_.loadAwaited(sector.radar, enter_time)) return;
  // The sectors that the map is too late for, because it runs ahead, are mapped now.
  for (std::int64_t ahead = 0; ahead < kClutterAhead; ++ahead) mapClutter({sector.radar, sector.running + ahead});
}

void Adit::end() {
  ++counts_.sectors;
  const tws::SectorRef sector{tracks_.latest().radar, tracks_.latest().running};
  const auto& ship = radars_.at(sector.radar).detections.at(sector.running).ship;
  if (ship) {
    tracks_.tellAsMeasured(origin(), *ship);
    radars_.at(sector.radar).pose = ship->from;
  }
  if (sink_) sink_(tracks_.latest());
  tracks_.end();
  if (ship) follow(sector, *ship);
}

/// Own ship has moved. All that the tracker knows is seen from there, so that polar coordinates, gates and sectors are
/// the radar's own; what stands still over ground, stands.
void Adit::follow(const tws::SectorRef& sector, const Passage& ship) {
  // Less than radars of ships err. Two radars of one ship must not pull to and fro.
  constexpr double kNear = 3.0, kNearOther = 100.0;  // [m]
  const double dx = ship.to.x - origin().x, dy = ship.to.y - origin().y;
  if (std::hypot(dx, dy) < (sector.radar == 0 ? kNear : kNearOther)) return;
  radars_.moveOrigin(dx, dy);
  clutter_.moveOrigin(dx, dy);
  tracks_.moveOrigin(dx, dy);
  for (const auto slot : tracks_.living()) meeting_.refile(slot);
}

/// A sector that is skipped. The clutter map must have seen those that are not any more.
void Adit::pass(const tws::SectorRef& sector, bool map_clutter) {
  begin(sector);
  tracks_.markSkipped();
  ++counts_.skipped_sectors;
  if (map_clutter) mapClutter({sector.radar, sector.running + kClutterAhead});
  DetectionFile& detections = radars_.at(sector.radar).detections;
  if (teller_.isOn()) teller_.tellBefore(sector.radar, detections, sector.running);
  for (Detection& detection : detections.at(sector.running).detections) detection.use();
  primary_.clear();
  meeting_.list(sector, primary_);
  for (const auto slot : primary_) {
    Track& track = tracks_.at(slot);
    track.illuminated[sector.radar] = tws::Antenna::near(track.predicted.azimuth, sector.running);
    meeting_.predict(track, siteOf(sector));
    if (!tracks_.isDropped(slot)) meeting_.moveOn(slot, sector.radar);
  }
  end();
}

/// The first sector of a radar at another site is about to be processed.
void Adit::joinSite(std::size_t radar) {
  const bool is_new = radars_.join(radar);
  tracks_.join(radars_.frames(), radars_.plane());
  if (is_new) meeting_.addSite(tracks_.living());
}

void Adit::mapClutter(const tws::SectorRef& sector) {
  for (const ClutterPoint& point : clutter_.process(sector)) {
    tws::Plot plot;
    plot.time = point.last_update;
    plot.range = point.range;
    plot.azimuth = point.azimuth;
    const auto slot = startTrack(sector.radar, plot, true);
    if (!slot) continue;
    tracks_.at(*slot).updated = point.updated;  // with one map for all, another radar may have detected it last
    ++counts_.to_track;
  }
}

void Adit::correlate(const tws::SectorRef& sector) {
  RadarState& radar = radars_.at(sector.radar);
  primary_.clear();
  secondary_.clear();
  meeting_.list(sector, primary_);
  if (primary_.empty()) return;
  for (int ahead = 1; ahead <= kSecondarySectors; ++ahead)
    meeting_.list({sector.radar, sector.running + ahead}, secondary_);
  constexpr std::size_t kFetchAhead = 3;
  TrackFile& file = tracks_.file();
  const auto& pairs = correlator_.correlate(file, primary_, secondary_, radar, sector.running, radar.site);
  if (params_.bifurcation) bifurcation_.share(file, tracks_.motion(), correlator_, pairs, primary_, radar, sector);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i + kFetchAhead < pairs.size()) file.fetchAhead(pairs[i + kFetchAhead].slot);
    pairs[i].weighed ? updateWeighed(sector, pairs[i]) : update(sector, pairs[i].slot, *pairs[i].detection);
  }
  duplicates_.end(pairs, tracks_, !params_.bifurcation || radar.quality.merging() < 0.5);
  for (const auto slot : primary_) {
    if (NextMeeting::metOnThisScan(tracks_.at(slot), sector) || tracks_.isDropped(slot)) continue;
    const Detection* const shared = bifurcation_.mergedPlotOf(slot);
    shared ? share(sector, slot, *shared) : miss(sector, slot);
  }
}

void Adit::update(const tws::SectorRef& sector, TrackFile::Slot slot, Detection& detection) {
  Track& track = tracks_.at(slot);
  const bool claimed = detection.claim != Detection::kNoClaim;
  const tws::Plot* const merged = bifurcation_.asSeenBy(track, detection);
  tracks_.update(slot, sector, radars_.at(sector.radar).quality, detection.plot, merged,
                 claimed && clutterOf(track).yields_to_tracks);
  if (claimed && clutterYieldsTo(track)) clutter_.disclaim(detection.claim, sector.radar);
  if (!merged) alignment_.add(tracks_.file(), slot, sector, detection);
  meeting_.predict(track, siteOf(sector));
}

/// What is merged in another track's detection, or shares its own, is left to the rules of bifurcation; so is, where
/// heights are guessed, the choice of one detection.
void Adit::updateWeighed(const tws::SectorRef& sector, const Correlation& correlation) {
  Track& track = tracks_.at(correlation.slot);
  Detection* const detection = correlation.detection;
  const bool alone = tracks_.motion().joined() || (detection && bifurcation_.asSeenBy(track, *detection));
  if (alone && detection) return update(sector, correlation.slot, *detection);
  if (alone || (!detection && bifurcation_.mergedPlotOf(correlation.slot))) return;
  const bool claimed = detection && detection->claim != Detection::kNoClaim;
  const auto first = correlator_.chances().begin();
  plots_.assign(first + static_cast<std::ptrdiff_t>(correlation.first),
                first + static_cast<std::ptrdiff_t>(correlation.last));
  if (!detection) suspectStrays(track, radars_.at(sector.radar), sector.running);
  if (!tracks_.updateWeighed(correlation, plots_, sector, claimed && clutterOf(track).yields_to_tracks)) return;
  if (claimed && clutterYieldsTo(track)) clutter_.disclaim(detection->claim, sector.radar);
  const auto sure = [](const PlotChance& plot) { return plot.chance > 0.9; };
  if (detection && std::any_of(plots_.begin(), plots_.end(), sure))
    alignment_.add(tracks_.file(), correlation.slot, sector, *detection);
  meeting_.predict(track, siteOf(sector));
}

/// Illuminated and not detected by itself: it is merged in the detection of another track, if it still is another one.
void Adit::share(const tws::SectorRef& sector, TrackFile::Slot slot, const Detection& detection) {
  Track& track = tracks_.at(slot);
  if (bifurcation_.hasMerged(track, detection)) return tracks_.drop(slot, detection.plot.time);
  tracks_.share(slot, sector, detection.plot, *bifurcation_.asSeenBy(track, detection));
  meeting_.predict(track, siteOf(sector));
}

void Adit::miss(const tws::SectorRef& sector, TrackFile::Slot slot) {
  if (params_.association == Association::kChances)
    suspectStrays(tracks_.at(slot), radars_.at(sector.radar), sector.running);
  if (tracks_.miss(slot, sector)) meeting_.predict(tracks_.at(slot), siteOf(sector));
}

/// Is the track surely no clutter?
bool Adit::clutterYieldsTo(const Track& track) const {
  const Kinematics& k = track.smoothed;
  const double fast = params_.in(track.volume).conversion.speed_up;
  return clutterOf(track).yields_to_tracks && track.firm && k.vx * k.vx + k.vy * k.vy > fast * fast;
}

void Adit::convertSlowTracks(const tws::SectorRef& sector) {
  if (sector.radar != radars_.reference()) return;
  const auto judge_after = leastAgeToConvert(params_.conversion, radars_.antenna(sector.radar), sector.running,
                                             params_.conversion.scans / 2);
  if (!judge_after) return;
  const FalsePlotMap& map = radars_.quality(sector.radar).falsePlotMap();
  const auto is_slow = [&](TrackFile::Slot slot) {
    Track& track = tracks_.at(slot);
    return hasBecomeSlow(track, tracks_.motion(), map, *judge_after, params_.in(track.volume).conversion);
  };
  for (const auto slot : primary_) {
    if (!tracks_.isDropped(slot) && is_slow(slot)) convert(sector, slot);
  }
}

void Adit::convert(const tws::SectorRef& sector, TrackFile::Slot slot) {
  const Track& track = tracks_.at(slot);
  const double time = track.smoothed.time;
  const TrackMotion& motion = tracks_.motion();
  const std::size_t radar = motion.joined() ? latestOf(track, radars_.size()) : sector.radar;
  const ApparentPosition seen = motion.apparentPosition(track, radar, time);
  if (!clutter_.adopt(seen.range, seen.azimuth, time, radar)) return;
  ++counts_.to_clutter;
  tracks_.drop(slot, time);
}

/// What a radar of that period [s] has just made firm may be a target that was lost.
void Adit::stitch(double period) {
  for (const auto slot : tracks_.newlyFirm()) {
    if (const auto lost = tracks_.isDropped(slot) ? std::nullopt : stitching_.lostBefore(tracks_, slot, period))
      tracks_.succeed(slot, *lost);
  }
}

void Adit::moveOn(const tws::SectorRef& sector) {
  for (const auto slot : primary_) {
    if (!tracks_.isDropped(slot)) meeting_.moveOn(slot, sector.radar);
  }
}

/// What neither clutter nor tracks have used starts both: the clutter point will go on being updated, or the track
/// will. What may well be a track's starts nothing.
void Adit::initiate(const tws::SectorRef& sector) {
  constexpr double kRatherNew = 0.97;
  const std::int64_t behind = sector.running - kInitiationBehind;
  RadarState& radar = radars_.at(sector.radar);
  if (teller_.isOn()) teller_.tellBefore(sector.radar, radar.detections, behind);
  const bool tells = teller_.isOn() && radar.detections.at(behind).running == behind && behind >= 0;
  for (Detection& detection : radar.detections.at(behind).detections) {
    TrackFile::Slot track = detection.taker;
    if (tells) teller_.add(detection);
    if (!detection.used && detection.left > kRatherNew && !detection.isTaken()) {
      detection.used = true;
      track = startTrackOrBranch(sector, detection);
      if (tells && track != Detection::kNoTaker) teller_.started(tracks_.at(track).uid);
      if (detection.claim == Detection::kNoClaim) clutter_.initiate(detection.plot, sector.radar);
    }
    detection.used = true;
    if (detection.left > 0.0) learnFalse({sector.radar, behind}, detection, track);
  }
  radar.quality.falsePlotMap().close(tws::Antenna::sectorNumber(behind));
  if (tells) teller_.tell(sector.radar, behind);
}

/// As far as no track has made it, a plot is false. `slot`: of the track that has taken it or begins with it;
/// Detection::kNoTaker: there is none. If it is tentative, it remembers that its own plot was counted.
void Adit::learnFalse(const tws::SectorRef& sector, const Detection& detection, TrackFile::Slot slot) {
  radars_.at(sector.radar)
      .quality.falsePlotMap()
      .add(tws::Antenna::sectorNumber(sector.running), detection.plot.range, detection.left);
  radars_.quality(sector.radar).coverage().addPlot(detection.plot.range, detection.plot.azimuth, detection.left);
  if (slot == Detection::kNoTaker || tracks_.file().sector(slot, siteOf(sector)) < 0) return;
  Track& track = tracks_.at(slot);
  if (track.firm || track.updated[sector.radar] != detection.plot.time) return;
  float& counted = track.counted_false[sector.radar];
  counted = static_cast<float>(FalsePlotMap::kKept * counted + detection.left);
}

std::optional<TrackFile::Slot> Adit::startTrack(std::size_t radar, const tws::Plot& plot, bool from_clutter) {
  const auto slot = tracks_.create(radar, plot);
  if (!slot) return std::nullopt;
  // Met in a sector that is behind the front or at most a few ahead of it.
  tracks_.start(*slot, radar, from_clutter ? nullptr : &plot, tws::Antenna::near(plot.azimuth, order_.front(radar)));
  meeting_.enter(*slot, radars_.at(radar).site);
  return slot;
}

/// Returns its slot; Detection::kNoTaker: none was started.
TrackFile::Slot Adit::startTrackOrBranch(const tws::SectorRef& sector, const Detection& detection) {
  RadarState& radar = radars_.at(sector.radar);
  const auto parting =
      params_.bifurcation ? bifurcation_.partingOf(tracks_.file(), detection, radar, sector) : std::nullopt;
  const auto slot = startTrack(sector.radar, detection.plot);
  if (!slot) return Detection::kNoTaker;
  Track& track = tracks_.at(*slot);
  tracks_.doubtFirst(track, detection.left * detection.fresh);
  if (parting) {
    tracks_.branch(track, *parting, sector.radar);
    meeting_.predict(track, radar.site);
  }
  return *slot;
}

}  // namespace adit_tracker
