#pragma once

#include <Eigen/Core>
#include <deque>
#include <string>

namespace tws_rviz {

/// What a secondary radar says of one aircraft.
struct IdentityPlot {
  double time = 0.0;         // data time of the plot [s]
  Eigen::Vector2d position;  // [m]
  std::string text;          // e.g. "4271 F350"
};

/// The latest plots of the secondary radars: they lend their codes and levels to tracks that have none of their own.
class Identities {
 public:
  /// Forgets what is older than half a minute.
  void add(const IdentityPlot& plot);

  /// What the plot says that lies nearest to a track, moved on to the plot's time: at most 1.5 km from it and ten
  /// seconds. Of plots in one place the latest. Empty: there is none.
  std::string at(double time, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) const;

 private:
  std::deque<IdentityPlot> plots_;  // in order of arrival
};

}  // namespace tws_rviz
