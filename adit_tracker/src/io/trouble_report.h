#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/count_report.h>

#include <cstddef>

#include "core/adit.h"

namespace adit_tracker {

/// What goes wrong in the tracker, as counters of the Bus with their reasons.
class TroubleReport {
 public:
  /// `overflow`: so many sectors behind the radars the node skips some.
  TroubleReport(tws_runtime::Bus& bus, const AditParams& params, std::size_t overflow);

  /// After each sector.
  void add(const Adit& adit);
  /// A new run: the tracker counts anew.
  void beginNewRun() { counts_.reset(); }

 private:
  void warnOfCapacity(const Adit& adit);

  tws_runtime::Bus& bus_;
  tws_runtime::CountReport<AditCounts> counts_;
  bool warned_ = false;  // of the capacity
};

}  // namespace adit_tracker
