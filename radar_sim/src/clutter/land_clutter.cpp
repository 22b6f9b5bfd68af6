#include "clutter/land_clutter.h"

#include <algorithm>

#include "clutter/cell_clutter.h"
#include "radar_equation.h"

namespace radar_sim {
namespace {

constexpr double kLandSpread = 0.3;  // of radial velocities, by trees in the wind [m/s]

}  // namespace

std::unique_ptr<Clutter> LandClutter::seenBy(const ClutterView& view) const {
  CellModel model = fieldWithin(area, Texture(texture, view.seed, name), steady_share);
  model.profile = [radar = withoutMirror(view.params), land = *this](double range) {
    const double height = std::min(land.height, range / 2.0);
    return meanSnr(radar, land.gamma * sineOfGrazing(radar, range) * surfaceCell(radar, range), range, height) /
           land.suppression;
  };
  model.motion = Motion{{0.0, 0.0, 0.0}, kLandSpread};
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readLandClutter(ParameterReader& reader, const ReadingContext& context) {
  auto land = std::make_unique<LandClutter>();
  readCommon(reader, context, 65.0, *land);
  land->area = readArea(reader, context);
  readDecibels(reader, "gamma_db", land->gamma, -40.0, 5.0);
  reader.number("height_m", land->height, 0.0, 9000.0);
  reader.number("steady_share", land->steady_share, 0.0, 1.0);
  readTexture(reader, land->texture);
  return land;
}

}  // namespace radar_sim
