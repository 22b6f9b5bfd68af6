#pragma once

#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/site_gate.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "core/adit.h"
#include "io/radar_sites.h"

namespace adit_tracker {

/// Hears the plots of secondary radars for the IFF bit. They never hold up the radars.
class IffInterface {
 public:
  /// Of each secondary radar so many sectors wait, four turns, for the primary radars to come so far; then the oldest
  /// is left out and counted. More than two turns are not needed: the bit goes after a turn and a half.
  static constexpr std::size_t kMostWaiting = std::size_t{4} * tws::kSectors;
  /// So many wait for the site, two turns; then that is unknown for good, and the radar's plots are left out.
  static constexpr std::size_t kPatience = std::size_t{2} * tws::kSectors;

  /// `restart_limit` as of the radars [s].
  IffInterface(tws_runtime::Bus& bus, const std::string& frame, const std::vector<IffParams>& params,
               double restart_limit);

  /// The radars have gone back to this time [s]. What waits belongs to the old run, and so does what comes, until it
  /// has gone back too: it lies more than the restart limit ahead of the radars.
  void beginNewRun(double time);
  /// A radar has come to this time [s].
  void radarsAt(double time) { radars_at_ = std::max(radars_at_, time); }
  /// Gives the tracker what it needs by now. To be called before it works, once the radars' origin is known.
  void handOver(Adit& adit, const RadarSites& sites);

 private:
  struct Interrogator {
    std::string name;
    tws_runtime::SiteGate gate;
    std::deque<tws::RadarSector> waiting = {};  // for the radars, in the order in which they came
    bool gone_back = true;                      // after the radars
  };
  void onPlots(Interrogator& iff, const tws_msgs::SsrPlots& message);
  void addSector(Interrogator& iff, const std::string& frame, tws::RadarSector sector);
  void await(Interrogator& iff, tws::RadarSector sector);
  void leaveOut(const char* counter, std::size_t plots, const std::string& reason);

  tws_runtime::Bus& bus_;
  double restart_limit_;
  double radars_at_ = -std::numeric_limits<double>::infinity();  // the latest time that a radar has told [s]
  std::vector<Interrogator> interrogators_;
};

}  // namespace adit_tracker
