#include "track_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tws_core/units.h>

#include "label_placement.h"
#include "symbols.h"

namespace tws_rviz {
namespace {

constexpr int kTrailDots = 12;
constexpr double kTrailBrightest = 0.75;
constexpr int kRightSide = 0;
constexpr int kLeftSide = 4;

// A tentative track shows its name only: many of them are false. One that does not move yet, a single detection, shows
// nothing: most of these are false, and their numbers would fill the picture.
std::string labelText(const TrackReport& report) {
  std::string text = report.name;
  if (report.symbol_only) return std::string();
  if (report.state == TrackState::kTentative) return report.velocity.isZero() ? std::string() : text;
  const double speed = report.velocity.norm();
  if (std::isfinite(speed)) text += "\n" + std::to_string(std::lround(tws::knotsFromSpeed(speed))) + "kn";
  if (!report.identity.empty()) text += "\n" + report.identity;
  return text;
}

// The label stands behind the track, clear of its leader.
int favouredSide(const TrackReport& report) { return report.velocity.x() > 0.0 ? kLeftSide : kRightSide; }

}  // namespace

void TrackPicture::add(const TrackReport& report) {
  const auto key = std::make_pair(report.source, report.uid);
  if (report.state == TrackState::kDropped) {
    tracks_.erase(key);
    return;
  }
  const auto [found, born] = tracks_.try_emplace(key);
  LivingTrack& track = found->second;
  if (born)
    track.label = next_label_++;
  else
    leaveTrail(track, report.published);
  std::string known = std::move(track.report.identity);
  track.report = report;
  track.confirmed = track.confirmed || report.state != TrackState::kTentative;
  if (report.identity.empty()) track.report.identity = std::move(known);
}

void TrackPicture::leaveTrail(LivingTrack& track, double time) const {
  const double spacing = look_.trail_time / kTrailDots;
  if (track.trail.empty() || track.report.published - track.trail.back().time >= spacing)
    track.trail.push_back({track.report.published, track.report.position});
  while (!track.trail.empty() && track.trail.front().time < time - look_.trail_time) track.trail.pop_front();
}

void TrackPicture::expire(double time) {
  for (auto track = tracks_.begin(); track != tracks_.end();)
    track = time - track->second.report.published > look_.timeout ? tracks_.erase(track) : std::next(track);
}

void TrackPicture::draw(TrackLayers& layers, double time, const PpiStyle& style, const std::set<std::size_t>& covered) {
  std::vector<LivingTrack*> shown;
  for (auto& [key, track] : tracks_)
    if (!track.confirmed || covered.count(key.first) == 0) shown.push_back(&track);
  findCrowds(shown, style);
  for (const LivingTrack* track : shown)
    if (!track->report.symbol_only && !track->crowded) drawTrail(layers.of(track->report), *track, time, style);
  for (const LivingTrack* track : shown) {
    Drawing& drawing = layers.of(track->report);
    if (track->crowded)
      addDot(drawing, track->report.position, style.dot, colorOf(track->report, style));
    else
      drawSymbol(drawing, track->report, style);
  }
  drawLabels(layers, shown, style);
}

void TrackPicture::findCrowds(const std::vector<LivingTrack*>& shown, const PpiStyle& style) {
  constexpr double kCell = 4.0;  // [radii of a symbol]
  constexpr int kMany = 5;       // of a cell
  const auto cellOf = [&](const LivingTrack& track) {
    const Eigen::Vector2d& place = track.report.position;
    return std::make_pair(std::floor(place.x() / (kCell * style.symbol)),
                          std::floor(place.y() / (kCell * style.symbol)));
  };
  std::map<std::pair<double, double>, int> tentative;
  for (const LivingTrack* track : shown)
    if (track->report.state == TrackState::kTentative) ++tentative[cellOf(*track)];
  for (LivingTrack* track : shown)
    track->crowded = track->report.state == TrackState::kTentative && tentative[cellOf(*track)] > kMany;
}

void TrackPicture::drawTrail(Drawing& drawing, const LivingTrack& track, double time, const PpiStyle& style) const {
  const Rgba& color = colorOf(track.report, style);
  for (const TrailDot& dot : track.trail) {
    const double left = 1.0 - (time - dot.time) / look_.trail_time;
    if (left > 0.0) addDot(drawing, dot.position, style.dot, faded(color, kTrailBrightest * left));
  }
}

void TrackPicture::drawSymbol(Drawing& drawing, const TrackReport& report, const PpiStyle& style) const {
  const Eigen::Vector2d leader = look_.leader_time * report.velocity;
  if (!report.symbol_only && leader.allFinite())
    addLine(drawing, report.position, report.position + leader, style.line, colorOf(report, style));
  addTrackSymbol(drawing, report, style);
}

void TrackPicture::drawLabels(TrackLayers& layers, const std::vector<LivingTrack*>& shown, const PpiStyle& style) {
  std::vector<LabelRequest> requests;
  std::vector<std::pair<LivingTrack*, std::string>> labelled;
  for (LivingTrack* track : shown) {
    std::string text = labelText(track->report);
    if (text.empty() || track->crowded) continue;
    requests.push_back({track->report.position, textSize(text, style.small_text), 1.4 * style.symbol,
                        track->side.value_or(favouredSide(track->report))});
    labelled.emplace_back(track, std::move(text));
  }
  const std::vector<int> sides = placeLabels(requests);
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    LivingTrack& track = *labelled[i].first;
    track.side = sides[i];
    layers.of(track.report)
        .labels.push_back({track.label, labelCentre(requests[i], sides[i]), style.small_text, labelled[i].second,
                           colorOf(track.report, style)});
  }
}

std::array<int, 3> TrackPicture::counts(std::size_t source) const {
  std::array<int, 3> counts{};
  for (const auto& [key, track] : tracks_)
    if (key.first == source) ++counts[static_cast<std::size_t>(track.report.state)];
  return counts;
}

}  // namespace tws_rviz
