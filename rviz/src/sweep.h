#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>

#include "drawing.h"

namespace tws_rviz {

/// The beam of one radar enters a sector.
struct BeamMark {
  double time = 0.0;                                                  // data time [s]
  int sector = 0;                                                     // 0..63
  std::uint32_t running_sector = 0;                                   // sectors since the radar's start
  double rotation_period = std::numeric_limits<double>::quiet_NaN();  // [s]; NaN: unknown
};

/// Where a rotating radar's beam points, extrapolated from its latest sector mark with its rotation period.
class Sweep {
 public:
  /// A mark that is not later than the latest one is ignored.
  void mark(const BeamMark& mark);

  /// [rad], in [0, 2π). Nothing before the first mark, when the period is not yet known, and when half a turn has
  /// passed without a mark: a radar that is silent shows no beam.
  std::optional<double> azimuthAt(double time) const;

  /// [s]. NaN: unknown. As the marks say, else from the latest two.
  double rotationPeriod() const { return period_; }

 private:
  std::optional<BeamMark> last_;
  double period_ = std::numeric_limits<double>::quiet_NaN();
};

/// How far from `origin` the ray in that direction stays inside the circle of `radius` round the picture's middle [m];
/// 0 when the origin lies outside of it.
double distanceToRim(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double radius);

/// How a sweep is drawn.
struct SweepLook {
  Rgba color;
  double afterglow = 1.0;      // angle behind the beam that still glows [rad], > 0
  double picture_range = 0.0;  // [m]
  double line_width = 0.0;     // of the beam [m]
};

/// The beam from `origin` [m] to the rim, and the afterglow that fades behind it.
void addSweep(Drawing& drawing, const Eigen::Vector2d& origin, double azimuth, const SweepLook& look);

}  // namespace tws_rviz
