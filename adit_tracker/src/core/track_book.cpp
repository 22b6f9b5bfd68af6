#include "core/track_book.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {

TrackBook::TrackBook(const AditParams& params, Radars& radars, AditCounts& counts)
    : learn_noise_(params.learn_noise),
      reference_from_start_(params.conversion.from_start),
      longest_gap_(params.coverage.longest_gap),
      radars_(radars),
      counts_(counts),
      tracks_(params.capacity),
      motion_(params),
      judge_(params),
      heights_(params.elevation) {}

void TrackBook::begin(const tws::SectorRef& sector, double enter_time) {
  report_.radar = sector.radar;
  report_.running = sector.running;
  report_.enter_time = enter_time;
  report_.skipped = false;
  report_.updates = by_hand_;
  dropped_.clear();
  newly_firm_.clear();
  for (const TrackUpdate& update : by_hand_) {
    if (update.event == TrackEvent::kDropped) dropped_.push_back(update.slot);
  }
  by_hand_.clear();
}

void TrackBook::end() {
  for (const auto slot : dropped_) {
    lost_.erase(slot);
    heights_.remove(tracks_.at(slot).uid);
    tracks_.drop(slot);
  }
}

void TrackBook::tellAsMeasured(const PlaneOrigin& origin, const Passage& ship) {
  for (TrackUpdate& update : report_.updates) {
    if (!std::isnan(update.plot_range)) asMeasured(origin, ship, update.time, update.plot_range, update.plot_azimuth);
  }
}

bool TrackBook::isDropped(Slot slot) const {
  return !dropped_.empty() && std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end();
}

std::optional<TrackBook::Slot> TrackBook::create(std::size_t radar, const tws::Plot& plot) {
  const auto slot = tracks_.start();
  if (!slot) {
    ++counts_.refused_tracks;
    return std::nullopt;
  }
  Track& track = tracks_.at(*slot);
  const double by_rate = motion_.start(track, plot, radars_.quality(radar), radar);
  const double false_plots = radars_.quality(radar).falsePlotMap().perScanAsAt(plot.range, plot.azimuth);
  judge_.started(track, false_plots * std::exp(-by_rate));
  heights_.update(track.uid, plot);
  track.apart = plot.time;
  if (radars_.severalSites()) doubtOtherSites(track, radar);
  const bool elsewhere = motion_.joined();
  if (reference_from_start_) {
    track.reference = {plot.time, elsewhere ? track.smoothed.range : plot.range,
                       elsewhere ? track.smoothed.azimuth : plot.azimuth};
  }
  ++counts_.tracks_started;
  return slot;
}

/// Whether a radar of another site sees the target at all, nobody knows yet.
void TrackBook::doubtOtherSites(Track& track, std::size_t radar) const {
  constexpr float kPerhaps = 0.3F;
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (radars_.at(other).site != radars_.at(radar).site) track.detection_probability[other] = kPerhaps;
  }
}

void TrackBook::doubtFirst(Track& track, double own) const {
  track.existence *= static_cast<float>(own);
  track.first_existence *= static_cast<float>(own);
}

void TrackBook::start(Slot slot, std::size_t radar, const tws::Plot* plot, double unwrapped_azimuth) {
  Track& track = tracks_.at(slot);
  track.updated[radar] = track.first_time;
  track.illuminated[radar] = unwrapped_azimuth;
  track.detected_by = static_cast<std::uint16_t>(1U << radar);
  report_.updates.emplace_back(slot, TrackEvent::kStarted, track.first_time);
  if (plot != nullptr) report_.updates.back() = {slot, TrackEvent::kStarted, track.first_time, *plot};
}

void TrackBook::branch(Track& track, const Parting& parting, std::size_t radar) {
  const Track& parent = tracks_.at(parting.parent);
  motion_.branch(track, parent, parting, radar);
  track.parent = parent.uid;
  track.existence = track.first_existence = static_cast<float>(parting.chance);
}

/// Is the track settled and straight, so that its innovation shows the radar's own errors?
bool TrackBook::showsErrors(const Track& track, const tws::Plot& plot) const {
  constexpr double kSurelyStraight = 0.9;
  return learn_noise_ && std::isnan(plot.range_sigma) && !track.predicted.vague_height && track.firm &&
         track.updates > kSettledUpdates &&
         std::get<tws::MultipleModelFilter>(track.filter).straightProbability() > kSurelyStraight;
}

void TrackBook::update(Slot slot, const tws::SectorRef& sector, RadarQuality& quality, const tws::Plot& plot,
                       const tws::Plot* merged, bool disputed) {
  Track& track = tracks_.at(slot);
  look(track, quality, 1.0);
  if (merged == nullptr && showsErrors(track, plot)) {
    const Prediction& p = track.predicted;
    quality.learnErrors((plot.range - p.range) / std::sqrt(p.innovation.xx),
                        p.range * tws::angularDifference(plot.azimuth, p.azimuth) / std::sqrt(p.innovation.yy));
  }
  const double log_likelihood = motion_.update(track, merged ? *merged : plot, quality, sector.radar);
  if (merged == nullptr) {
    track.apart = plot.time;
    heights_.update(track.uid, plot);
  }
  enterVolume(track);
  setCoasting(slot, false);
  track.updated[sector.radar] = plot.time;
  track.illuminated[sector.radar] = tws::Antenna::near(plot.azimuth, sector.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by | 1U << sector.radar);
  const double own = track.firm ? 0.0 : track.counted_false[sector.radar];
  const double false_density = quality.falsePlotMap().densityAround(own, plot.range, plot.azimuth);
  if (judge_.updated(track, sector.radar, log_likelihood, false_density, !disputed)) becomeFirm(slot);
  report_.updates.push_back({slot, TrackEvent::kUpdated, track.smoothed.time, plot});
}

/// The track has moved: other parameters may be its own from now on.
void TrackBook::enterVolume(Track& track) const {
  if (!motion_.hasVolumes()) return;
  const std::optional<Height> height = heights_.at(track.uid, track.smoothed.time);
  const HeightGuess& guess = track.height_guess;
  const double guessed = guess.known() ? static_cast<double>(guess.height) : std::numeric_limits<double>::quiet_NaN();
  motion_.enterVolume(track, height ? height->height : guessed);
}

bool TrackBook::updateWeighed(const Correlation& c, const std::vector<PlotChance>& plots, const tws::SectorRef& sector,
                              bool disputed) {
  Track& track = tracks_.at(c.slot);
  RadarQuality& quality = radars_.quality(sector.radar);
  const double time = c.detection ? c.detection->plot.time : track.predicted.time;
  const bool detected = c.missed < 0.5;
  const auto bit = static_cast<std::uint16_t>(1U << sector.radar);
  track.illuminated[sector.radar] = tws::Antenna::near(track.predicted.azimuth, sector.running);
  motion_.update(track, plots, c.missed, time, quality);
  setCoasting(c.slot, !detected);
  track.detected_by = static_cast<std::uint16_t>(detected ? track.detected_by | bit : track.detected_by & ~bit);
  if (detected) {
    ++track.updates;
    track.last_update = std::max(track.last_update, time);
    track.updated[sector.radar] = time;
  }
  if (c.detection != nullptr) {
    track.apart = time;
    heights_.update(track.uid, c.detection->plot);
  }
  enterVolume(track);
  if (judge_.weighed(track, sector.radar, time, c.existence, c.missed, !disputed)) becomeFirm(c.slot);
  look(track, quality, 1.0 - c.missed);
  if (judge_.isOver(track) || (!detected && leavesCover(track, time))) {
    drop(c.slot, time);
    return false;
  }
  if (!detected) {
    report_.updates.push_back({c.slot, TrackEvent::kCoasted, time});
    return true;
  }
  const auto less = [](const PlotChance& a, const PlotChance& b) { return a.chance < b.chance; };
  const Detection& likeliest = *std::max_element(plots.begin(), plots.end(), less)->detection;
  report_.updates.push_back({c.slot, TrackEvent::kUpdated, time, c.detection ? c.detection->plot : likeliest.plot});
  return true;
}

void TrackBook::share(Slot slot, const tws::SectorRef& sector, const tws::Plot& plot, const tws::Plot& merged) {
  Track& track = tracks_.at(slot);
  const std::int32_t updates = track.updates;
  if (updates > kSettledUpdates) {
    motion_.update(track, merged, radars_.quality(sector.radar), sector.radar);
    track.updated[sector.radar] = plot.time;
    enterVolume(track);
  }
  track.updates = updates;  // no evidence
  judge_.unresolved(track, plot.time);
  setCoasting(slot, false);
  track.illuminated[sector.radar] = tws::Antenna::near(plot.azimuth, sector.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by | 1U << sector.radar);
  report_.updates.push_back({slot, TrackEvent::kUpdated, std::max(track.smoothed.time, plot.time), plot});
}

/// What a firm track shows of the radar whose beam has met it.
void TrackBook::look(const Track& track, RadarQuality& quality, double seen) const {
  if (longest_gap_ > 0.0 && track.firm)
    quality.coverage().look(track.predicted.range, track.predicted.azimuth, seen, judge_.chanceOf(track));
}

/// It has met nothing yet, or sent nothing for so long that it will not see the track again in time.
bool TrackBook::isSilent(std::size_t radar, double time) const {
  const tws::Antenna& antenna = radars_.antenna(radar);
  return !radars_.quality(radar).coverage().hasLooked() || !antenna.known() ||
         antenna.timeAt(tws::Antenna::startOf(antenna.newest())) < time - longest_gap_;
}

/// Does no radar see a target there, nor where it will be in the next while?
bool TrackBook::leavesCover(const Track& track, double time) const {
  if (longest_gap_ == 0.0 || !track.firm) return false;
  constexpr double kStep = 5.0;  // [s]
  for (double ahead = 0.0; ahead <= longest_gap_; ahead += kStep) {
    for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
      if (isSilent(radar, time)) continue;
      const ApparentPosition there = apparentPosition(track, radar, time + ahead);
      if (!radars_.quality(radar).coverage().isBlind(there.range, there.azimuth)) return false;
    }
  }
  return true;
}

/// Is the target of one site beyond the reach of the other's radar? Then it is not missed there.
bool TrackBook::outOfReach(const Track& track, const RadarQuality& quality) const {
  constexpr double kRecently = 30.0;  // [s]
  return radars_.severalSites() && track.predicted.range > quality.falsePlotMap().greatestRange() &&
         track.predicted.time - track.last_update < kRecently;
}

bool TrackBook::miss(Slot slot, const tws::SectorRef& sector) {
  Track& track = tracks_.at(slot);
  track.illuminated[sector.radar] = tws::Antenna::near(track.predicted.azimuth, sector.running);
  track.detected_by = static_cast<std::uint16_t>(track.detected_by & ~(1U << sector.radar));
  if (outOfReach(track, radars_.quality(sector.radar))) return true;
  setCoasting(slot, true);
  const double time = track.predicted.time;
  const bool over = judge_.missed(track, sector.radar, time);
  look(track, radars_.quality(sector.radar), 0.0);
  const bool dropped = over || leavesCover(track, time);
  if (dropped) {
    drop(slot, time);
  } else {
    report_.updates.push_back({slot, TrackEvent::kCoasted, time});
  }
  return !dropped;
}

void TrackBook::drop(Slot slot, double time) {
  report_.updates.push_back({slot, TrackEvent::kDropped, time});
  dropped_.push_back(slot);
  ++counts_.tracks_dropped;
}

void TrackBook::setCoasting(Slot slot, bool coasting) {
  Track& track = tracks_.at(slot);
  if (coasting && track.firm) lost_.insert(slot);
  if (!coasting && track.coasting) lost_.erase(slot);
  track.coasting = coasting;
}

void TrackBook::becomeFirm(Slot slot) {
  if (tracks_.at(slot).coasting) lost_.insert(slot);
  ++counts_.tracks_firm;
  motion_.learnSpeed(tracks_.at(slot));
  newly_firm_.push_back(slot);
}

void TrackBook::succeed(Slot found, Slot lost) {
  Track& heir = tracks_.at(found);
  Track& track = tracks_.at(lost);
  std::swap(heir.number, track.number);
  std::swap(heir.uid, track.uid);
  heir.handed_off = track.handed_off;
  heir.designated = track.designated;
  drop(lost, heir.smoothed.time);
  ++counts_.stitched;
}

void TrackBook::dropByHand(Slot slot) {
  tracks_.withdraw(slot);
  reportByHand(slot, TrackEvent::kDropped);
  ++counts_.tracks_dropped;
}

void TrackBook::moveOrigin(double dx, double dy) {
  for (const auto slot : living()) motion_.moveOrigin(tracks_.at(slot), dx, dy);
}

void TrackBook::join(const std::vector<tws::SiteFrame>& frames, const tws::EarthPlane& plane) {
  const bool first_time = !motion_.joined();
  motion_.join(frames, plane);
  if (!first_time) return;
  for (const auto slot : living()) motion_.guessHeight(tracks_.at(slot));
}

ApparentPosition TrackBook::apparentPosition(const Track& track, std::size_t radar, double time) const {
  if (motion_.joined()) return motion_.apparentPosition(track, radar, time);
  const Kinematics k = motion_.at(track, time).kinematics;
  return {k.range, k.azimuth, k.azimuth_rate};
}

std::vector<TrackBook::Slot> TrackBook::living() const {
  std::vector<Slot> all;
  for (int sector = 0; sector < tws::kSectors; ++sector) tracks_.list(sector, all);
  return all;
}

std::optional<TrackBook::Slot> TrackBook::find(std::uint32_t number) const {
  for (const auto slot : living()) {
    if (tracks_.at(slot).number == number) return slot;
  }
  return std::nullopt;
}

}  // namespace adit_tracker
