#pragma once

#include <tws_core/plot.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sector_join.h"

namespace tws_runtime {

/// A SectorJoin for each of several radars. When time goes back on one, a new run begins for all: what still comes from
/// the others' old run is dropped.
class RadarJoins {
 public:
  struct Events {
    std::function<void(std::size_t radar, tws::RadarSector)> sector;
    std::function<void(double time)> new_run;
    std::function<void(std::size_t radar, const std::string& counter, const std::string& reason)> fault;
  };

  RadarJoins(std::size_t radars, SectorJoin::Options options, Events events);
  RadarJoins(const RadarJoins&) = delete;
  RadarJoins& operator=(const RadarJoins&) = delete;

  void add(std::size_t radar, SectorDetections detections);
  void add(std::size_t radar, SectorCrossing mark);

 private:
  bool isOld(std::size_t radar, double time);
  void beginNewRun(std::size_t radar, double time);
  double newestTime() const;

  Events events_;
  std::vector<SectorJoin> joins_;
  std::vector<bool> in_old_run_;  ///< Radars that have not gone back yet after another one has.
  double newest_time_;            ///< Of all radars [s].
  double old_time_ = 0.0;         ///< Where the old run ended [s].
};

}  // namespace tws_runtime
