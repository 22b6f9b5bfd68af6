#include "operator/operator_messages.h"

#include <cmath>

namespace adit_tracker {
namespace {

/// Without cells, which cannot be loaded, when there are more counts than looks or fewer.
CellCounts cellsOf(double depth, const std::vector<float>& counts, const std::vector<float>& looks) {
  CellCounts cells;
  cells.depth = depth;
  cells.cells.clear();
  for (std::size_t i = 0; i < counts.size() && counts.size() == looks.size(); ++i)
    cells.cells.push_back({counts[i], looks[i]});
  return cells;
}

RadarCounts countsOf(const tws_msgs::RadarCounts& message) {
  return {message.radar, message.greatest_range, cellsOf(message.false_plots_depth, message.false_plots, message.scans),
          cellsOf(message.cover_depth, message.seen, message.looks)};
}

tws_msgs::RadarCounts messageOf(const RadarCounts& counts) {
  tws_msgs::RadarCounts message;
  message.radar = counts.radar;
  message.greatest_range = counts.greatest_range;
  message.false_plots_depth = counts.false_plots.depth;
  message.cover_depth = counts.cover.depth;
  for (const CellCount& cell : counts.false_plots.cells) {
    message.false_plots.push_back(cell.count);
    message.scans.push_back(cell.looks);
  }
  for (const CellCount& cell : counts.cover.cells) {
    message.seen.push_back(cell.count);
    message.looks.push_back(cell.looks);
  }
  return message;
}

}  // namespace

OperatorRequest requestOf(const tws_msgs::OperatorRequest& message, const tws_runtime::Site& site) {
  OperatorRequest request;
  request.action = static_cast<OperatorAction>(message.request);
  request.track = message.track;
  request.cancel = message.cancel != 0;
  request.from = message.lower;
  request.to = message.upper;
  request.start = message.start;
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  const double dx = message.position.x - site.x, dy = message.position.y - site.y;
  request.x = c * dx + s * dy;
  request.y = c * dy - s * dx;
  for (const tws_msgs::ClutterPoint& p : message.clutter) request.maps.clutter.push_back({p.radar, p.range, p.azimuth});
  for (const tws_msgs::RadarCounts& counts : message.radar_counts) request.maps.radars.push_back(countsOf(counts));
  return request;
}

void setMaps(tws_msgs::OperatorRequest& message, const SavedMaps& maps) {
  for (const ClutterPlace& place : maps.clutter) {
    tws_msgs::ClutterPoint& point = message.clutter.emplace_back();
    point.radar = place.radar;
    point.range = place.range;
    point.azimuth = place.azimuth;
  }
  for (const RadarCounts& counts : maps.radars) message.radar_counts.push_back(messageOf(counts));
}

void setEffect(tws_msgs::OperatorRequest& message, const Adit& adit, const OperatorAnswer& answer) {
  message.result = answer.refusal.empty() ? tws_msgs::OperatorRequest::OK : tws_msgs::OperatorRequest::REFUSED;
  message.message = answer.refusal;
  message.count = answer.count;
  message.tracks.clear();
  for (const TrackFile::Slot slot : answer.tracks) message.tracks.push_back(adit.tracks().at(slot).number);
}

}  // namespace adit_tracker
