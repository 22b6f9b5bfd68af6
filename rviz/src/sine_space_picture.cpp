#include "sine_space_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

constexpr double kGrid = 0.1;
// The inset: its height and its distance from the picture below, on the screen in units of sine space.
constexpr double kInsetHeight = 0.26;
constexpr double kInsetGap = 0.06;
constexpr double kMagnification = 6.0;
// So long a sequence of fewer beams does not take the inset over [s].
constexpr double kInsetHold = 3.0;
constexpr int kContourCorners = 36;
constexpr double kScale = SineSpacePicture::kMetresPerUnit;
const Rgba kSearchBeam{0.10f, 0.55f, 0.25f, 0.8f};
const Rgba kTrackBeam{0.25f, 0.70f, 1.00f, 0.9f};
const Rgba kFrameBeam{1.00f, 0.85f, 0.25f, 1.0f};
const Rgba kKept{0.95f, 0.95f, 0.95f, 1.0f};
const Rgba kDiscarded{1.00f, 0.25f, 0.20f, 1.0f};

bool isSame(const SineSpaceMeasurement& a, const SineSpaceMeasurement& b) {
  return a.range == b.range && a.u == b.u && a.v == b.v;
}

bool holds(const std::vector<SineSpaceMeasurement>& measurements, const SineSpaceMeasurement& wanted) {
  return std::any_of(measurements.begin(), measurements.end(),
                     [&](const SineSpaceMeasurement& measurement) { return isSame(measurement, wanted); });
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

bool SineSpacePicture::View::shows(const Eigen::Vector2d& direction) const {
  return ((direction - centre).array().abs() <= half.array()).all();
}

Eigen::Vector2d SineSpacePicture::View::at(const Eigen::Vector2d& direction) const {
  return kScale * (place + magnification * (direction - centre));
}

SineSpacePicture::SineSpacePicture(double half_width, double low, double high, double persistence)
    : half_width_(half_width), low_(low), high_(high), persistence_(persistence), style_(0.8 * kScale * half_width) {}

std::vector<SineSpacePicture::View> SineSpacePicture::views() const {
  const Eigen::Vector2d centre(0.0, (low_ + high_) / 2.0);
  const Eigen::Vector2d inset(half_width_, kInsetHeight / 2.0);
  return {{centre, {half_width_, (high_ - low_) / 2.0}, centre, 1.0},
          {zoom_, inset / kMagnification, {0.0, high_ + kInsetGap + kInsetHeight / 2.0}, kMagnification}};
}

void SineSpacePicture::add(DwellMark dwell) {
  forgetOld(dwell.time);
  follow(dwell);
  dwells_.push_back(std::move(dwell));
}

void SineSpacePicture::follow(const DwellMark& dwell) {
  if (dwell.group == 0) return;
  if (dwell.group != sequence_.group) {
    const bool is_held = dwell.group_dwells < sequence_.dwells && dwell.time - sequence_.time < kInsetHold;
    if (is_held) return;
    sequence_ = {dwell.group, dwell.group_dwells, dwell.time, Eigen::Vector2d::Zero(), 0};
  }
  sequence_.time = dwell.time;
  sequence_.sum += Eigen::Vector2d(dwell.u, dwell.v);
  if (++sequence_.received == static_cast<int>(sequence_.dwells)) zoom_ = sequence_.sum / sequence_.received;
}

void SineSpacePicture::add(const FrameMark& frame) {
  frame_ = frame;
  kept_ = discarded_ = 0;
  for (const DwellMark& in_frame : frame.dwells) {
    const auto isIt = [&](const DwellMark& dwell) { return dwell.number == in_frame.number; };
    const auto seen = std::find_if(dwells_.begin(), dwells_.end(), isIt);
    for (const SineSpaceMeasurement& measurement : seen == dwells_.end() ? in_frame.measurements : seen->measurements) {
      const bool kept = holds(in_frame.measurements, measurement);
      ++(kept ? kept_ : discarded_);
      measurements_.push_back({frame.time, measurement, kept});
    }
  }
}

double SineSpacePicture::freshness(double since, double time) const {
  return std::clamp(1.0 - (time - since) / persistence_, 0.0, 1.0);
}

void SineSpacePicture::forgetOld(double time) {
  const auto isOld = [&](const auto& entry) { return freshness(entry.time, time) <= 0.0; };
  while (!dwells_.empty() && isOld(dwells_.front())) dwells_.pop_front();
  while (!measurements_.empty() && isOld(measurements_.front())) measurements_.pop_front();
}

void SineSpacePicture::addContour(Drawing& drawing, const View& view, const DwellMark& dwell, double width,
                                  const Rgba& color) const {
  const auto corner = [&](int i) {
    const double turn = tws::kTwoPi * i / kContourCorners;
    return Eigen::Vector2d(dwell.u + dwell.beamwidth_u / 2.0 * std::cos(turn),
                           dwell.v + dwell.beamwidth_v / 2.0 * std::sin(turn));
  };
  for (int i = 0; i < kContourCorners; ++i)
    if (view.shows(corner(i)) && view.shows(corner(i + 1)))
      addLine(drawing, view.at(corner(i)), view.at(corner(i + 1)), width, color);
}

void SineSpacePicture::addGrid(Drawing& drawing) const {
  const double left = kScale * half_width_, bottom = kScale * low_, top = kScale * high_, thin = style_.line / 2.0;
  const auto steps = [](double value) { return static_cast<int>(std::floor(value / kGrid + 1e-9)); };
  for (int i = -steps(half_width_); i <= steps(half_width_); ++i) {
    const double x = kScale * kGrid * i;
    addLine(drawing, {x, bottom}, {x, top}, thin, i == 0 ? style_.ring : style_.spoke);
    addText(drawing, {x, bottom - style_.small_text}, format("%.1f", kGrid * i), style_.small_text, style_.scale_text);
  }
  for (int i = -steps(-low_); i <= steps(high_); ++i) {
    const double y = kScale * kGrid * i;
    addLine(drawing, {-left, y}, {left, y}, thin, i == 0 ? style_.ring : style_.spoke);
    addText(drawing, {-left - 1.6 * style_.small_text, y}, format("%.1f", kGrid * i), style_.small_text,
            style_.scale_text);
  }
  addText(drawing, {left, bottom - style_.small_text}, "u", style_.text, style_.scale_text);
  addText(drawing, {-left - 1.6 * style_.small_text, bottom}, "v", style_.text, style_.scale_text);
}

Drawing SineSpacePicture::background() const {
  Drawing drawing;
  addGrid(drawing);
  const View inset = views().back();
  const Eigen::Vector2d half = kScale * inset.magnification * inset.half, centre = kScale * inset.place;
  const Eigen::Vector2d corners[] = {
      {-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
  for (int i = 0; i < 4; ++i)
    addLine(drawing, centre + corners[i], centre + corners[(i + 1) % 4], style_.line / 2.0, style_.ring);
  const Eigen::Vector2d corner = centre + corners[3] + Eigen::Vector2d(style_.small_text, -0.5 * style_.small_text);
  drawing.labels.push_back(labelFromCorner(static_cast<std::uint32_t>(drawing.labels.size()), corner,
                                           format("%.0f times", kMagnification), style_.small_text, style_.scale_text));
  return drawing;
}

Drawing SineSpacePicture::beams(double time) const {
  Drawing drawing;
  const double thin = style_.line / 2.0;
  for (const View& view : views()) {
    for (const DwellMark& dwell : dwells_)
      addContour(drawing, view, dwell, thin,
                 faded(dwell.on_track ? kTrackBeam : kSearchBeam, freshness(dwell.time, time)));
    for (const DwellMark& dwell : frame_.dwells)
      addContour(drawing, view, dwell, 2.0 * thin, faded(kFrameBeam, freshness(frame_.time, time)));
  }
  return drawing;
}

Drawing SineSpacePicture::measurements(double time) const {
  Drawing drawing;
  for (const View& view : views()) {
    for (const AgedMeasurement& aged : measurements_) {
      const Eigen::Vector2d direction(aged.measurement.u, aged.measurement.v);
      if (!view.shows(direction)) continue;
      const double fresh = freshness(aged.time, time);
      if (aged.kept)
        addDot(drawing, view.at(direction), style_.dot, faded(kKept, fresh));
      else
        addCross(drawing, view.at(direction), style_.plot, tws::kPi / 4.0, style_.line / 2.0, faded(kDiscarded, fresh));
    }
  }
  return drawing;
}

Drawing SineSpacePicture::tracks() const {
  Drawing drawing;
  for (const View& view : views()) {
    for (const SineSpaceTrack& track : tracks_) {
      const Eigen::Vector2d direction(track.u, track.v);
      if (!view.shows(direction)) continue;
      const Eigen::Vector2d place = view.at(direction);
      const Rgba& color = track.firm ? style_.firm : style_.tentative;
      addPolygon(drawing, place, {track.firm ? 24 : 4, 0.6 * style_.symbol, 0.0}, style_.line / 2.0, color);
      // In the picture as a whole, numbers of closely spaced tracks would lie on each other.
      const bool is_crowded = view.magnification == 1.0 && views().back().shows(direction);
      if (!track.firm || is_crowded) continue;
      const Eigen::Vector2d corner = place + Eigen::Vector2d(0.7, 1.6) * style_.symbol;
      const std::uint32_t id = 2 * track.number + (view.magnification > 1.0 ? 1 : 0);
      drawing.labels.push_back(
          labelFromCorner(id, corner, std::to_string(track.number), 0.8 * style_.small_text, color));
    }
  }
  return drawing;
}

Drawing SineSpacePicture::status() const {
  Drawing drawing;
  const std::string text = "frame " + std::to_string(frame_.number) + ": " + std::to_string(frame_.dwells.size()) +
                           " dwells, " + std::to_string(kept_) + " kept, " + std::to_string(discarded_) + " discarded";
  const Eigen::Vector2d corner = kScale * Eigen::Vector2d(-half_width_, high_ + kInsetGap + kInsetHeight) +
                                 Eigen::Vector2d(0.0, 2.0 * style_.text);
  drawing.labels.push_back(labelFromCorner(0, corner, text, style_.text, kFrameBeam));
  return drawing;
}

}  // namespace tws_rviz
