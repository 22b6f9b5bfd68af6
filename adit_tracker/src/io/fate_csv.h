#pragma once

#include <iosfwd>

#include "core/adit.h"

namespace adit_tracker {

/// What became of each plot, as text: one row a plot, by sector and range (doc/adit_csv.md has the columns).
class FateCsv {
 public:
  /// Writes the line of column names. `output` is to outlive it.
  explicit FateCsv(std::ostream& output);

  void add(const Adit& adit, const SectorFates& sector);

 private:
  std::ostream& output_;
};

}  // namespace adit_tracker
