#include "core/adit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

constexpr std::int64_t kInitiationBehind = 1;  // sectors that initiation runs behind them
constexpr int kSecondarySectors = 2;           // sectors ahead whose tracks take part in the correlation

bool isCopy(const tws::Plot& a, const tws::Plot& b) {
  return a.time == b.time && a.range == b.range && a.azimuth == b.azimuth;
}

/// Takes out what says the same as a plot shortly before it; all are in order of time. Returns how many.
std::size_t dropCopies(std::vector<tws::Plot>& plots) {
  constexpr std::size_t kLookBack = 64;  // plots of one time
  std::size_t kept = 0;
  for (const tws::Plot& plot : plots) {
    const std::size_t least = kept - std::min(kept, kLookBack);
    std::size_t i = kept;
    while (i > least && plots[i - 1].time == plot.time && !isCopy(plots[i - 1], plot)) --i;
    if (i == least || plots[i - 1].time != plot.time) plots[kept++] = plot;
  }
  const std::size_t dropped = plots.size() - kept;
  plots.resize(kept);
  return dropped;
}

AditParams checked(const AditParams& params) {
  check(params);
  return params;
}

}  // namespace

Adit::Adit(const AditParams& params, Sink sink)
    : params_(checked(params)),
      sink_(std::move(sink)),
      reference_(radarIndex(params, params.reference_radar)),
      order_(params.radars.size(), params.skew_limit, kSectorsAhead),
      tracks_(params.capacity),
      correlator_(params),
      motion_(params),
      bifurcation_(params),
      judge_(params),
      heights_(params.elevation),
      iff_(params.iff) {
  for (const RadarParams& radar : params.radars) radars_.emplace_back(radar, params.learn_noise);
  const std::size_t maps = params.clutter.per_radar ? radars_.size() : 1;
  for (std::size_t i = 0; i < maps; ++i) clutter_.emplace_back(params.clutter, params.conversion);
  awaited_clutter_.resize(maps);
}

void Adit::add(std::size_t radar, tws::RadarSector sector) {
  take(radar, std::move(sector));
  while (step()) continue;
}

void Adit::take(std::size_t radar, tws::RadarSector sector) {
  RadarState& state = radars_.at(radar);
  const std::int64_t newest = order_.newest(radar);
  if (sector.running <= newest) {
    throw std::invalid_argument("radar " + params_.radars[radar].name + ": sector " + std::to_string(sector.running) +
                                " comes after sector " + std::to_string(newest));
  }
  sift(radar, sector);
  counts_.plots += sector.plots.size();
  if (!order_.add({radar, sector.running}, sector.enter_time, sector.leave_time)) ++counts_.late_sectors;
  state.waiting.push_back(std::move(sector));
  ++taken_;
}

/// Takes out what makes no sense, what comes too late, and what has come already.
void Adit::sift(std::size_t radar, tws::RadarSector& sector) {
  const double earliest = sector.enter_time - radars_[radar].antenna.sectorDuration();
  const auto sift_out = [&](std::uint64_t AditCounts::*count, const auto& unusable) {
    const auto end = std::remove_if(sector.plots.begin(), sector.plots.end(), unusable);
    counts_.*count += static_cast<std::uint64_t>(sector.plots.end() - end);
    sector.plots.erase(end, sector.plots.end());
  };
  sift_out(&AditCounts::rejected_plots, [](const tws::Plot& p) {
    return !(std::isfinite(p.time) && std::isfinite(p.azimuth) && p.range > 0.0 && p.range <= kFarthest);
  });
  sift_out(&AditCounts::late_plots, [&](const tws::Plot& p) { return p.time < earliest; });
  sift_out(&AditCounts::duplicate_plots,
           [&](const tws::Plot& p) { return p.time < sector.enter_time && cameBefore(radar, sector.running, p); });
  counts_.duplicate_plots += dropCopies(sector.plots);
}

/// Did the sector before hold this plot already?
bool Adit::cameBefore(std::size_t radar, std::int64_t running, const tws::Plot& plot) {
  const auto& waiting = radars_[radar].waiting;
  const auto same = [&](const tws::Plot& other) { return isCopy(other, plot); };
  if (!waiting.empty()) return std::any_of(waiting.back().plots.begin(), waiting.back().plots.end(), same);
  const auto& before = radars_[radar].detections.at(running - 1).detections;
  return std::any_of(before.begin(), before.end(), [&](const Detection& d) { return same(d.plot); });
}

void Adit::finish() {
  order_.finish();
  while (step()) continue;
}

bool Adit::step() {
  const auto turn = order_.next();
  if (turn) process(*turn);
  return turn.has_value();
}

void Adit::skip() {
  std::vector<std::size_t> left = ready();
  while (true) {
    const auto turn = order_.next();
    if (!turn) return;
    pass(*turn, static_cast<std::int64_t>(left[turn->radar]--) <= kClutterAhead);
  }
}

/// Lets in what the turn may look at: the radar's sectors up to four ahead. What else has come must not matter, or the
/// result would depend on how the radars' messages interleave.
void Adit::admit(const tws::SectorRef& turn) {
  RadarState& radar = radarOf(turn);
  auto& waiting = radar.waiting;
  for (; !waiting.empty() && waiting.front().running <= turn.running + kSectorsAhead; waiting.pop_front()) {
    const tws::RadarSector& sector = waiting.front();
    radar.antenna.cross(sector.running, sector.enter_time);
    radar.antenna.cross(sector.running + 1, sector.leave_time);
    radar.detections.add(sector);
    for (const tws::Plot& plot : sector.plots) radar.quality.saw(plot.range);
  }
}

void Adit::begin(const tws::SectorRef& turn) {
  if (!radarOf(turn).joined) joinSite(turn.radar);
  admit(turn);
  report_.radar = turn.radar;
  report_.running = turn.running;
  report_.enter_time = radarOf(turn).antenna.timeAt(tws::Antenna::startOf(turn.running));
  report_.skipped = false;
  iff_.apply(report_.enter_time, tracks_, motion_);
  report_.words = by_hand_;
  dropped_.clear();
  for (const TrackWord& word : by_hand_) {
    if (word.event == TrackEvent::kDropped) dropped_.push_back(word.slot);
  }
  by_hand_.clear();
  loadAwaitedClutter(turn);
}

/// Figure 3 of the report: one sector of the radar whose data are the oldest.
void Adit::process(const tws::SectorRef& turn) {
  begin(turn);
  mapClutter(turn.radar, turn.running + kClutterAhead);
  correlate(turn);
  convertSlowTracks(turn);
  for (const auto slot : primary_) moveOn(slot, turn.radar);
  initiate(turn);
  end();
}

void Adit::end() {
  ++counts_.sectors;
  if (sink_) sink_(report_);
  for (const auto slot : dropped_) {
    heights_.remove(tracks_.at(slot).uid);
    tracks_.drop(slot);
  }
}

/// A sector that is skipped. The clutter map must have seen those that are not any more.
void Adit::pass(const tws::SectorRef& turn, bool map_clutter) {
  begin(turn);
  report_.skipped = true;
  ++counts_.skipped_sectors;
  if (map_clutter) mapClutter(turn.radar, turn.running + kClutterAhead);
  for (Detection& detection : radarOf(turn).detections.at(turn.running).detections) detection.used = true;
  primary_.clear();
  listSector(turn, turn.running, primary_);
  for (const auto slot : primary_) {
    Track& track = tracks_.at(slot);
    track.illuminated[turn.radar] = tws::Antenna::near(track.predicted.azimuth, turn.running);
    predictNext(track, radarOf(turn).site);
    moveOn(slot, turn.radar);
  }
  end();
}

/// On every eighth scan, `offset` scans later for one thing than for the other: the least age [s] of a stored place for
/// the comparison; nothing: not on this scan.
std::optional<double> Adit::judgeAfter(std::size_t radar, std::int64_t running, long offset) const {
  const long scans = params_.conversion.scans;
  if (running / tws::kSectors % scans != offset) return std::nullopt;
  return 0.5 * static_cast<double>(scans) * radars_[radar].antenna.period();
}

/// The tracks in a sector that this radar has not met on this scan, each aimed at the radar's beam.
void Adit::listSector(const tws::SectorRef& turn, std::int64_t running, Slots& slots) {
  const std::size_t begin = slots.size();
  tracks_.list(tws::Antenna::sectorNumber(running), slots, radarOf(turn).site);
  const auto met = [&](TrackFile::Slot s) { return metOnThisScan(tracks_.at(s), turn.radar, running); };
  slots.erase(std::remove_if(slots.begin() + static_cast<std::ptrdiff_t>(begin), slots.end(), met), slots.end());
  for (std::size_t i = begin; i < slots.size(); ++i) aimAt(tracks_.at(slots[i]), turn.radar, running);
}

void Adit::correlate(const tws::SectorRef& turn) {
  primary_.clear();
  secondary_.clear();
  listSector(turn, turn.running, primary_);
  if (primary_.empty()) return;
  for (int ahead = 1; ahead <= kSecondarySectors; ++ahead) listSector(turn, turn.running + ahead, secondary_);
  constexpr std::size_t kFetchAhead = 3;
  const auto& pairs =
      correlator_.correlate(tracks_, primary_, secondary_, radarOf(turn), turn.running, radarOf(turn).site);
  if (params_.bifurcation) bifurcation_.share(tracks_, motion_, correlator_, pairs, primary_, radarOf(turn), turn);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i + kFetchAhead < pairs.size()) tracks_.fetchAhead(pairs[i + kFetchAhead].slot);
    update(turn, pairs[i].slot, *pairs[i].detection);
  }
  for (const auto slot : primary_) {
    if (metOnThisScan(tracks_.at(slot), turn.radar, turn.running)) continue;
    const Detection* const shared = bifurcation_.hiding(slot);
    shared ? hide(turn, slot, *shared) : miss(turn, slot);
  }
}

/// Is the track settled and straight, so that its innovation shows the radar's own errors?
bool Adit::tellsErrors(const Track& track, const tws::Plot& plot) const {
  constexpr double kSurelyStraight = 0.9;
  return params_.learn_noise && std::isnan(plot.range_sigma) && !track.predicted.vague_height && track.firm &&
         track.updates > kSettledUpdates &&
         std::get<tws::MultipleModelFilter>(track.filter).straightProbability() > kSurelyStraight;
}

/// Is the track surely no clutter?
bool Adit::clutterYieldsTo(const Track& track) const {
  const Kinematics& k = track.smoothed;
  return params_.clutter.yields_to_tracks && track.firm &&
         k.vx * k.vx + k.vy * k.vy > params_.conversion.speed_up * params_.conversion.speed_up;
}

void Adit::update(const tws::SectorRef& turn, TrackFile::Slot slot, Detection& detection) {
  Track& track = tracks_.at(slot);
  RadarQuality& quality = radarOf(turn).quality;
  const tws::Plot& plot = detection.plot;
  const tws::Plot* const merged = bifurcation_.asSeenBy(track, detection);
  if (merged == nullptr && tellsErrors(track, plot)) {
    const Prediction& p = track.predicted;
    quality.learnErrors((plot.range - p.range) / std::sqrt(p.innovation.xx),
                        p.range * tws::angularDifference(plot.azimuth, p.azimuth) / std::sqrt(p.innovation.yy));
  }
  const double log_likelihood = motion_.update(track, merged ? *merged : plot, quality, turn.radar);
  if (merged == nullptr) {
    track.apart = plot.time;
    heights_.update(track.uid, plot);
  }
  track.coasting = false;
  track.updated[turn.radar] = plot.time;
  track.illuminated[turn.radar] = tws::Antenna::near(plot.azimuth, turn.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by | 1U << turn.radar);
  // What a clutter point on probation claims is no evidence of movement: a tentative track waits for a better
  // detection.
  const bool disputed = params_.clutter.yields_to_tracks && detection.claim != Detection::kNoClaim;
  if (judge_.updated(track, turn.radar, log_likelihood, quality, !disputed)) ++counts_.tracks_firm;
  if (detection.claim != Detection::kNoClaim && clutterYieldsTo(track)) clutterOf(turn.radar).disclaim(detection.claim);
  report_.words.push_back({slot, TrackEvent::kUpdated, track.smoothed.time});
  predictNext(track, radarOf(turn).site);
}

/// Illuminated and not detected by itself: it shares the detection of another track, if it still is another one.
void Adit::hide(const tws::SectorRef& turn, TrackFile::Slot slot, const Detection& detection) {
  Track& track = tracks_.at(slot);
  if (bifurcation_.hasMerged(track, detection)) return drop(slot, detection.plot.time);
  const std::int32_t updates = track.updates;
  if (updates > kSettledUpdates) {
    motion_.update(track, *bifurcation_.asSeenBy(track, detection), radarOf(turn).quality, turn.radar);
    track.updated[turn.radar] = detection.plot.time;
  }
  track.updates = updates;  // no evidence
  judge_.hidden(track, detection.plot.time);
  track.coasting = false;
  track.illuminated[turn.radar] = tws::Antenna::near(detection.plot.azimuth, turn.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by | 1U << turn.radar);
  report_.words.push_back({slot, TrackEvent::kUpdated, std::max(track.smoothed.time, detection.plot.time)});
  predictNext(track, radarOf(turn).site);
}

/// Illuminated and not detected: the track coasts by its stored velocities, or has had its time.
void Adit::miss(const tws::SectorRef& turn, TrackFile::Slot slot) {
  Track& track = tracks_.at(slot);
  track.illuminated[turn.radar] = tws::Antenna::near(track.predicted.azimuth, turn.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by & ~(1U << turn.radar));
  if (outOfReach(track, radarOf(turn).quality)) return predictNext(track, radarOf(turn).site);
  track.coasting = true;
  const double time = track.predicted.time;
  if (judge_.missed(track, turn.radar, time)) {
    drop(slot, time);
  } else {
    report_.words.push_back({slot, TrackEvent::kCoasted, time});
    predictNext(track, radarOf(turn).site);
  }
}

void Adit::drop(TrackFile::Slot slot, double time) {
  report_.words.push_back({slot, TrackEvent::kDropped, time});
  dropped_.push_back(slot);
  ++counts_.tracks_dropped;
}

void Adit::convertSlowTracks(const tws::SectorRef& turn) {
  if (turn.radar != reference_) return;
  const auto judge_after = judgeAfter(turn.radar, turn.running, params_.conversion.scans / 2);
  if (!judge_after) return;
  for (const auto slot : primary_) {
    Track& track = tracks_.at(slot);
    const bool gone = std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end();
    if (gone || !hasBecomeSlow(track, *judge_after)) continue;
    const Kinematics& k = track.smoothed;
    const std::size_t radar = motion_.joined() ? latestOf(track) : turn.radar;
    const Seen seen = motion_.seenBy(track, radar, k.time);
    if (!clutterOf(radar).adopt(seen.range, seen.azimuth, k.time, radar)) {
      ++counts_.refused_clutter;
      continue;
    }
    ++counts_.to_clutter;
    drop(slot, k.time);
  }
}

/// The radar that updated a track last: at another site, it may be the only one that sees it.
std::size_t Adit::latestOf(const Track& track) const {
  const auto end = track.updated.begin() + static_cast<std::ptrdiff_t>(radars_.size());
  return static_cast<std::size_t>(std::max_element(track.updated.begin(), end) - track.updated.begin());
}

/// Compares the place with the one stored eight scans ago, and stores the present one.
bool Adit::hasBecomeSlow(Track& track, double judge_after) const {
  const Kinematics& k = track.smoothed;
  const auto rates = track.reference.compare(k.time, k.range, k.azimuth, judge_after);
  return rates && !isFaster(rates->range, rates->azimuth, k.range, params_.conversion.speed_down, params_.conversion);
}

/// What neither clutter nor tracks have used starts both: the clutter point will go on being updated, or the track
/// will.
void Adit::initiate(const tws::SectorRef& turn) {
  RadarState& radar = radarOf(turn);
  std::size_t unused = 0;
  for (Detection& detection : radar.detections.at(turn.running - kInitiationBehind).detections) {
    if (detection.used) continue;
    detection.used = true;
    ++unused;
    startTrackOrBranch(turn, detection);
    if (detection.claim != Detection::kNoClaim) continue;
    if (!clutterOf(turn.radar).initiate(detection.plot, turn.radar)) ++counts_.refused_clutter;
  }
  radar.quality.learnFalsePlots(unused);
}

}  // namespace adit_tracker
