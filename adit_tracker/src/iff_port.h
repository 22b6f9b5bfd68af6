#pragma once

#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/bus.h>

#include <deque>

#include "adit.h"
#include "radar_sites.h"

namespace adit_tracker {

/// Hears the plots of secondary radars for the IFF bit. They never hold up the radars.
class IffPort {
 public:
  IffPort(tws_runtime::Bus& bus, const std::string& frame, const std::vector<IffParams>& params);

  /// A new run: what waits belongs to the old one.
  void beginNewRun() { waiting_.clear(); }
  /// Gives the tracker what has come. To be called before it works, once the radars' origin is known.
  void handOver(Adit& adit, const RadarSites& sites);

 private:
  struct Waiting {
    std::size_t iff;
    std::string frame;
    tws::RadarSector sector;
  };
  void hear(std::size_t iff, const tws_msgs::SsrPlots& message);

  tws_runtime::Bus& bus_;
  std::string frame_;
  std::vector<IffParams> params_;
  std::deque<Waiting> waiting_;
};

}  // namespace adit_tracker
