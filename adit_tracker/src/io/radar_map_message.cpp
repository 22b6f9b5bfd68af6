#include "io/radar_map_message.h"

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {

tws_msgs::RadarMap radarMapMessage(const Adit& adit, std::size_t radar) {
  constexpr int kBins = 32;
  constexpr double kSquareMetresPerSquareKilometre = 1e6;
  const RadarQuality& quality = adit.radars().quality(radar);
  const auto& pose = adit.radars().at(radar).pose;
  const double heading = pose ? pose->heading : 0.0;  // whither the radar's azimuth 0 points
  tws_msgs::RadarMap message;
  message.radar = adit.params().radars[radar].name;
  message.bins = kBins;
  message.depth = quality.falsePlotMap().greatestRange() / kBins;
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    const double azimuth = tws::wrapTwoPi(tws::sectorStart(sector) + 0.5 * tws::kSectorWidth + heading);
    for (int bin = 0; bin < kBins; ++bin) {
      const double range = (bin + 0.5) * message.depth;
      const double density = quality.falsePlotMap().density(range, azimuth);
      message.false_plots.push_back(static_cast<float>(density * kSquareMetresPerSquareKilometre));
      message.blind.push_back(quality.coverage().hasLooked() && quality.coverage().isBlind(range, azimuth));
    }
  }
  return message;
}

}  // namespace adit_tracker
