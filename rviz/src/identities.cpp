#include "identities.h"

#include <cmath>

namespace tws_rviz {
namespace {

constexpr double kMemory = 30.0;              // [s]
constexpr double kGreatestAge = 10.0;         // [s]
constexpr double kGreatestDistance = 1500.0;  // [m]

}  // namespace

void Identities::add(const IdentityPlot& plot) {
  if (plot.text.empty()) return;
  plots_.push_back(plot);
  while (std::abs(plots_.front().time - plot.time) > kMemory) plots_.pop_front();
}

std::string Identities::at(double time, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) const {
  double least = kGreatestDistance;
  const IdentityPlot* nearest = nullptr;
  for (const IdentityPlot& plot : plots_) {
    const double age = plot.time - time;
    if (!(std::abs(age) <= kGreatestAge)) continue;
    const double distance = (position + age * velocity - plot.position).norm();
    if (!(distance <= least)) continue;
    least = distance;
    nearest = &plot;
  }
  return nearest ? nearest->text : "";
}

}  // namespace tws_rviz
