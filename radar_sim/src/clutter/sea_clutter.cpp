#include "clutter/sea_clutter.h"

#include <cmath>

#include <tws_core/units.h>

#include "clutter/cell_clutter.h"
#include "physics.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

double grazingAngle(const RadarParams& radar, double range) { return std::asin(sineOfGrazing(radar, range)); }

}  // namespace

double seaReflectivity(double wavelength, double sea_state, double grazing) {
  const double gigahertz = kSpeedOfLight / wavelength / 1e9;
  const double degrees = tws::degrees(grazing);
  const double decibels = -73.0 + 20.781 * std::log10(std::sin(grazing)) +
                          (27.5 + 7.351 * degrees) * std::log10(gigahertz) / (1.0 + 0.95 * degrees) +
                          25.65 * std::pow(1.0 + sea_state, 1.0 / (2.0 + 0.085 * degrees + 0.033 * sea_state)) +
                          0.0054 * degrees * degrees;
  return std::pow(10.0, decibels / 10.0);
}

double driftOfSea(double sea_state) {
  constexpr double kWind = 3.16, kExponent = 0.8, kShare = 0.2;  // wind [m/s] of sea state 1; scatterers' part of it
  return kShare * kWind * std::pow(sea_state, kExponent);
}

double upwindFactor(double wavelength, double grazing, double from_upwind) {
  return std::exp(0.2 * std::cos(from_upwind) * (1.0 - 2.8 * grazing) * std::pow(wavelength + 0.015, -0.4));
}

std::unique_ptr<Clutter> SeaClutter::seenBy(const ClutterView& view) const {
  const RadarParams radar = withoutMirror(view.params);
  CellModel model;
  model.profile = [radar, sea = *this](double range) {
    const double reflectivity = seaReflectivity(radar.wavelength, sea.sea_state, grazingAngle(radar, range));
    return meanSnr(radar, reflectivity * surfaceCell(radar, range), range, 0.0) / sea.suppression;
  };
  const Texture field(texture, view.seed, name);
  model.greatest_factor = upwindFactor(radar.wavelength, 0.0, 0.0) * field.greatest();
  model.factor = [radar, sea = *this, field](const Cell& cell) {
    if (!sea.area.contains(cell.place)) return 0.0;
    return upwindFactor(radar.wavelength, grazingAngle(radar, cell.range), cell.azimuth - sea.wind_from) *
           field.at(cell.place, cell.time);
  };
  const double drift = driftOfSea(sea_state);
  model.motion = Motion{{-drift * std::sin(wind_from), -drift * std::cos(wind_from), 0.0}, 0.5 * drift};
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readSeaClutter(ParameterReader& reader, const ReadingContext& context) {
  auto sea = std::make_unique<SeaClutter>();
  readCommon(reader, context, 40.0, *sea);
  sea->area = readArea(reader, context);
  reader.number("sea_state", sea->sea_state, 0.0, 6.0);
  scaledNumber(reader, "wind_from_deg", sea->wind_from, tws::kRadiansPerDegree, 0.0, 360.0);
  readTexture(reader, sea->texture);
  return sea;
}

}  // namespace radar_sim
