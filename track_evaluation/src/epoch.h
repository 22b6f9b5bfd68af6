#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace track_evaluation {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint16_t kCodeUnknown = 65535;

/// Position [m] and velocity [m/s] on a plane, x east and y north.
struct PlanarState {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
};

/// The state as a radar at `site` [m] sees it that knows no height: slant range and azimuth drawn on the plane. Each
/// target moves outwards from its ground range to its slant range; bearings stay.
PlanarState onSlantPlane(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, const Eigen::Vector3d& site);

/// One target at an epoch.
struct TruthState {
  std::uint32_t id = 0;
  PlanarState ground;
  PlanarState slant;     ///< As onSlantPlane; compared with tracks that know no height.
  bool required = true;  ///< False: nobody asks for a track of it, but a track of it is not wrong either.
  std::uint16_t mode_3a = kCodeUnknown;
  double height = kUnknown;  ///< [m]
};

/// One confirmed track, extrapolated to an epoch.
struct TrackState {
  std::uint32_t id = 0;  ///< Unique in the run.
  std::uint16_t mode_3a = kCodeUnknown;
  bool has_height = true;  ///< False: a position on the slant plane.
  PlanarState state;
  double age = 0.0;               ///< Since the instant at which its tracker stated position and velocity [s], >= 0.
  double last_update = kUnknown;  ///< Of the latest detection used [s].
  double height = kUnknown;       ///< [m]
  std::optional<Eigen::Matrix4d> covariance;  ///< Of x, y, vx, vy [m, m/s].
};

/// Truth and tracks at one instant [s].
struct Epoch {
  double time = 0.0;
  std::vector<TruthState> truths;
  std::vector<TrackState> tracks;
};

/// The truth's state on the plane of the track.
inline const PlanarState& comparable(const TruthState& truth, const TrackState& track) {
  return track.has_height ? truth.ground : truth.slant;
}

/// Distances [m] between the truths and the tracks of an epoch. Holds its memory.
class Distances {
 public:
  void compute(const Epoch& epoch);
  double at(std::size_t truth, std::size_t track) const { return values_[truth * tracks_ + track]; }

 private:
  std::size_t tracks_ = 0;
  std::vector<double> values_;
};

}  // namespace track_evaluation
