#include "radar_equation.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

#include "physics.h"
#include "propagation.h"

namespace radar_sim {
namespace {

double square(double x) { return x * x; }

/// Everything of the radar equation but σ F⁴ / R⁴ [m²].
double systemFactor(const RadarParams& radar) {
  const double transmitted = radar.peak_power * radar.pulse_width * square(radar.antenna_gain * radar.wavelength);
  const double noise = kNoiseDensity * radar.noise_figure * radar.losses;
  return transmitted * radar.pulses * radar.integration_efficiency / (std::pow(4.0 * tws::kPi, 3) * noise);
}

/// F² of one beam, its pattern included.
double beamFactor(const RadarParams& radar, const ElevationBeam& beam, double sine) {
  const double elevation = std::asin(sine);
  const double direct = std::sqrt(elevationGain(beam, elevation));
  const double reflected = std::sqrt(elevationGain(beam, -elevation));
  return propagationFactor(radar.antenna_height, radar.wavelength, sine, direct, reflected, radar.sea_reflection);
}

}  // namespace

double rangeCell(const RadarParams& radar) { return kSpeedOfLight * radar.pulse_width / 2.0; }

double elevationGain(const ElevationBeam& beam, double elevation) {
  const double edge = beam.elevation + beam.beamwidth / 2.0;
  if (beam.cosecant_to > 0.0 && elevation > edge) {
    return elevation > beam.cosecant_to ? 0.0 : 0.5 * square(std::sin(edge) / std::sin(elevation));
  }
  return std::exp(-4.0 * std::log(2.0) * square((elevation - beam.elevation) / beam.beamwidth));
}

double meanSnr(const RadarParams& radar, double rcs, double slant_range, double target_height) {
  if (isBeyondHorizon(radar.antenna_height, target_height, slant_range)) return 0.0;
  const double sine = sineOfElevation(radar.antenna_height, target_height, slant_range);
  double best = 0.0;
  for (const ElevationBeam& beam : radar.beams) best = std::max(best, beamFactor(radar, beam, sine));
  return systemFactor(radar) * rcs * square(best) / square(square(slant_range));
}

double noiseSigma(const RadarParams& radar, double floor, double cell, double snr) {
  return radar.snr_dependent_noise ? std::hypot(floor, cell / (1.6 * std::sqrt(2.0 * snr))) : floor;
}

}  // namespace radar_sim
