#include "sine_space_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

constexpr double kGrid = 0.1;
constexpr int kContourCorners = 36;
constexpr double kScale = SineSpacePicture::kMetresPerUnit;
const Rgba kSearchBeam{0.10f, 0.55f, 0.25f, 0.8f};
const Rgba kTrackBeam{0.25f, 0.70f, 1.00f, 0.9f};
const Rgba kFrameBeam{1.00f, 0.85f, 0.25f, 1.0f};
const Rgba kKept{0.95f, 0.95f, 0.95f, 1.0f};
const Rgba kDiscarded{1.00f, 0.25f, 0.20f, 1.0f};

Eigen::Vector2d onScreen(double u, double v) { return kScale * Eigen::Vector2d(u, v); }

bool isSame(const SineSpaceBlip& a, const SineSpaceBlip& b) { return a.range == b.range && a.u == b.u && a.v == b.v; }

bool holds(const std::vector<SineSpaceBlip>& blips, const SineSpaceBlip& wanted) {
  return std::any_of(blips.begin(), blips.end(), [&](const SineSpaceBlip& blip) { return isSame(blip, wanted); });
}

std::string format(const char* pattern, double value) {
  char text[32];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void addText(Drawing& drawing, const Eigen::Vector2d& centre, const std::string& text, double height,
             const Rgba& color) {
  drawing.labels.push_back({static_cast<std::uint32_t>(drawing.labels.size()), centre, height, text, color});
}

}  // namespace

SineSpacePicture::SineSpacePicture(double half_width, double half_height, double persistence)
    : half_width_(half_width),
      half_height_(half_height),
      persistence_(persistence),
      style_(0.8 * kScale * half_width) {}

void SineSpacePicture::hear(DwellMark dwell) {
  forgetOld(dwell.time);
  dwells_.push_back(std::move(dwell));
}

void SineSpacePicture::hear(const FrameMark& frame) {
  frame_ = frame;
  kept_ = discarded_ = 0;
  for (const DwellMark& in_frame : frame.dwells) {
    const auto isIt = [&](const DwellMark& dwell) { return dwell.number == in_frame.number; };
    const auto seen = std::find_if(dwells_.begin(), dwells_.end(), isIt);
    for (const SineSpaceBlip& blip : seen == dwells_.end() ? in_frame.blips : seen->blips) {
      const bool kept = holds(in_frame.blips, blip);
      ++(kept ? kept_ : discarded_);
      blips_.push_back({frame.time, blip, kept});
    }
  }
}

double SineSpacePicture::freshness(double since, double time) const {
  return std::clamp(1.0 - (time - since) / persistence_, 0.0, 1.0);
}

void SineSpacePicture::forgetOld(double time) {
  const auto isOld = [&](const auto& entry) { return freshness(entry.time, time) <= 0.0; };
  while (!dwells_.empty() && isOld(dwells_.front())) dwells_.pop_front();
  while (!blips_.empty() && isOld(blips_.front())) blips_.pop_front();
}

void SineSpacePicture::addContour(Drawing& drawing, const DwellMark& dwell, double width, const Rgba& color) const {
  const auto corner = [&](int i) {
    const double turn = tws::kTwoPi * i / kContourCorners;
    return onScreen(dwell.u + dwell.beamwidth_u / 2.0 * std::cos(turn),
                    dwell.v + dwell.beamwidth_v / 2.0 * std::sin(turn));
  };
  for (int i = 0; i < kContourCorners; ++i) addLine(drawing, corner(i), corner(i + 1), width, color);
}

Drawing SineSpacePicture::background() const {
  Drawing drawing;
  const double left = kScale * half_width_, top = kScale * half_height_;
  const int columns = static_cast<int>(std::floor(half_width_ / kGrid + 1e-9));
  const int rows = static_cast<int>(std::floor(half_height_ / kGrid + 1e-9));
  for (int i = -columns; i <= columns; ++i) {
    const double x = kScale * kGrid * i;
    addLine(drawing, {x, -top}, {x, top}, style_.line / 2.0, i == 0 ? style_.ring : style_.spoke);
    addText(drawing, {x, -top - style_.small_text}, format("%.1f", kGrid * i), style_.small_text, style_.scale_text);
  }
  for (int i = -rows; i <= rows; ++i) {
    const double y = kScale * kGrid * i;
    addLine(drawing, {-left, y}, {left, y}, style_.line / 2.0, i == 0 ? style_.ring : style_.spoke);
    addText(drawing, {-left - 1.5 * style_.small_text, y}, format("%.1f", kGrid * i), style_.small_text,
            style_.scale_text);
  }
  addText(drawing, {left + 1.5 * style_.text, -top - style_.small_text}, "u", style_.text, style_.scale_text);
  addText(drawing, {-left - 1.5 * style_.small_text, top}, "v", style_.text, style_.scale_text);
  return drawing;
}

Drawing SineSpacePicture::beams(double time) const {
  Drawing drawing;
  const double thin = style_.line / 2.0;
  for (const DwellMark& dwell : dwells_)
    addContour(drawing, dwell, thin, faded(dwell.on_track ? kTrackBeam : kSearchBeam, freshness(dwell.time, time)));
  for (const DwellMark& dwell : frame_.dwells)
    addContour(drawing, dwell, 2.0 * thin, faded(kFrameBeam, freshness(frame_.time, time)));
  return drawing;
}

Drawing SineSpacePicture::blips(double time) const {
  Drawing drawing;
  for (const AgedBlip& aged : blips_) {
    const Eigen::Vector2d place = onScreen(aged.blip.u, aged.blip.v);
    const double fresh = freshness(aged.time, time);
    if (aged.kept)
      addDot(drawing, place, style_.dot, faded(kKept, fresh));
    else
      addCross(drawing, place, style_.blip, tws::kPi / 4.0, style_.line / 2.0, faded(kDiscarded, fresh));
  }
  return drawing;
}

Drawing SineSpacePicture::tracks() const {
  Drawing drawing;
  for (const SineSpaceTrack& track : tracks_) {
    const Eigen::Vector2d place = onScreen(track.u, track.v);
    const Rgba& color = track.firm ? style_.firm : style_.tentative;
    addPolygon(drawing, place, {track.firm ? 24 : 4, 0.6 * style_.symbol, 0.0}, style_.line / 2.0, color);
    if (!track.firm) continue;
    const Eigen::Vector2d corner = place + Eigen::Vector2d(0.7, 1.6) * style_.symbol;
    drawing.labels.push_back(
        labelFromCorner(track.number, corner, std::to_string(track.number), 0.8 * style_.small_text, color));
  }
  return drawing;
}

Drawing SineSpacePicture::status() const {
  Drawing drawing;
  const std::string text = "frame " + std::to_string(frame_.number) + ": " + std::to_string(frame_.dwells.size()) +
                           " dwells, " + std::to_string(kept_) + " kept, " + std::to_string(discarded_) + " discarded";
  const Eigen::Vector2d corner =
      kScale * Eigen::Vector2d(-half_width_, half_height_) + Eigen::Vector2d(0.0, 2.0 * style_.text);
  drawing.labels.push_back(labelFromCorner(0, corner, text, style_.text, kFrameBeam));
  return drawing;
}

}  // namespace tws_rviz
