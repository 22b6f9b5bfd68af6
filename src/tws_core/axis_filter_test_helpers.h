#pragma once

#include <tws_core/axis_motion.h>

namespace tws {

/// Takes in a measured position, as whoever uses a filter does.
template <class Filter, class State>
void updateTo(const Filter& filter, State& state, double measured, double dt, const AxisNoise& noise) {
  filter.update(state, measured - moved(Filter::motion(state), dt).position, dt, noise);
}

}  // namespace tws
