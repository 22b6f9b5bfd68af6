#include "clutter/jammer.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

#include "clutter/cell_clutter.h"
#include "physics.h"
#include "propagation.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

double azimuthGain(double off_beam, double beamwidth, double side_lobes) {
  const double main = std::exp(-4.0 * std::log(2.0) * std::pow(off_beam / beamwidth, 2));
  return std::max(main, side_lobes);
}

}  // namespace

bool Jammer::isOnAt(double time) const { return off <= 0.0 || std::fmod(time - from, on + off) < on; }

double jammerToNoise(const RadarParams& radar, const Jammer& jammer, double slant_range) {
  if (isBeyondHorizon(radar.antenna_height, jammer.height, slant_range)) return 0.0;
  const double elevation = std::asin(sineOfElevation(radar.antenna_height, jammer.height, slant_range));
  double gain = 0.0;
  for (const ElevationBeam& beam : radar.beams) gain = std::max(gain, elevationGain(beam, elevation));
  const double density = jammer.power / jammer.bandwidth * gain * radar.antenna_gain *
                         std::pow(radar.wavelength / (4.0 * tws::kPi * slant_range), 2);
  return density / (kNoiseDensity * radar.noise_figure);
}

std::unique_ptr<Clutter> Jammer::seenBy(const ClutterView& view) const {
  CellModel model;
  model.profile = [](double) { return 1.0; };  // what it does is the same at all ranges
  model.greatest_factor = std::numeric_limits<double>::infinity();
  model.factor = [view, jammer = *this](const Cell& cell) {
    if (!jammer.isOnAt(cell.time)) return 0.0;
    const Eigen::Vector2d at = jammer.placeAt(cell.time);
    const tws::Polar polar = tws::polarFromEnu(view.map_to_site * Eigen::Vector3d(at.x(), at.y(), jammer.height));
    const double off_beam = tws::angularDifference(cell.azimuth, polar.azimuth);
    return jammerToNoise(view.params, jammer, polar.range) *
           azimuthGain(off_beam, view.params.azimuth_beamwidth, jammer.side_lobes) / jammer.suppression;
  };
  model.motion.reset();
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readJammer(ParameterReader& reader, const ReadingContext& context) {
  auto jammer = std::make_unique<Jammer>();
  readCommon(reader, context, 35.0, *jammer);
  jammer->place = readPlace(reader, context);
  jammer->velocity = readVelocity(reader);
  reader.number("height_m", jammer->height, 0.0, 100e3);
  reader.number("power_w", jammer->power, 1e-3, 1e9);
  reader.number("bandwidth_hz", jammer->bandwidth, 1e3, 1e11);
  readDecibels(reader, "side_lobes_db", jammer->side_lobes, -90.0, 0.0);
  reader.number("on_s", jammer->on, 0.1, kLongest);
  reader.number("off_s", jammer->off, 0.0, kLongest);
  return jammer;
}

}  // namespace radar_sim
