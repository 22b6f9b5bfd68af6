#include "adit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

constexpr std::int64_t kClutterAhead = 3;      // sectors that the clutter map runs ahead of the tracks
constexpr std::int64_t kInitiationBehind = 1;  // sectors that initiation runs behind them
constexpr int kSecondarySectors = 2;           // sectors ahead whose tracks take part in the correlation
// Plots beyond are mistakes: no radar sees further, and their squares must stay finite.
constexpr double kGreatestRange = 1e7;  // [m]
// A prediction that is off by less in time is not made anew.
constexpr double kPredictionTolerance = 0.3;  // [s]
// A track learns nothing about its radar's errors before it has settled.
constexpr int kSettled = 6;  // updates

int sectorNumber(std::int64_t running) { return tws::wrapSector(static_cast<int>(running % tws::kSectors)); }

/// The unwrapped azimuth of a direction, next to the given sector.
double unwrappedNear(double azimuth, std::int64_t running) {
  return Antenna::startOf(running) + tws::angularDifference(azimuth, tws::sectorStart(sectorNumber(running)));
}

std::size_t referenceIndex(const AditParams& params) {
  for (std::size_t i = 0; i < params.radars.size(); ++i) {
    if (params.radars[i].name == params.reference_radar) return i;
  }
  return params.radars.size() - 1;
}

AditParams checked(const AditParams& params) {
  check(params);
  return params;
}

}  // namespace

Adit::Adit(const AditParams& params, Sink sink)
    : params_(checked(params)),
      sink_(std::move(sink)),
      reference_(referenceIndex(params)),
      executive_(params.radars.size(), params.skew_limit),
      tracks_(params.capacity),
      correlator_(params),
      motion_(params),
      judge_(params) {
  for (const RadarParams& radar : params.radars) radars_.emplace_back(radar, params.learn_noise);
  const std::size_t maps = params.clutter.per_radar ? radars_.size() : 1;
  for (std::size_t i = 0; i < maps; ++i) clutter_.emplace_back(params.clutter, params.conversion);
}

void Adit::add(std::size_t radar, tws::RadarSector sector) {
  RadarState& state = radars_.at(radar);
  const std::int64_t newest = executive_.newest(radar);
  if (sector.running <= newest) {
    throw std::invalid_argument("radar " + params_.radars[radar].name + ": sector " + std::to_string(sector.running) +
                                " comes after sector " + std::to_string(newest));
  }
  const auto bad = [](const tws::Plot& p) {
    return !(std::isfinite(p.time) && std::isfinite(p.azimuth) && p.range > 0.0 && p.range <= kGreatestRange);
  };
  auto& plots = sector.plots;
  const std::size_t given = plots.size();
  plots.erase(std::remove_if(plots.begin(), plots.end(), bad), plots.end());
  counts_.rejected_plots += given - plots.size();
  counts_.plots += plots.size();
  if (!executive_.closed(radar, sector.running, sector.enter_time, sector.leave_time)) ++counts_.late_sectors;
  state.waiting.push_back(std::move(sector));
  run();
}

void Adit::finish() {
  executive_.finish();
  run();
}

void Adit::run() {
  while (const auto turn = executive_.next()) process(*turn);
}

/// Lets in what the turn may look at: the radar's sectors up to four ahead. What else has come must not matter, or the
/// result would depend on how the radars' messages interleave.
void Adit::admit(const Executive::Turn& turn) {
  RadarState& radar = radarOf(turn);
  auto& waiting = radar.waiting;
  for (; !waiting.empty() && waiting.front().running <= turn.running + Executive::kSectorsAhead; waiting.pop_front()) {
    const tws::RadarSector& sector = waiting.front();
    radar.antenna.mark(sector.running, sector.enter_time);
    radar.antenna.mark(sector.running + 1, sector.leave_time);
    radar.detections.add(sector);
    for (const tws::Plot& plot : sector.plots) radar.quality.saw(plot.range);
  }
}

/// Figure 3 of the report: one sector of the radar whose data are the oldest.
void Adit::process(const Executive::Turn& turn) {
  admit(turn);
  report_.radar = turn.radar;
  report_.running = turn.running;
  report_.enter_time = radarOf(turn).antenna.timeAt(Antenna::startOf(turn.running));
  report_.words.clear();
  dropped_.clear();
  mapClutter(turn);
  correlate(turn);
  convertSlowTracks(turn);
  for (const auto slot : primary_) moveOn(slot, turn.radar);
  initiate(turn);
  ++counts_.sectors;
  if (sink_) sink_(report_);
  for (const auto slot : dropped_) tracks_.drop(slot);
}

/// On every eighth scan, `offset` scans later for one thing than for the other: the least age [s] of a stored place for
/// the comparison; nothing: not on this scan.
std::optional<double> Adit::judgeAfter(std::size_t radar, std::int64_t running, long offset) const {
  const long scans = params_.conversion.scans;
  if (running / tws::kSectors % scans != offset) return std::nullopt;
  return 0.5 * static_cast<double>(scans) * radars_[radar].antenna.period();
}

void Adit::mapClutter(const Executive::Turn& turn) {
  RadarState& radar = radarOf(turn);
  const std::int64_t running = turn.running + kClutterAhead;
  const double now = radar.antenna.timeAt(Antenna::startOf(running + 1));
  // A common map is judged by the scans of the reference radar, a radar's own map by its own.
  const bool judges = params_.clutter.per_radar || turn.radar == reference_;
  const auto judge_after = judges ? judgeAfter(turn.radar, running, 0) : std::nullopt;
  for (const ClutterPoint& point : clutterOf(turn.radar).process(turn.radar, radar, running, now, judge_after)) {
    tws::Plot plot;
    plot.time = point.last_update;
    plot.range = point.range;
    plot.azimuth = point.azimuth;
    Track* const track = startTrack(turn.radar, plot);
    if (track == nullptr) continue;
    track->updated = point.updated;  // with one map for all, another radar may have seen it last
    ++counts_.to_track;
  }
}

/// The tracks in a sector that this radar has not met on this scan, each aimed at the radar's beam.
void Adit::listSector(const Executive::Turn& turn, std::int64_t running, Slots& slots) {
  const std::size_t begin = slots.size();
  tracks_.list(sectorNumber(running), slots);
  const auto met = [&](TrackFile::Slot s) { return metOnThisScan(tracks_.at(s), turn.radar, running); };
  slots.erase(std::remove_if(slots.begin() + static_cast<std::ptrdiff_t>(begin), slots.end(), met), slots.end());
  for (std::size_t i = begin; i < slots.size(); ++i) aimAt(tracks_.at(slots[i]), turn.radar, running);
}

/// Updated or missed: a track that has moved on into the next sector has had its chance all the same.
bool Adit::metOnThisScan(const Track& track, std::size_t radar, std::int64_t running) {
  return track.illuminated[radar] > Antenna::startOf(running) - tws::kPi;
}

/// Sees to it that the prediction is for this radar's beam in that sector. It mostly is already; not so when another
/// radar, which should have come first, is silent.
void Adit::aimAt(Track& track, std::size_t radar, std::int64_t running) {
  const double time = radars_[radar].antenna.timeAt(unwrappedNear(track.predicted.azimuth, running));
  if (track.predicted.radar == radar && std::abs(time - track.predicted.time) < kPredictionTolerance) return;
  motion_.predict(track, radar, time, radars_[radar].quality);
}

void Adit::correlate(const Executive::Turn& turn) {
  primary_.clear();
  secondary_.clear();
  listSector(turn, turn.running, primary_);
  if (primary_.empty()) return;
  for (int ahead = 1; ahead <= kSecondarySectors; ++ahead) listSector(turn, turn.running + ahead, secondary_);
  constexpr std::size_t kFetchAhead = 3;
  const auto& pairs = correlator_.correlate(tracks_, primary_, secondary_, radarOf(turn), turn.running);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i + kFetchAhead < pairs.size()) tracks_.fetchAhead(pairs[i + kFetchAhead].slot);
    update(turn, pairs[i].slot, *pairs[i].detection);
  }
  for (const auto slot : primary_) {
    if (!metOnThisScan(tracks_.at(slot), turn.radar, turn.running)) miss(turn, slot);
  }
}

/// Is the track settled and straight, so that its innovation shows the radar's own errors?
bool Adit::tellsErrors(const Track& track, const tws::Plot& plot) const {
  constexpr double kSurelyStraight = 0.9;
  return params_.learn_noise && std::isnan(plot.range_sigma) && track.firm && track.updates > kSettled &&
         std::get<TurningFilter>(track.filter).straightProbability() > kSurelyStraight;
}

/// Is the track surely no clutter?
bool Adit::clutterYieldsTo(const Track& track) const {
  const Kinematics& k = track.smoothed;
  return params_.clutter.yields_to_tracks && track.firm &&
         k.vx * k.vx + k.vy * k.vy > params_.conversion.speed_up * params_.conversion.speed_up;
}

void Adit::update(const Executive::Turn& turn, TrackFile::Slot slot, Detection& detection) {
  Track& track = tracks_.at(slot);
  RadarQuality& quality = radarOf(turn).quality;
  const tws::Plot& plot = detection.plot;
  if (tellsErrors(track, plot)) {
    const Prediction& p = track.predicted;
    quality.learnErrors((plot.range - p.range) / std::sqrt(p.innovation.xx),
                        p.range * tws::angularDifference(plot.azimuth, p.azimuth) / std::sqrt(p.innovation.yy));
  }
  const double log_likelihood = motion_.update(track, plot, quality);
  track.coasting = false;
  track.updated[turn.radar] = plot.time;
  track.illuminated[turn.radar] = unwrappedNear(plot.azimuth, turn.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by | 1U << turn.radar);
  // What a clutter point on probation claims is no evidence of movement: a tentative track waits for a better
  // detection.
  const bool disputed = params_.clutter.yields_to_tracks && detection.claim != Detection::kNoClaim;
  if (judge_.updated(track, turn.radar, log_likelihood, quality, !disputed)) ++counts_.tracks_firm;
  if (detection.claim != Detection::kNoClaim && clutterYieldsTo(track)) clutterOf(turn.radar).disclaim(detection.claim);
  report_.words.push_back({slot, TrackEvent::kUpdated, track.smoothed.time});
  predictNext(track);
}

/// Illuminated and not detected: the track coasts by its stored velocities, or has had its time.
void Adit::miss(const Executive::Turn& turn, TrackFile::Slot slot) {
  Track& track = tracks_.at(slot);
  track.illuminated[turn.radar] = unwrappedNear(track.predicted.azimuth, turn.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by & ~(1U << turn.radar));
  track.coasting = true;
  const double time = track.predicted.time;
  if (judge_.missed(track, turn.radar, time)) {
    drop(slot, time);
  } else {
    report_.words.push_back({slot, TrackEvent::kCoasted, time});
    predictNext(track);
  }
}

void Adit::drop(TrackFile::Slot slot, double time) {
  report_.words.push_back({slot, TrackEvent::kDropped, time});
  dropped_.push_back(slot);
  ++counts_.tracks_dropped;
}

void Adit::convertSlowTracks(const Executive::Turn& turn) {
  if (turn.radar != reference_) return;
  const auto judge_after = judgeAfter(turn.radar, turn.running, params_.conversion.scans / 2);
  if (!judge_after) return;
  for (const auto slot : primary_) {
    Track& track = tracks_.at(slot);
    const bool gone = std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end();
    if (gone || !hasBecomeSlow(track, *judge_after)) continue;
    const Kinematics& k = track.smoothed;
    if (!clutterOf(turn.radar).adopt(k.range, k.azimuth, k.time, turn.radar)) {
      ++counts_.refused_clutter;
      continue;
    }
    ++counts_.to_clutter;
    drop(slot, k.time);
  }
}

/// Compares the place with the one stored eight scans ago, and stores the present one.
bool Adit::hasBecomeSlow(Track& track, double judge_after) const {
  const Kinematics& k = track.smoothed;
  const auto rates = track.reference.compare(k.time, k.range, k.azimuth, judge_after);
  return rates && !isFaster(rates->range, rates->azimuth, k.range, params_.conversion.speed_down, params_.conversion);
}

/// What neither clutter nor tracks have used starts both: the clutter point will go on being updated, or the track
/// will.
void Adit::initiate(const Executive::Turn& turn) {
  RadarState& radar = radarOf(turn);
  std::size_t unused = 0;
  for (Detection& detection : radar.detections.at(turn.running - kInitiationBehind).detections) {
    if (detection.used) continue;
    detection.used = true;
    ++unused;
    startTrack(turn.radar, detection.plot);
    if (detection.claim != Detection::kNoClaim) continue;
    if (!clutterOf(turn.radar).initiate(detection.plot, turn.radar)) ++counts_.refused_clutter;
  }
  radar.quality.learnFalsePlots(unused);
}

Track* Adit::startTrack(std::size_t radar, const tws::Plot& plot) {
  const auto slot = tracks_.start();
  if (!slot) {
    ++counts_.refused_tracks;
    return nullptr;
  }
  Track& track = tracks_.at(*slot);
  const RadarQuality& quality = radars_[radar].quality;
  motion_.start(track, plot, quality);
  judge_.started(track, quality);
  track.updated[radar] = plot.time;
  // Met in a sector that is behind the front or at most a few ahead of it.
  track.illuminated[radar] = unwrappedNear(plot.azimuth, executive_.front(radar));
  track.detected_by = static_cast<std::uint16_t>(1U << radar);
  if (params_.conversion.from_start) track.reference = {plot.time, plot.range, plot.azimuth};
  predictNext(track);
  tracks_.place(*slot, tws::sectorOf(track.predicted.azimuth));
  ++counts_.tracks_started;
  report_.words.push_back({*slot, TrackEvent::kStarted, plot.time});
  return &track;
}

/// Puts the track into the sector where its next illumination will be.
void Adit::moveOn(TrackFile::Slot slot, std::size_t radar) {
  if (!dropped_.empty() && std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end()) return;
  const int from = tracks_.sector(slot);
  int to = tws::sectorOf(tracks_.at(slot).predicted.azimuth);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (other != radar && from != to && wouldMissUpdate(from, to, other)) to = from;
  }
  tracks_.place(slot, to);
}

/// Has the other radar's processing passed the new sector, but not the old one? Then the track stays where it is.
bool Adit::wouldMissUpdate(int from, int to, std::size_t radar) const {
  if (!radars_[radar].antenna.known() || executive_.silent(radar)) return false;
  const int front = sectorNumber(executive_.front(radar));
  return tws::sectorDifference(from, front) >= 0 && tws::sectorDifference(to, front) < 0 &&
         std::abs(tws::sectorDifference(to, from)) < tws::kSectors / 4;
}

/// When the beam of a radar meets the track next, in a sector that is still to be processed [s].
double Adit::nextIllumination(const Track& track, std::size_t radar) const {
  const Antenna& antenna = radars_[radar].antenna;
  const double earliest = std::max(Antenna::startOf(executive_.front(radar)), track.illuminated[radar] + tws::kPi);
  const auto atLeast = [&](double azimuth) { return earliest + tws::wrapTwoPi(azimuth - earliest); };
  const double guess = atLeast(track.smoothed.azimuth);
  // Right over the site, azimuth rates have no meaning: half a turn at most.
  const double moved =
      std::clamp(track.smoothed.azimuth_rate * (antenna.timeAt(guess) - track.smoothed.time), -tws::kPi, tws::kPi);
  double crossing = guess + moved;
  if (crossing < earliest) crossing += tws::kTwoPi;
  return antenna.timeAt(crossing);
}

/// T2 of the report: the earliest next time that any radar will illuminate the track.
void Adit::predictNext(Track& track) {
  std::size_t next = radars_.size();
  double earliest = 0.0;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (!radars_[radar].antenna.known() || executive_.silent(radar)) continue;
    const double time = nextIllumination(track, radar);
    if (next < radars_.size() && time >= earliest) continue;
    next = radar;
    earliest = time;
  }
  if (next == radars_.size()) return;  // all radars are silent: the sectors still in hand are the last
  motion_.predict(track, next, earliest, radars_[next].quality);
}

std::vector<TrackFile::Slot> Adit::living() const {
  Slots all;
  for (int sector = 0; sector < tws::kSectors; ++sector) tracks_.list(sector, all);
  return all;
}

}  // namespace adit_tracker
