#pragma once

#include <optional>
#include <vector>

#include <tws_core/rotation.h>

namespace tws {

/// The times of a radar's plots are whole steps from the first: of a clock that was cut off or rounded, or one for each
/// revolution. Returns the step [s], 0.02 or more; 0: they are not, or there are less than 20 plots or three times.
double commonStep(const TimedAzimuths& plots);

/// When the beam was at each plot's azimuth [s], for plots whose times are steps [s]: its passage next to the time, but
/// for what the times are off in the middle (half a step when they are cut off and the rotation is right). A plot
/// further from the beam than its time may be keeps its time, but for that middle.
std::vector<double> refinedTimes(const TimedAzimuths& plots, const Rotation& rotation, double step);

/// The beam of plots, in order of time, that have one time for each revolution, as it turns from north on at that time.
/// Nothing: they do not; so is a step of one second or less, or of a minute or more, understood.
std::optional<Rotation> rotationOfWholeScans(const TimedAzimuths& plots);

}  // namespace tws
