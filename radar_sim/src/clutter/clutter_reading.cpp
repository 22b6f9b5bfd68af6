#include "clutter/clutter_reading.h"

#include <cmath>

namespace radar_sim {
namespace {

constexpr std::size_t kMostCorners = 500;

}  // namespace

void readCommon(ParameterReader& reader, const ReadingContext& context, double suppression_db, ClutterSpec& spec) {
  reader.texts("radars", spec.radars);
  double start = 0.0, end = kLongest;
  reader.number("start_s", start, 0.0, kLongest);
  reader.number("end_s", end, 0.0, kLongest);
  if (end <= start) reader.fail("end_s", "is not later than start_s");
  spec.from = context.start_time + start;
  if (reader.has("end_s")) spec.to = context.start_time + end;
  spec.suppression = std::pow(10.0, suppression_db / 10.0);
  readDecibels(reader, "suppression_db", spec.suppression, 0.0, 100.0);
}

void readTexture(ParameterReader& reader, TextureParams& texture) {
  reader.number("texture_db", texture.spread_db, 0.0, 15.0);
  reader.number("texture_length_m", texture.length, 1.0, 1e6);
  reader.number("texture_time_s", texture.time, 0.1, kLongest);
}

Area readArea(ParameterReader& reader, const ReadingContext& context) {
  std::vector<Eigen::Vector2d> corners;
  for (ParameterReader& corner : reader.list("outline")) {
    corners.push_back(readPlace(corner, context));
    corner.done();
  }
  if (!reader.has("outline")) return {};
  if (corners.size() < 3 || corners.size() > kMostCorners)
    reader.fail("outline", "has " + std::to_string(corners.size()) + " corners: 3 to " + std::to_string(kMostCorners));
  return Area(std::move(corners));
}

Eigen::Vector2d readVelocity(ParameterReader& reader) {
  double course = 0.0, speed = 0.0;
  scaledNumber(reader, "course_deg", course, tws::kRadiansPerDegree, 0.0, 360.0);
  readSpeed(reader, speed);
  return {speed * std::sin(course), speed * std::cos(course)};
}

}  // namespace radar_sim
