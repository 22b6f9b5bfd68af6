#pragma once

#include <optional>

#include <tws_core/plot.h>

namespace adit_tracker {

/// The plots of one radar in a file, sector by sector.
class PlotFeed {
 public:
  virtual ~PlotFeed() = default;

  /// When the next sector closes; nothing: there are no more.
  virtual std::optional<double> nextTime() const = 0;
  /// The next sector, empty ones too, up to the one with the last plot.
  virtual tws::RadarSector take() = 0;
};

}  // namespace adit_tracker
