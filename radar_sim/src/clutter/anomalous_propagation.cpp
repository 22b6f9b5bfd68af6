#include "clutter/anomalous_propagation.h"

#include <cmath>

#include "clutter/cell_clutter.h"
#include "propagation.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

/// A height that the horizontal ray meets there: for the beam, what the duct leads on arrives like that.
double heightOnTheHorizontal(const RadarParams& radar, double range) {
  return radar.antenna_height + range * range / (2.0 * kEffectiveEarthRadius);
}

/// Beyond the horizon the power spreads over the duct's width only, as 1/R there and back, not as 1/R².
double ductGain(const RadarParams& radar, double range) {
  return std::pow(range / horizonDistance(radar.antenna_height), 2);
}

}  // namespace

std::unique_ptr<Clutter> AnomalousPropagation::seenBy(const ClutterView& view) const {
  CellModel model = fieldWithin(area, Texture(texture, view.seed, name), steady_share);
  model.profile = [radar = withoutMirror(view.params), duct = *this](double range) {
    if (range <= horizonDistance(radar.antenna_height)) return 0.0;
    const double rcs = duct.reflectivity * surfaceCell(radar, range) * ductGain(radar, range);
    return meanSnr(radar, rcs, range, heightOnTheHorizontal(radar, range)) / duct.suppression;
  };
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readAnomalousPropagation(ParameterReader& reader, const ReadingContext& context) {
  auto duct = std::make_unique<AnomalousPropagation>();
  readCommon(reader, context, 55.0, *duct);
  duct->area = readArea(reader, context);
  readDecibels(reader, "sigma0_db", duct->reflectivity, -80.0, 10.0);
  reader.number("steady_share", duct->steady_share, 0.0, 1.0);
  readTexture(reader, duct->texture);
  return duct;
}

}  // namespace radar_sim
