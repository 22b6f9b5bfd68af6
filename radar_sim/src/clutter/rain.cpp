#include "clutter/rain.h"

#include <cmath>

#include "clutter/cell_clutter.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

constexpr double kExponent = 1.6;  // of the rate, in Z
constexpr double kFaintest = 6.9;  // -ln of the part of the rate at which the rain ends: a thousandth
constexpr int kLayers = 10;
constexpr double kRainSpread = 2.0;  // of radial velocities in a cell, by turbulence and shear [m/s]

/// Clutter-to-noise ratio of one resolution cell full of rain of 1 mm/h, layer by layer from the sea to the top.
double cnrOfOneMillimetre(const RadarParams& radar, double range, double top) {
  const double thickness = top / kLayers;
  const double volume = surfaceCell(radar, range) * thickness;
  double sum = 0.0;
  for (int layer = 0; layer < kLayers; ++layer) {
    const double height = (layer + 0.5) * thickness;
    if (std::abs(height - radar.antenna_height) < range)
      sum += meanSnr(radar, rainReflectivity(kMillimetrePerHour, radar.wavelength) * volume, range, height);
  }
  return sum;
}

}  // namespace

double rainReflectivity(double rate, double wavelength) {
  const double z = 200e-18 * std::pow(rate / kMillimetrePerHour, kExponent);  // [m³]
  return std::pow(tws::kPi, 5) * 0.93 * z / std::pow(wavelength, 4);
}

std::unique_ptr<Clutter> Rain::seenBy(const ClutterView& view) const {
  CellModel model;
  model.profile = [radar = withoutMirror(view.params), rain = *this](double range) {
    return cnrOfOneMillimetre(radar, range, rain.top) / rain.suppression;
  };
  const Texture field(texture, view.seed, name);
  model.greatest_factor = std::pow(rate / kMillimetrePerHour, kExponent) * field.greatest();
  model.factor = [rain = *this, field](const Cell& cell) {
    const Eigen::Vector2d from_middle = cell.place - rain.centreAt(cell.time);
    const double fall = from_middle.squaredNorm() / (rain.radius * rain.radius);
    if (fall > kFaintest) return 0.0;
    return std::pow(rain.rate / kMillimetrePerHour * std::exp(-fall), kExponent) * field.at(from_middle, cell.time);
  };
  model.motion = Motion{{velocity.x(), velocity.y(), 0.0}, kRainSpread};
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readRain(ParameterReader& reader, const ReadingContext& context) {
  auto rain = std::make_unique<Rain>();
  readCommon(reader, context, 35.0, *rain);
  rain->centre = readPlace(reader, context);
  rain->velocity = readVelocity(reader);
  reader.number("radius_m", rain->radius, 100.0, 1e6);
  scaledNumber(reader, "rate_mm_h", rain->rate, kMillimetrePerHour, 0.1, 300.0);
  reader.number("top_m", rain->top, 100.0, 20000.0);
  readTexture(reader, rain->texture);
  return rain;
}

}  // namespace radar_sim
