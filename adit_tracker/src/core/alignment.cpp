#include "core/alignment.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/earth_plane.h>

#include "core/flat_place.h"

namespace adit_tracker {
namespace {

constexpr tws::RegistrationTerms kNone{};

tws::EarthSite siteOf(const Radars& radars, std::size_t radar) { return {radars.plane(), radars.at(radar).frame}; }

/// A plot under a guess of its target's height. Where all radars stand together, slant range lies on the plane, as it
/// does for their tracks.
tws::PlaceAtHeight placeOf(const Radars& radars, std::size_t radar, const tws::Plot& plot, double height) {
  const RadarState& state = radars.at(radar);
  const double range_sigma = state.quality.rangeSigma(plot), azimuth_sigma = state.quality.azimuthSigma(plot);
  if (radars.severalSites())
    return siteOf(radars, radar).placeOf(plot.range, plot.azimuth, range_sigma, azimuth_sigma, height);
  tws::PlaceAtHeight there{};
  there.place = flatPlace(state.frame, plot, range_sigma, azimuth_sigma);
  return there;
}

tws::RegistrationRows rowsOf(std::size_t radar, const tws::SiteFrame& frame, const tws::SiteView& view, double vx,
                             double vy) {
  return tws::registrationRows(radar, view.range, view.ground, view.azimuth, frame.onPlane(view.azimuth), vx, vy);
}

/// How the place of a plot from there changes with the radar's errors. Both radars' are to be asked for at one place:
/// at the plots' own, their noise would look like errors that the radars share.
tws::RegistrationRows rowsAt(const Radars& radars, std::size_t radar, double x, double y, double height, double vx,
                             double vy) {
  const tws::SiteFrame& frame = radars.at(radar).frame;
  if (radars.severalSites()) return rowsOf(radar, frame, siteOf(radars, radar).view(x, y, height), vx, vy);
  const tws::PlanarView view = frame.view(x, y);
  return tws::registrationRows(radar, view.distance, view.distance, view.azimuth, frame.onPlane(view.azimuth), vx, vy);
}

double shift(const tws::RegistrationTerms& rows, const tws::RegistrationTerms& errors) {
  double sum = 0.0;
  for (std::size_t i = 0; i < tws::kRegistrationTerms; ++i) sum += rows[i] * errors[i];
  return sum;
}

void addTo(tws::RegistrationTerms& sum, const tws::RegistrationTerms& terms, double weight) {
  for (std::size_t i = 0; i < tws::kRegistrationTerms; ++i) sum[i] += weight * terms[i];
}

void addTo(tws::Symmetric2& sum, const tws::Symmetric2& term, double weight) {
  sum.xx += weight * term.xx;
  sum.xy += weight * term.xy;
  sum.yy += weight * term.yy;
}

/// Of what a sector holds, whose is the detection?
const tws::RegistrationTerms& takenOf(DetectionFile& file, std::int64_t running, const Detection& detection) {
  for (std::int64_t s = running - 1; s <= running + 1; ++s) {
    const DetectionSector& sector = file.at(s);
    const Detection* const first = sector.detections.data();
    if (!std::less<>()(&detection, first) && std::less<>()(&detection, first + sector.detections.size()))
      return sector.taken;
  }
  return kNone;
}

}  // namespace

void takeOut(const tws::RegistrationTerms& errors, tws::RadarSector& sector) {
  sector.enter_time -= errors[tws::kClockOffset];
  sector.leave_time -= errors[tws::kClockOffset];
  for (tws::Plot& plot : sector.plots) {
    plot.time -= errors[tws::kClockOffset];
    plot.range = std::max((plot.range - errors[tws::kRangeBias]) / (1.0 + errors[tws::kRangeGain]), 1.0);
    plot.azimuth = tws::wrapTwoPi(plot.azimuth - tws::azimuthError(errors, plot.azimuth));
  }
}

void asTold(const tws::RegistrationTerms& taken, double& time, double& range, double& azimuth) {
  constexpr int kIterations = 3;
  time += taken[tws::kClockOffset];
  range += tws::rangeError(taken, range);
  double told = azimuth;
  for (int i = 0; i < kIterations; ++i) told = azimuth + tws::azimuthError(taken, told);
  azimuth = tws::wrapTwoPi(told);
}

Alignment::Alignment(const AditParams& params, Radars& radars)
    : radars_(radars),
      references_(params.registration_references),
      registration_(params.radars.size(), params.registration) {}

void Alignment::advance(double time) {
  if (isOn()) registration_.advance(time);
}

/// Of two radars, the plots of the one with longer scans are compared with those of the other around them.
bool Alignment::isSlower(std::size_t radar, std::size_t other) const {
  const double own = periodOf(radar), its = periodOf(other);
  constexpr double kAlike = 0.05;  // share; measured periods waver
  return std::abs(own - its) > kAlike * own ? own > its : radar > other;
}

void Alignment::look(std::size_t radar, const tws::RadarSector& sector) {
  for (const RegistrationReference& reference : references_) {
    const RadarState& state = radars_.at(radar);
    const tws::EarthSite site = siteOf(radars_, radar);
    const double height = site.height() + reference.height;
    const tws::SiteView view = site.view(reference.x, reference.y, height);
    const double slant = view.range;
    // A place is a reference where no other plot is near: within what the radar may err by.
    const auto& sigma = registration_.reports()[radar].sigmas;
    const auto& errors = registration_.reports()[radar].errors;
    const double range_gate = 4.0 * std::hypot(state.quality.rangeSigma(), sigma[tws::kRangeBias]);
    const double azimuth_gate = 4.0 * std::hypot(state.quality.azimuthSigma(), sigma[tws::kAzimuthBias]);
    const tws::Plot* found = nullptr;
    int near = 0;
    for (const tws::Plot& plot : sector.plots) {
      if (std::abs(plot.range - slant - tws::rangeError(errors, slant)) > range_gate) continue;
      if (std::abs(tws::angularDifference(plot.azimuth, view.azimuth + tws::azimuthError(errors, view.azimuth))) >
          azimuth_gate)
        continue;
      found = &plot;
      ++near;
    }
    if (near != 1 || !registration_.wantsPairing(found->time)) continue;
    const tws::PlaceAtHeight placed = site.placeOf(found->range, found->azimuth, state.quality.rangeSigma(*found),
                                                   state.quality.azimuthSigma(*found), height);
    tws::RegistrationPairing pairing;
    pairing.time = found->time;
    pairing.x = placed.place.x - reference.x;
    pairing.y = placed.place.y - reference.y;
    pairing.covariance = placed.place.covariance;
    pairing.covariance.xx += reference.sigma * reference.sigma;
    pairing.covariance.yy += reference.sigma * reference.sigma;
    pairing.first = rowsOf(radar, state.frame, view, 0.0, 0.0);
    pairing.absolute = true;
    registration_.add(pairing);
  }
}

void Alignment::add(const TrackFile& tracks, TrackFile::Slot slot, const tws::SectorRef& sector,
                    const Detection& detection) {
  if (!isOn() || radars_.size() < 2) return;
  RadarState& state = radars_.at(sector.radar);
  const Track& track = tracks.at(slot);
  if (!track.firm || state.detections.at(sector.running).ship) return;
  constexpr std::size_t kKept = 3 * kMaxRadars;
  constexpr double kLongestGap = 1.3;  // between plots of a radar [scans]: where one was missed the way may have bent
  if (slot >= histories_.size()) histories_.resize(slot + std::size_t{1});
  History& history = histories_[slot];
  if (history.uid != track.uid) history = {track.uid, {}};
  const Seen after{detection.plot, takenOf(state.detections, sector.running, detection), sector.radar};
  const double period = periodOf(sector.radar), oldest = after.plot.time - kLongestGap * period;
  const Seen* before = nullptr;
  for (const Seen& seen : history.plots)
    if (seen.radar == sector.radar && seen.plot.time > oldest && seen.plot.time < after.plot.time - 0.5 * period)
      before = &seen;
  if (before) {
    for (const Seen& at : history.plots) {
      if (at.radar == sector.radar || !isSlower(at.radar, sector.radar)) continue;
      if (at.plot.time > before->plot.time && at.plot.time <= after.plot.time) pair(track, at, *before, after);
    }
  }
  history.plots.push_back(after);
  if (history.plots.size() > kKept) history.plots.pop_front();
}

/// The plot against the straight way between two plots of another radar. As each of these is used for about one plot,
/// weighed from both sides, a pairing counts as if one plot stood against one.
void Alignment::pair(const Track& track, const Seen& at, const Seen& before, const Seen& after) {
  if (!registration_.wantsPairing(at.plot.time)) return;
  constexpr double kBend = 4.0;  // standard deviation of accelerations [m/s²]
  const double vx = track.smoothed.vx, vy = track.smoothed.vy;
  const double span = after.plot.time - before.plot.time, since = at.plot.time - before.plot.time;
  const double weight = since / span;
  const auto height = static_cast<double>(track.height_guess.height);
  const auto place = [&](const Seen& seen) { return placeOf(radars_, seen.radar, seen.plot, height); };
  const tws::PlaceAtHeight a = place(at), b = place(before), c = place(after);
  const auto between = [&](double from, double to) { return (1.0 - weight) * from + weight * to; };
  const double x = between(b.place.x, c.place.x), y = between(b.place.y, c.place.y);
  const double middle_x = 0.5 * (a.place.x + x), middle_y = 0.5 * (a.place.y + y);
  const auto rows = [&](std::size_t radar) { return rowsAt(radars_, radar, middle_x, middle_y, height, vx, vy); };
  tws::RegistrationPairing pairing;
  pairing.time = at.plot.time;
  pairing.first = rows(at.radar);
  pairing.second = rows(before.radar);
  addTo(pairing.covariance, a.place.covariance, 1.0);
  addTo(pairing.covariance, b.place.covariance, 1.0 - weight);
  addTo(pairing.covariance, c.place.covariance, weight);
  // What was taken out of the plots already is put back.
  tws::RegistrationTerms taken{};
  addTo(taken, before.taken, 1.0 - weight);
  addTo(taken, after.taken, weight);
  pairing.x = a.place.x - x + shift(pairing.first.x, at.taken) - shift(pairing.second.x, taken);
  pairing.y = a.place.y - y + shift(pairing.first.y, at.taken) - shift(pairing.second.y, taken);
  const double bend = 0.5 * kBend * since * (span - since);
  const double dx = a.x_per_height - between(b.x_per_height, c.x_per_height);
  const double dy = a.y_per_height - between(b.y_per_height, c.y_per_height);
  const auto vague = static_cast<double>(track.height_guess.variance);
  addTo(pairing.covariance, {bend * bend + vague * dx * dx, vague * dx * dy, bend * bend + vague * dy * dy}, 1.0);
  registration_.add(pairing);
}

}  // namespace adit_tracker
