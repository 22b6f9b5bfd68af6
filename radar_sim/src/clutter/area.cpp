#include "clutter/area.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {
namespace {

constexpr int kPointsOnCircle = 36;
constexpr double kPointsOnBorder = 60.0;

}  // namespace

// A ray from the place to the east crosses the border an odd number of times.
bool Area::contains(const Eigen::Vector2d& place) const {
  if (isEverywhere()) return true;
  bool inside = false;
  for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
    const Eigen::Vector2d &a = corners_[i], &b = corners_[before];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    const double east = a.x() + (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y());
    if (place.x() < east) inside = !inside;
  }
  return inside;
}

std::vector<Eigen::Vector2d> Area::outline() const {
  std::vector<Eigen::Vector2d> points;
  double border = 0.0;
  const auto side = [&](std::size_t i) { return Eigen::Vector2d(corners_[(i + 1) % corners_.size()] - corners_[i]); };
  for (std::size_t i = 0; i < corners_.size(); ++i) border += side(i).norm();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::lround(kPointsOnBorder * side(i).norm() / border)));
    for (int piece = 0; piece < pieces; ++piece) points.push_back(corners_[i] + side(i) * piece / pieces);
  }
  return points;
}

std::vector<Eigen::Vector2d> circle(const Eigen::Vector2d& centre, double radius) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kPointsOnCircle; ++i) {
    const double azimuth = tws::kTwoPi * i / kPointsOnCircle;
    points.push_back(centre + radius * Eigen::Vector2d(std::sin(azimuth), std::cos(azimuth)));
  }
  return points;
}

}  // namespace radar_sim
