#include "symbols.h"

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

constexpr double kProbationOpacity = 0.5;

// A firm track is a circle, a coasting one a square, a tentative one a small diamond; without a primary radar a
// triangle.
Polygon symbolOf(const TrackReport& report, const PpiStyle& style) {
  if (report.state == TrackState::kTentative) return {4, 0.8 * style.symbol, 0.0};
  if (report.kind == TrackKind::kSecondary) return {3, 1.3 * style.symbol, 0.0};
  if (report.state == TrackState::kCoasting) return {4, 1.3 * style.symbol, tws::kPi / 4.0};
  return {16, style.symbol, 0.0};
}

}  // namespace

const Rgba& colorOf(const TrackReport& report, const PpiStyle& style) {
  if (report.state == TrackState::kFirm) return report.kind == TrackKind::kSecondary ? style.secondary : style.firm;
  return report.state == TrackState::kCoasting ? style.coasting : style.tentative;
}

void addTrackSymbol(Drawing& drawing, const TrackReport& report, const PpiStyle& style) {
  const Rgba& color = colorOf(report, style);
  const Eigen::Vector2d& middle = report.position;
  if (report.symbol_only) {
    constexpr double kDimmed = 0.7;
    return addPolygon(drawing, middle, {3, 1.5 * style.symbol, 0.0}, style.line, faded(color, kDimmed));
  }
  addPolygon(drawing, middle, symbolOf(report, style), style.line, color);
  if (report.kind == TrackKind::kCorrelated) addDot(drawing, middle, 0.7 * style.symbol, color);
  // Around the symbol: a wide circle for a track that is handed off, a wide diamond for a designated one, a bar above
  // for one that answers IFF, unless its kind says so already.
  if (report.handed_off) addPolygon(drawing, middle, {16, 1.6 * style.symbol, 0.0}, style.line, style.ordered);
  if (report.designated) addPolygon(drawing, middle, {4, 2.2 * style.symbol, 0.0}, style.line, style.ordered);
  if (!report.iff || report.kind != TrackKind::kPrimary) return;
  const Eigen::Vector2d above(0.0, 1.3 * style.symbol), half(0.9 * style.symbol, 0.0);
  addLine(drawing, middle + above - half, middle + above + half, 1.5 * style.line, style.iff);
}

void addClutterSymbol(Drawing& drawing, const Eigen::Vector2d& position, bool absorbing, const PpiStyle& style) {
  if (absorbing)
    addCross(drawing, position, style.clutter_mark, tws::kPi / 4.0, style.line, style.clutter);
  else
    addCross(drawing, position, 0.6 * style.clutter_mark, 0.0, style.line, faded(style.clutter, kProbationOpacity));
}

}  // namespace tws_rviz
