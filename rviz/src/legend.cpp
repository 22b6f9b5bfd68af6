#include "legend.h"

#include <string>

#include "radar_cells.h"
#include "symbols.h"

namespace tws_rviz {
namespace {

// Left edges of the columns, and the middle of their lowest line, in picture ranges.
constexpr double kLeft = -1.05;
constexpr double kRight = 0.68;
constexpr double kBottom = -1.06;

/// Writes lines one above the other: a symbol and what it means.
class LegendColumn {
 public:
  LegendColumn(Drawing& drawing, const PpiStyle& style, double left)
      : drawing_(drawing), style_(style), middle_(style.range * Eigen::Vector2d(left, kBottom)) {}

  void addTrack(TrackReport report, const std::string& meaning) {
    report.position = middle_;
    addTrackSymbol(drawing_, report, style_);
    write(meaning, colorOf(report, style_));
  }

  /// A square of a radar map's shade.
  void addShade(const Rgba& shade, const Rgba& color, const std::string& meaning) {
    addDot(drawing_, middle_, 2.0 * style_.symbol, shade);
    write(meaning, color);
  }

  void addClutter(bool absorbing, const std::string& meaning) {
    addClutterSymbol(drawing_, middle_, absorbing, style_);
    write(meaning, style_.clutter);
  }

 private:
  void write(const std::string& meaning, const Rgba& color) {
    const double height = 0.9 * style_.small_text;
    const auto id = static_cast<std::uint32_t>(drawing_.labels.size());
    const Eigen::Vector2d corner = middle_ + Eigen::Vector2d(3.0 * style_.symbol, 0.6 * height);
    drawing_.labels.push_back(labelFromCorner(id, corner, meaning, height, color));
    middle_.y() += 3.4 * style_.symbol;
  }

  Drawing& drawing_;
  const PpiStyle& style_;
  Eigen::Vector2d middle_;
};

TrackReport track(TrackState state, TrackKind kind = TrackKind::kPrimary) {
  TrackReport report;
  report.state = state;
  report.kind = kind;
  return report;
}

}  // namespace

void addLegend(Drawing& drawing, const PpiStyle& style) {
  LegendColumn left(drawing, style, kLeft), right(drawing, style, kRight);
  left.addTrack(track(TrackState::kTentative), "tentative");
  left.addTrack(track(TrackState::kCoasting), "coasting");
  left.addTrack(track(TrackState::kFirm, TrackKind::kSecondary), "secondary radar alone");
  left.addTrack(track(TrackState::kFirm, TrackKind::kCorrelated), "both kinds of radar");
  left.addTrack(track(TrackState::kFirm), "firm");
  left.addShade(style.blind, {0.7f, 0.7f, 0.85f, 1.0f}, "radar is blind");
  left.addShade(densestShade(style), style.clutter, "false plots");
  TrackReport searched = track(TrackState::kFirm), answering = searched, handed_off = searched;
  searched.designated = answering.iff = handed_off.handed_off = true;
  right.addTrack(searched, "elevation search");
  right.addTrack(answering, "answers IFF");
  right.addTrack(handed_off, "handed off");
  right.addClutter(false, "clutter on probation");
  right.addClutter(true, "clutter");
}

}  // namespace tws_rviz
