#include "clutter/land_clutter.h"

#include <algorithm>
#include <cmath>

#include "clutter/cell_clutter.h"
#include "radar_equation.h"

namespace radar_sim {

std::unique_ptr<Clutter> LandClutter::seenBy(const ClutterView& view) const {
  CellModel model;
  model.profile = [radar = withoutMirror(view.params), land = *this](double range) {
    const double sine = std::min(radar.antenna_height / range, 1.0);
    const double height = std::min(land.height, range / 2.0);
    return meanSnr(radar, land.gamma * sine * surfaceCell(radar, range), range, height) / land.suppression;
  };
  const Texture field(texture, view.seed, name);
  model.greatest_factor = field.greatest();
  model.steady_share = steady_share;
  model.factor = [border = area, field](const Cell& cell) {
    return border.contains(cell.place) ? field.at(cell.place, cell.time) : 0.0;
  };
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
