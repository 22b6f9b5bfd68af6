#include "secondary_tracker.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

namespace track_correlator {
namespace {

constexpr std::int64_t kLongestSilence = std::int64_t{8} * tws::kSectors;

void check(bool good, const char* rule) {
  if (!good) throw std::invalid_argument(std::string("secondary tracker: ") + rule);
}

}  // namespace

SecondaryTracker::SecondaryTracker(const SecondaryParams& params, OnReport on_report)
    : params_(params), on_report_(std::move(on_report)), matcher_(params) {
  check(params.delay_sectors >= 2 && params.delay_sectors <= 32, "delay_sectors must be in 2 .. 32");
  check(params.range_sigma > 0.0 && params.azimuth_sigma > 0.0, "range_sigma and azimuth_sigma must be above 0");
  check(params.acceleration_density >= 0.0, "acceleration_density must not be negative");
  check(params.speed_sigma > 0.0 && params.gate > 0.0, "speed_sigma and gate must be above 0");
  check(params.confirm_plots >= 1 && params.code_change_replies >= 1 && params.tentative_misses >= 1 &&
            params.drop_misses >= 1,
        "confirm_plots, code_change_replies, tentative_misses and drop_misses must be at least 1");
}

void SecondaryTracker::add(SecondarySector sector) {
  if (stored_.empty()) begin(sector);
  const std::int64_t gap = sector.running - stored_.back().sector.running;
  if (gap > kLongestSilence || gap <= -tws::kSectors) {
    // One stray number does no harm: two in line are the radar's new count.
    const bool new_count = stray_ && sector.running == *stray_ + 1;
    stray_ = sector.running;
    if (!new_count) {
      ++counts_.late_sectors;
      return;
    }
    dropAll();
    begin(sector);
  } else if (gap <= 0 || sector.leave_time < stored_.back().sector.leave_time) {
    ++counts_.late_sectors;
    return;
  }
  stray_.reset();
  if (gap == 1) sector_duration_ = sector.leave_time - stored_.back().sector.leave_time;
  if (!leapsTo(sector)) fillGap(sector);
  counts_.plots += sector.plots.size();
  std::sort(sector.plots.begin(), sector.plots.end(), comesBefore);
  store(std::move(sector));
}

bool SecondaryTracker::leapsTo(const SecondarySector& next) const {
  const SecondarySector& last = stored_.back().sector;
  const auto numbers = static_cast<double>(next.running - last.running);
  return numbers * sector_duration_ - (next.leave_time - last.leave_time) > tws::kHalfTurn * sector_duration_;
}

void SecondaryTracker::fillGap(const SecondarySector& next) {
  const std::int64_t last = stored_.back().sector.running;
  const double last_time = stored_.back().sector.leave_time;
  for (std::int64_t n = last + 1; n < next.running; ++n) {
    ++counts_.lost_sectors;
    const double part = static_cast<double>(n - last) / static_cast<double>(next.running - last);
    store({n, last_time + part * (next.leave_time - last_time), {}});
  }
}

/// An empty sector stands before the first one.
void SecondaryTracker::begin(const SecondarySector& sector) {
  stored_.clear();
  stored_.push_back({{sector.running - 1, sector.leave_time, {}}, sector.leave_time, {}});
}

void SecondaryTracker::dropAll() {
  SecondaryReport report{stored_.back().sector.running, stored_.back().sector.leave_time, {}};
  for (const SecondaryTrack& track : tracks_) report.updates.push_back({SecondaryEvent::kDropped, track});
  tracks_.clear();
  on_report_(report);
}

void SecondaryTracker::store(SecondarySector sector) {
  const Stored& last = stored_.back();
  const bool follows = sector.running == last.sector.running + 1;
  const double enter_time = follows ? last.sector.leave_time : sector.leave_time - sector_duration_;
  std::vector<bool> used(sector.plots.size(), false);
  stored_.push_back({std::move(sector), enter_time, std::move(used)});
  // Δ₁ sectors behind the one that has just been left.
  if (stored_.size() < static_cast<std::size_t>(params_.delay_sectors) + 2) return;
  process(1);
  stored_.pop_front();
}

std::vector<std::size_t> SecondaryTracker::tracksNear(std::int64_t running, double time,
                                                      std::vector<std::size_t>& due) const {
  const int sector = static_cast<int>(running % tws::kSectors);
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const auto& mean = tracks_[i].state.mean;
    const double dt = time - tracks_[i].time;
    const Eigen::Vector2d where = mean.head<2>() + dt * mean.tail<2>();
    const int behind = tws::sectorDifference(sector, tws::sectorOf(tws::azimuthOf(where)));
    const bool waits = running - tracks_[i].done >= tws::kHalfTurn;  // A track is processed once a turn.
    // Behind by one or two: it moved against the beam, out of a sector that was still to come.
    if (waits && behind >= 0 && behind <= 2)
      due.push_back(i);
    else if (behind >= -1 && behind <= 1)
      others.push_back(i);
  }
  return others;
}

void SecondaryTracker::process(std::size_t index) {
  const SecondarySector& sector = stored_[index].sector;
  SecondaryReport report{sector.running, stored_[index].enter_time, {}};
  std::vector<std::size_t> due;
  const std::vector<std::size_t> others = tracksNear(sector.running, report.enter_time, due);

  // Rivals are the tracks whose turn comes next: what is theirs is left to them.
  std::vector<const SecondaryTrack*> tracks, neighbours;
  for (const std::size_t i : due) tracks.push_back(&tracks_[i]);
  for (const std::size_t i : others)
    (sector.running - tracks_[i].done >= tws::kHalfTurn ? tracks : neighbours).push_back(&tracks_[i]);
  std::vector<PlacedPlot> plots;
  std::vector<std::pair<std::size_t, std::size_t>> where;
  for (std::size_t s = index - 1; s <= index + 1; ++s) {
    for (std::size_t p = 0; p < stored_[s].used.size(); ++p) {
      if (stored_[s].used[p]) continue;
      plots.push_back(place(stored_[s].sector.plots[p], params_));
      where.emplace_back(s, p);
    }
  }
  const std::vector<int>& plot_of = matcher_.match(tracks, plots, neighbours);
  std::vector<bool> garbled(due.size(), false);
  for (std::size_t i = 0; i < due.size(); ++i) {
    if (plot_of[i] >= 0) garbled[i] = matcher_.garbled(i, *plots[static_cast<std::size_t>(plot_of[i])].plot);
  }
  for (std::size_t i = 0; i < due.size(); ++i) {
    SecondaryTrack& track = tracks_[due[i]];
    track.done = sector.running;
    if (plot_of[i] < 0) {
      miss(track, report.enter_time, report.updates);
      continue;
    }
    const std::size_t p = static_cast<std::size_t>(plot_of[i]);
    stored_[where[p].first].used[where[p].second] = true;
    update(track, plots[p], garbled[i]);
    report.updates.push_back({SecondaryEvent::kUpdated, track});
  }
  removeDropped();
  startTracks(stored_[index - 1], report.updates);
  on_report_(report);
}

void SecondaryTracker::update(SecondaryTrack& track, const PlacedPlot& placed, bool garbled) {
  const SecondaryPlot& plot = *placed.plot;
  track.state = predicted(track, plot.time, params_);
  tws::update(track.state, placed.measured, tws::innovation(track.state, placed.measured));
  track.time = track.last_update = plot.time;
  track.misses = 0;
  track.firm = ++track.plots >= params_.confirm_plots;
  if (garbled && track.mode_3a.value() != kNoCode) ++counts_.mended_codes;
  track.mode_1.take(plot.mode_1, params_.code_change_replies);
  track.mode_2.take(plot.mode_2, params_.code_change_replies);
  track.mode_3a.take({plot.mode_3a.code, garbled}, params_.code_change_replies);
  track.height.take(plot.height, plot.height_garbled, plot.time, params_.climb_limit);
  if (plot.aircraft_address != 0) track.aircraft_address = plot.aircraft_address;
  if (!plot.callsign.empty()) track.callsign = plot.callsign;
}

void SecondaryTracker::miss(SecondaryTrack& track, double time, std::vector<SecondaryUpdate>& updates) {
  ++track.misses;
  const bool dropped = track.misses >= (track.firm ? params_.drop_misses : params_.tentative_misses);
  if (dropped && track.firm) ++counts_.dropped_tracks;
  SecondaryUpdate update{dropped ? SecondaryEvent::kDropped : SecondaryEvent::kCoasted, track};
  update.track.state = predicted(track, time, params_);
  update.track.time = std::max(time, track.time);
  updates.push_back(std::move(update));
}

void SecondaryTracker::removeDropped() {
  const auto deleted = [&](const SecondaryTrack& track) {
    return track.misses >= (track.firm ? params_.drop_misses : params_.tentative_misses);
  };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), deleted), tracks_.end());
}

/// All tracks that could want these plots have had their turn.
void SecondaryTracker::startTracks(Stored& stored, std::vector<SecondaryUpdate>& updates) {
  if (stored.used.size() > kMostPlots) {
    counts_.crowded_plots += static_cast<std::uint64_t>(std::count(stored.used.begin(), stored.used.end(), false));
    return;
  }
  for (std::size_t p = 0; p < stored.used.size(); ++p) {
    if (stored.used[p]) continue;
    stored.used[p] = true;
    const SecondaryPlot& plot = stored.sector.plots[p];
    if (isSplit(plot)) {
      ++counts_.split_plots;
      continue;
    }
    SecondaryTrack track;
    track.uid = ++last_uid_;
    track.first_time = track.time = plot.time;
    track.done = stored.sector.running;
    const PlacedPlot placed = place(plot, params_);
    track.state = tws::startState(placed.measured, params_.speed_sigma);
    update(track, placed, plot.mode_3a.garbled);
    updates.push_back({SecondaryEvent::kUpdated, track});
    tracks_.push_back(std::move(track));
  }
}

/// A track with the same identity has just taken another plot close by.
bool SecondaryTracker::isSplit(const SecondaryPlot& plot) const {
  const Eigen::Vector2d place = tws::planarFromPolar(plot.range, plot.azimuth);
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const SecondaryTrack& track) {
    return track.misses == 0 && agreementOf(track, plot) == Agreement::kSame &&
           (predicted(track, plot.time, params_).mean.head<2>() - place).norm() <= params_.split_distance;
  });
}

}  // namespace track_correlator
