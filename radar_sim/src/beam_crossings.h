#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "antenna.h"
#include "target.h"

namespace radar_sim {

/// When the centre of the beam passes over each target, once a revolution.
class BeamCrossings {
 public:
  /// Azimuth of a target, given by its index, at the antenna [rad].
  using AzimuthOf = std::function<double(std::size_t target, double time)>;
  struct Crossing {
    double time;  ///< [s of data time]
    std::size_t target;
  };

  /// `targets`, and what `azimuth` refers to, must outlive this.
  BeamCrossings(const Antenna& antenna, const std::vector<Target>& targets, AzimuthOf azimuth, double start_time);

  /// The next crossing before `until`, in order of time; nothing: there is none.
  std::optional<Crossing> next(double until);

 private:
  struct Scheduled {
    Crossing crossing;
    bool found;  ///< false: there was none; search again from its time on.
    bool operator>(const Scheduled& other) const {
      return crossing.time != other.crossing.time ? crossing.time > other.crossing.time
                                                  : crossing.target > other.crossing.target;
    }
  };

  double quarterRevolution() const;
  void schedule(std::size_t target, double after);

  Antenna antenna_;
  const std::vector<Target>& targets_;
  AzimuthOf azimuth_;
  std::priority_queue<Scheduled, std::vector<Scheduled>, std::greater<>> scheduled_;
};

}  // namespace radar_sim
