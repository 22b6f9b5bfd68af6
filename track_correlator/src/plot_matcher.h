#pragma once

#include <cstddef>
#include <vector>

#include <tws_core/assignment.h>

#include "secondary_params.h"
#include "secondary_track.h"

namespace track_correlator {

/// A plot and its position on the plane of motion.
struct PlacedPlot {
  const SecondaryPlot* plot = nullptr;
  tws::PlanarMeasurement measured;
};
PlacedPlot place(const SecondaryPlot& plot, const SecondaryParams& params);

/// The track's state at a later time.
tws::PlanarState predicted(const SecondaryTrack& track, double time, const SecondaryParams& params);

/// Which plot belongs to which track: by code where it is unique, else by position.
class PlotMatcher {
 public:
  static constexpr int kNone = -1;

  explicit PlotMatcher(const SecondaryParams& params) : params_(params) {}

  /// For each track its plot, or kNone. A code is unique where one track and one plot, no further apart than the code
  /// gate, have it. What is left is assigned by the least sum of normalised innovations and code costs.
  /// `neighbours` take no plots here, but their replies may overlap those of `tracks`.
  const std::vector<int>& match(const std::vector<const SecondaryTrack*>& tracks, const std::vector<PlacedPlot>& plots,
                                const std::vector<const SecondaryTrack*>& neighbours = {});

  /// Whether the last match() found the plot's code to be the track's, garbled by another track.
  bool garbled(std::size_t track, const SecondaryPlot& plot) const;

 private:
  struct Option {
    std::uint32_t track, plot;
    Agreement agreement;
    double distance;    // [m]
    double innovation;  // normalised, squared
  };

  void listOptions(const std::vector<PlacedPlot>& plots);
  void matchUniqueCodes(std::size_t plots);
  void matchByPosition(std::size_t plots);
  double costOf(const Option& option) const;

  SecondaryParams params_;
  std::vector<const SecondaryTrack*> tracks_;
  std::vector<const SecondaryTrack*> around_;  // tracks_ and their neighbours
  std::vector<Option> options_;
  std::vector<int> plot_of_, track_of_;
  std::vector<tws::AssignmentSolver::Pair> pairs_;
  tws::AssignmentSolver solver_;
};

}  // namespace track_correlator
