#include "ppi_input.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <tws_core/geometry.h>
#include <tws_core/registration.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

namespace tws_rviz {
namespace {

void requireFinite(double value, const std::string& field) {
  if (!std::isfinite(value)) throw std::invalid_argument(field + " is not a finite number");
}

Eigen::Vector2d polarPosition(double range, double azimuth, const PlanarFrame& site) {
  requireFinite(range, "range");
  requireFinite(azimuth, "azimuth");
  if (range < 0.0) throw std::invalid_argument("range is negative: " + std::to_string(range));
  return site.placed(tws::planarFromPolar(range, azimuth));
}

Eigen::Vector2d cartesianPosition(const geometry_msgs::Point& position, const PlanarFrame& frame) {
  requireFinite(position.x, "position.x");
  requireFinite(position.y, "position.y");
  return frame.placed({position.x, position.y});
}

TrackState trackState(const tws_msgs::Track& track) {
  switch (track.state) {
    case tws_msgs::Track::TENTATIVE:
      return TrackState::kTentative;
    case tws_msgs::Track::FIRM:
      return TrackState::kFirm;
    case tws_msgs::Track::COASTING:
      return TrackState::kCoasting;
    case tws_msgs::Track::DROPPED:
      return TrackState::kDropped;
    default:
      throw std::invalid_argument("state of track " + std::to_string(track.number) + " is " +
                                  std::to_string(track.state) + "; known are 1 to 4");
  }
}

std::string codeAndLevel(std::uint16_t mode_3a, double height) {
  constexpr double kFeetPerLevel = 100.0;
  static_assert(int{tws_msgs::Track::CODE_UNKNOWN} == int{tws_msgs::SsrPlot::CODE_UNKNOWN}, "one constant for both");
  char code[16] = "";
  char level[16] = "";
  if (mode_3a != tws_msgs::Track::CODE_UNKNOWN) std::snprintf(code, sizeof code, "%04o", mode_3a);
  if (std::isfinite(height))
    std::snprintf(level, sizeof level, "F%03ld", std::lround(tws::feetFromMetres(height) / kFeetPerLevel));
  const bool both = code[0] != '\0' && level[0] != '\0';
  return std::string(code) + (both ? " " : "") + level;
}

}  // namespace

PlanarFrame planarFrame(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  // Where the frame's north (0, 1, 0) points, seen from above.
  const Eigen::Vector2d north(2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z));
  return {{transform.translation.x, transform.translation.y}, tws::azimuthOf(north)};
}

BeamMark beamMark(const tws_msgs::SectorMark& mark) {
  if (mark.sector >= tws::kSectors)
    throw std::invalid_argument("sector is " + std::to_string(mark.sector) + "; expected 0 to 63");
  return {mark.header.stamp.toSec(), mark.sector, mark.running_sector, mark.rotation_period};
}

PlotMark plotMark(const tws_msgs::Detection& detection, const PlanarFrame& site) {
  return {detection.stamp.toSec(), polarPosition(detection.range, detection.azimuth, site),
          detection.azimuth + site.turn};
}

RadarCells radarCells(const tws_msgs::RadarMap& map, const PlanarFrame& site) {
  const std::size_t cells = static_cast<std::size_t>(map.bins) * tws_msgs::RadarMap::SECTORS;
  if (!std::isfinite(map.depth) || map.depth <= 0.0) throw std::invalid_argument("depth is not greater than 0");
  if (map.false_plots.size() != cells || map.blind.size() != cells)
    throw std::invalid_argument("there are not bins * 64 values of false_plots and blind");
  if (std::any_of(map.false_plots.begin(), map.false_plots.end(),
                  [](float f) { return !std::isfinite(f) || f < 0.0f; }))
    throw std::invalid_argument("false_plots is not finite or below 0");
  return {site, map.depth, map.bins, map.false_plots, map.blind};
}

Eigen::Vector2d clutterPosition(const tws_msgs::ClutterPoint& point, const PlanarFrame& site) {
  return polarPosition(point.range, point.azimuth, site);
}

Eigen::Vector2d truthPosition(const tws_msgs::TruthTarget& target, const PlanarFrame& frame) {
  return cartesianPosition(target.position, frame);
}

TrackReport trackReport(const tws_msgs::Track& track, std::size_t source, const std::string& prefix, double published,
                        const PlanarFrame& frame) {
  TrackReport report;
  report.source = source;
  report.uid = track.uid;
  report.state = trackState(track);
  report.published = published;
  report.time = track.stamp.toSec();
  if (report.state == TrackState::kDropped) return report;
  report.position = cartesianPosition(track.position, frame);
  report.velocity = frame.rotated({track.velocity.x, track.velocity.y});
  report.handed_off = (track.detection_bits & tws_msgs::Track::HANDED_OFF) != 0;
  report.designated = (track.detection_bits & tws_msgs::Track::ELEVATION_REQUESTED) != 0;
  report.iff = (track.detection_bits & tws_msgs::Track::DETECTED_BY_IFF) != 0;
  report.name = prefix + (track.callsign.empty() ? std::to_string(track.number) : track.callsign);
  report.identity = identityText(track);
  return report;
}

TrackReport trackReport(const tws_msgs::CorrelatedTrack& track, std::size_t source, double published,
                        const PlanarFrame& frame) {
  using tws_msgs::CorrelatedTrack;
  if (track.kind < CorrelatedTrack::PRIMARY_ONLY || track.kind > CorrelatedTrack::CORRELATED)
    throw std::invalid_argument("kind of identity " + std::to_string(track.identity) + " is " +
                                std::to_string(track.kind) + "; known are 1 to 3");
  TrackReport report = trackReport(track.track, source, "", published, frame);
  report.uid = track.identity;
  report.kind = track.kind == CorrelatedTrack::CORRELATED       ? TrackKind::kCorrelated
                : track.kind == CorrelatedTrack::SECONDARY_ONLY ? TrackKind::kSecondary
                                                                : TrackKind::kPrimary;
  return report;
}

IdentityPlot identityPlot(const tws_msgs::SsrPlot& plot, const PlanarFrame& site) {
  return {plot.stamp.toSec(), polarPosition(plot.range, plot.azimuth, site), identityText(plot)};
}

std::string alignmentText(const tws_msgs::RadarRegistration& radar) {
  using tws_msgs::RadarRegistration;
  for (const double applied : radar.applied) requireFinite(applied, "applied");
  if (radar.state == RadarRegistration::TOO_LARGE) return "errors too large";
  const double terms[] = {radar.applied[tws::kRangeBias], tws::degrees(radar.applied[tws::kAzimuthBias]),
                          radar.applied[tws::kClockOffset]};
  constexpr const char* kFormats[] = {"%+.0f m", "%+.2f deg", "%+.2f s"};
  constexpr double kShown[] = {1.0, 0.01, 0.01};  // less is not worth a word
  std::string said = radar.state == RadarRegistration::DRIFTING ? "drifts" : "";
  for (std::size_t i = 0; i < 3; ++i) {
    char text[32];
    std::snprintf(text, sizeof text, kFormats[i], terms[i]);
    if (std::abs(terms[i]) >= kShown[i]) said += (said.empty() ? "" : " ") + std::string(text);
  }
  return said;
}

std::string identityText(const tws_msgs::Track& track) { return codeAndLevel(track.mode_3a, track.height); }

std::string identityText(const tws_msgs::SsrPlot& plot) {
  const std::string code = codeAndLevel(plot.mode_3a, plot.height);
  return plot.callsign + (plot.callsign.empty() || code.empty() ? "" : " ") + code;
}

}  // namespace tws_rviz
