#include "ppi_picture.h"

#include <algorithm>
#include <stdexcept>

#include "background.h"
#include "legend.h"
#include "symbols.h"

namespace tws_rviz {
namespace {

// Until a radar's rotation period is known [s].
constexpr double kAssumedPeriod = 10.0;

}  // namespace

PpiPicture::PpiPicture(const PpiParams& params)
    : params_(params),
      style_(params.picture_range, params.text_scale),
      tracks_(params.tracks),
      latest_(params.trackers.size() + params.correlators.size()) {
  for (const RadarParams& radar : params.radars) radars_.push_back({radar, {}, {}, {}, false, ""});
}

void PpiPicture::add(std::size_t radar, const BeamMark& mark, const PlanarFrame& site) {
  radars_[radar].sweep.mark(mark);
  radars_[radar].site = site;
  radars_[radar].has_mark = true;
}

void PpiPicture::add(std::size_t radar, const PlotMark& detection) {
  radars_[radar].detections.add(detection, persistence(radars_[radar]));
}

void PpiPicture::add(TrackReport report) {
  const bool of_tracker = report.source < params_.trackers.size();
  // What a transponder replies says more than a flight level that the tracker has measured, without a code.
  const bool has_code = !report.identity.empty() && report.identity.front() != 'F';
  if (of_tracker && report.state != TrackState::kDropped && !has_code) {
    const std::string replied = identities_.at(report.time, report.position, report.velocity);
    if (!replied.empty()) report.identity = replied;
  }
  tracks_.add(report);
}

std::optional<PlanarFrame> PpiPicture::siteOf(const std::string& radar) const {
  for (const Radar& candidate : radars_)
    if (candidate.has_mark && candidate.params.name == radar) return candidate.site;
  return std::nullopt;
}

Drawing PpiPicture::background() const {
  Drawing drawing = drawBackground(style_, spacing());
  if (params_.legend) addLegend(drawing, style_);
  return drawing;
}

Drawing PpiPicture::sweeps(double time) const {
  Drawing drawing;
  for (const Radar& radar : radars_)
    if (const auto azimuth = radar.sweep.azimuthAt(time))
      addSweep(drawing, radar.site.origin, *azimuth + radar.site.turn,
               {radar.params.color, params_.afterglow, style_.range, style_.line});
  return drawing;
}

Drawing PpiPicture::detections(double time) const {
  Drawing drawing;
  for (const Radar& radar : radars_)
    radar.detections.draw(drawing, time, persistence(radar), style_.plot, radar.params.color);
  return drawing;
}

PpiPicture::Radar& PpiPicture::radarNamed(const std::string& name) {
  for (Radar& radar : radars_)
    if (radar.params.name == name) return radar;
  throw std::invalid_argument("the picture has no radar '" + name + "'");
}

void PpiPicture::setCells(const std::string& radar, RadarCells cells) {
  cells_[radarNamed(radar).params.name] = std::move(cells);
}

void PpiPicture::setAlignment(const std::string& radar, const std::string& alignment) {
  radarNamed(radar).alignment = alignment;
}

Drawing PpiPicture::maps() const {
  Drawing drawing;
  for (const auto& entry : cells_) addRadarCells(drawing, entry.second, style_);
  return drawing;
}

Drawing PpiPicture::clutter(double time) const {
  Drawing drawing;
  if (isOld(clutter_.time, time)) return drawing;
  for (const ClutterMark& mark : clutter_.items) addClutterSymbol(drawing, mark.position, mark.absorbing, style_);
  return drawing;
}

Drawing PpiPicture::truth(double time) const {
  Drawing drawing;
  if (isOld(truth_.time, time)) return drawing;
  for (const Eigen::Vector2d& position : truth_.items)
    addCross(drawing, position, 2.0 * style_.symbol, 0.0, style_.line, style_.truth);
  return drawing;
}

TrackLayers PpiPicture::tracks(double time) {
  TrackLayers layers;
  tracks_.expire(time);
  tracks_.draw(layers, time, style_, covered(time));
  return layers;
}

Drawing PpiPicture::status(double time) const {
  PpiStatus status{time, spacing(), {}, {}, std::nullopt};
  for (const Radar& radar : radars_)
    if (radar.has_mark)
      status.radars.push_back({radar.params.name, radar.params.color, radar.sweep.rotationPeriod(),
                               radar.sweep.azimuthAt(time).has_value(), radar.alignment});
  const std::set<std::size_t> hidden = covered(time);
  const auto add = [&](std::size_t source, const std::string& name) {
    if (latest_[source] && hidden.count(source) == 0) status.trackers.push_back({name, tracks_.counts(source)});
  };
  for (std::size_t i = 0; i < params_.correlators.size(); ++i)
    add(params_.trackers.size() + i, params_.correlators[i].name);
  for (std::size_t i = 0; i < params_.trackers.size(); ++i) add(i, params_.trackers[i].name);
  if (!clutter_.items.empty() && !isOld(clutter_.time, time))
    status.clutter =
        std::count_if(clutter_.items.begin(), clutter_.items.end(), [](const auto& m) { return m.absorbing; });
  return drawStatus(style_, status);
}

std::set<std::size_t> PpiPicture::covered(double time) const {
  std::set<std::size_t> covered;
  for (std::size_t i = 0; i < params_.correlators.size(); ++i) {
    const auto& latest = latest_[params_.trackers.size() + i];
    if (!latest || isOld(*latest, time)) continue;
    const auto& topics = params_.correlators[i].covers;
    for (std::size_t tracker = 0; tracker < params_.trackers.size(); ++tracker)
      if (std::find(topics.begin(), topics.end(), params_.trackers[tracker].topic) != topics.end())
        covered.insert(tracker);
  }
  return covered;
}

double PpiPicture::persistence(const Radar& radar) const {
  const double period = radar.sweep.rotationPeriod();
  return params_.persistence_scans * (period > 0.0 ? period : kAssumedPeriod);
}

double PpiPicture::spacing() const {
  return params_.ring_spacing > 0.0 ? params_.ring_spacing : ringSpacing(params_.picture_range);
}

}  // namespace tws_rviz
