#pragma once

#include <tws_msgs/ElevationRequests.h>
#include <tws_runtime/bus.h>

#include <optional>

#include "elevation/elevation_handler.h"

namespace adit_tracker {

/// What one radar shall search for goes out on its topic /RADAR/elevation_requests, once a scan, also when it is
/// nothing: a simulated radar waits for it.
class ElevationInterface {
 public:
  ElevationInterface(tws_runtime::Bus& bus, const AditParams& params);

  /// A run begins. `adit` must outlive it.
  void begin(const Adit& adit) { handler_.emplace(adit); }
  /// To be called after each sector, while its updates are valid.
  void afterSector(Adit& adit, const SectorReport& report);

 private:
  std::string radar_;
  tws_runtime::Publisher<tws_msgs::ElevationRequests> requests_;
  std::optional<ElevationHandler> handler_;
};

}  // namespace adit_tracker
