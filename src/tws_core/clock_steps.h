#pragma once

#include <vector>

#include <tws_core/rotation.h>

namespace tws {

/// A radar's clock was set while its antenna turned on.
struct ClockStep {
  double time;  // of the last plot before it [s]
  double step;  // by which the clock was put forward, < 0: back [s]
};

/// The steps of one radar's clock and what they did to its plots.
struct ClockSteps {
  std::vector<ClockStep> steps;     // in order of time
  std::vector<double> corrections;  // for each plot, to be added to its time [s]: as if the clock had not been set
};

/// Finds out which breaks of a rotation are steps of the radar's clock: the antenna goes on at the same speed, and what
/// came within two and a half revolutions lies on the beam as it was before or as it is afterwards. A step back makes
/// plots of both lie between each other. `plots` in order of time, those from which `rotation` was made. Corrections
/// are zero in the part between two steps that has the most plots: its times stay.
ClockSteps findClockSteps(const TimedAzimuths& plots, const Rotation& rotation);

}  // namespace tws
