#pragma once

#include <algorithm>
#include <iterator>

namespace tws {

/// Past the last in a row that has the time of the first: of plots in order of time, those of one instant. `first` is
/// not `last`.
template <class Iterator>
Iterator endOfInstant(Iterator first, Iterator last) {
  return std::find_if(std::next(first), last, [&](const auto& plot) { return plot.time != first->time; });
}

}  // namespace tws
