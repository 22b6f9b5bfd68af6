#include "io/registration_message.h"

#include <algorithm>

namespace adit_tracker {

tws_msgs::Registration registrationMessage(const Adit& adit) {
  tws_msgs::Registration message;
  const auto& reports = adit.registration().reports();
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const tws::RegistrationReport& report = reports[i];
    tws_msgs::RadarRegistration& radar = message.radars.emplace_back();
    radar.radar = adit.params().radars[i].name;
    radar.state = static_cast<std::uint8_t>(report.state);
    radar.relative_only = report.relative_only;
    radar.range_bias = report.errors[tws::kRangeBias];
    radar.range_gain = report.errors[tws::kRangeGain];
    radar.azimuth_bias = report.errors[tws::kAzimuthBias];
    radar.azimuth_sine = report.errors[tws::kAzimuthSine];
    radar.azimuth_cosine = report.errors[tws::kAzimuthCosine];
    radar.clock_offset = report.errors[tws::kClockOffset];
    std::copy(report.sigmas.begin(), report.sigmas.end(), radar.sigmas.begin());
    std::copy(report.applied.begin(), report.applied.end(), radar.applied.begin());
    std::copy(report.known.begin(), report.known.end(), radar.known.begin());
    radar.pairings = static_cast<std::uint32_t>(report.pairings);
    radar.rejected = static_cast<std::uint32_t>(report.rejected);
  }
  return message;
}

}  // namespace adit_tracker
