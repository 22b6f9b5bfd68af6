#include "radar_presets.h"

#include <cmath>
#include <stdexcept>

namespace radar_sim {
namespace {

double fromDecibels(double decibels) { return std::pow(10.0, decibels / 10.0); }

/// Long-range air search in L band: a fan beam, 2-D.
RadarParams sps12() {
  RadarParams radar;
  radar.rotation_period = 6.0;
  radar.antenna_height = 25.0;
  radar.azimuth_beamwidth = tws::radians(3.0);
  radar.beams = {{tws::radians(4.0), tws::radians(9.0), tws::radians(45.0)}};
  radar.peak_power = 500e3;
  radar.antenna_gain = fromDecibels(31.0);
  radar.wavelength = 0.23;
  radar.pulse_width = 2e-6;
  radar.noise_figure = fromDecibels(5.0);
  radar.losses = fromDecibels(5.0);
  radar.pulses = 15.0;
  radar.integration_efficiency = 0.6;
  radar.range_sigma = 100.0;
  radar.azimuth_sigma = tws::radians(0.3);
  return radar;
}

/// Height finder in S band: pencil beams, of which search uses two.
RadarParams sps39() {
  RadarParams radar;
  radar.rotation_period = 8.0;
  radar.antenna_height = 35.0;
  radar.azimuth_beamwidth = tws::radians(1.5);
  radar.beams = {{tws::radians(1.5), tws::radians(3.0), 0.0},
                 {tws::radians(5.0), tws::radians(5.0), tws::radians(20.0)}};
  radar.peak_power = 1e6;
  radar.antenna_gain = fromDecibels(37.0);
  radar.wavelength = 0.10;
  radar.pulse_width = 2e-6;
  radar.noise_figure = fromDecibels(5.0);
  radar.losses = fromDecibels(6.0);
  radar.pulses = 5.0;
  radar.integration_efficiency = 0.8;
  radar.range_sigma = 75.0;
  radar.azimuth_sigma = tws::radians(0.2);
  radar.elevation_search.emplace();
  return radar;
}

/// Surface search in C band: low and near.
RadarParams sps10() {
  RadarParams radar;
  radar.rotation_period = 3.75;
  radar.antenna_height = 30.0;
  radar.azimuth_beamwidth = tws::radians(1.9);
  radar.beams = {{0.0, tws::radians(16.0), 0.0}};
  radar.peak_power = 280e3;
  radar.antenna_gain = fromDecibels(30.0);
  radar.wavelength = 0.053;
  radar.pulse_width = 1.3e-6;
  radar.noise_figure = fromDecibels(8.0);
  radar.losses = fromDecibels(6.0);
  radar.pulses = 13.0;
  radar.integration_efficiency = 0.6;
  radar.max_range = 75e3;
  radar.range_sigma = 60.0;
  radar.azimuth_sigma = tws::radians(0.25);
  return radar;
}

}  // namespace

std::vector<std::string> radarTypes() { return {"SPS-12", "SPS-39", "SPS-10", "generic"}; }

RadarParams radarPreset(const std::string& type) {
  if (type == "SPS-12") return sps12();
  if (type == "SPS-39") return sps39();
  if (type == "SPS-10") return sps10();
  if (type == "generic") return RadarParams{};
  throw std::invalid_argument("no radar type '" + type + "'");
}

}  // namespace radar_sim
