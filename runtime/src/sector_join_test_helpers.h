#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sector_join.h"

namespace tws_runtime {

using Message = std::variant<SectorDetections, SectorCrossing>;
constexpr double kSectorTime = 0.125;  // An eight-second turn.

inline SectorDetections detectionsOf(std::uint32_t sector, double epoch = 0.0) {
  SectorDetections detections;
  detections.running = sector;
  detections.leave_time = epoch + kSectorTime * (sector + 1);
  for (std::uint32_t i = 0; i < sector % 4; ++i) {  // None to three plots, distinguished by their ranges.
    tws::Plot plot;
    plot.time = epoch + kSectorTime * (sector + 0.25 * i);
    plot.range = 1000.0 * sector + i;
    detections.plots.push_back(plot);
  }
  detections.sent_count = detections.plots.size();
  return detections;
}

inline SectorCrossing markOf(std::uint32_t entered, double epoch = 0.0) {
  SectorCrossing mark;
  mark.running = entered;
  mark.time = epoch + kSectorTime * entered;
  mark.closed_count = (entered + 3) % 4;  // Of the sector before.
  mark.rotation_period = 64.0 * kSectorTime;
  return mark;
}

/// What a radar sends from sector `from` up to and with sector `to`, as it sends it.
inline std::vector<Message> run(std::uint32_t from, std::uint32_t to, double epoch = 0.0) {
  std::vector<Message> messages{markOf(from, epoch)};
  for (std::uint32_t sector = from; sector <= to; ++sector) {
    messages.push_back(detectionsOf(sector, epoch));
    messages.push_back(markOf(sector + 1, epoch));
  }
  return messages;
}

inline double timeOf(const Message& message) {
  if (const auto* detections = std::get_if<SectorDetections>(&message)) return detections->leave_time;
  return std::get<SectorCrossing>(message).time;
}

/// A join and what came out of it.
struct Joined {
  std::vector<tws::RadarSector> sectors;
  std::map<std::string, int> faults;
  std::vector<std::string> reasons;
  SectorJoin join{SectorJoin::Options(), events()};

  SectorJoin::Events events() {
    return {[this](tws::RadarSector sector) { sectors.push_back(std::move(sector)); },
            [this](const std::string& counter, const std::string& reason) {
              ++faults[counter];
              reasons.push_back(reason);
            }};
  }
  void add(const std::vector<Message>& messages) {
    for (const Message& message : messages) std::visit([this](const auto& each) { join.add(each); }, message);
  }
};

/// Every sector from `from` to `to` just once, in order, with the times at which the beam crossed and its number of
/// plots.
inline void expectRun(const std::vector<tws::RadarSector>& sectors, std::uint32_t from, std::uint32_t to) {
  ASSERT_EQ(sectors.size(), to - from + 1);
  for (std::uint32_t i = 0; i < sectors.size(); ++i) {
    const std::uint32_t running = from + i;
    EXPECT_EQ(sectors[i].running, running);
    EXPECT_EQ(sectors[i].sector, static_cast<int>(running % 64));
    EXPECT_NEAR(sectors[i].enter_time, kSectorTime * running, 1e-9);
    EXPECT_NEAR(sectors[i].leave_time, kSectorTime * (running + 1), 1e-9);
    EXPECT_EQ(sectors[i].plots.size(), running % 4);
  }
}

template <class Kind>
void drop(std::vector<Message>& messages, std::uint32_t running) {
  const auto is_it = [&](const Message& message) {
    const auto* kind = std::get_if<Kind>(&message);
    return kind && kind->running == running;
  };
  messages.erase(std::remove_if(messages.begin(), messages.end(), is_it), messages.end());
}

}  // namespace tws_runtime
