#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tws_core/plot.h>

namespace adit_tracker {

/// A track in whose region a plot lay.
struct PlotClaim {
  std::uint32_t uid;
  float sigmas;  // distance from its prediction, standard deviations; NaN with fixed gates
  float chance =
      0.0F;           // that its target made the plot; 0 when it was not its turn, 1 for the taker where none is known
  bool took = false;  // the plot went to this track
};

/// What became of a plot.
struct PlotFate {
  enum Kind {
    kUpdated,  // it updated a track
    kStarted,  // it started one
    kClutter,  // a clutter point took it
    kLeft      // nobody: it is rather a track's that took another plot, or one track's and another's to equal parts
  };
  tws::Plot plot;
  Kind kind;
  std::uint32_t uid;              // of the track updated or started; 0: none
  double left;                    // chance that neither a track nor a clutter point made it
  std::vector<PlotClaim> claims;  // in the order of the tracks' first claims
};

/// The plots of a sector, when nothing more can happen to them.
struct SectorFates {
  std::size_t radar;
  std::int64_t running;
  std::vector<PlotFate> plots;  // by range
};

}  // namespace adit_tracker
