#include "clutter/second_time_around.h"

#include <tws_core/angles.h>
#include <tws_core/units.h>

#include "clutter/cell_clutter.h"
#include "radar_equation.h"

namespace radar_sim {

std::unique_ptr<Clutter> SecondTimeAround::seenBy(const ClutterView& view) const {
  CellModel model;
  model.profile = [radar = withoutMirror(view.params), ring = *this](double apparent) {
    const double true_range = apparent + ring.unambiguous_range;
    if (true_range < ring.range.least || true_range > ring.range.greatest) return 0.0;
    return meanSnr(radar, ring.reflectivity * surfaceCell(radar, true_range), true_range, ring.height) /
           ring.suppression;
  };
  const Texture field(texture, view.seed, name);
  model.greatest_factor = field.greatest();
  model.steady_share = steady_share;
  model.factor = [ring = *this, field](const Cell& cell) {
    if (tws::wrapTwoPi(cell.azimuth - ring.azimuth.least) > ring.azimuth.greatest - ring.azimuth.least) return 0.0;
    return field.at(cell.place, cell.time);
  };
  return std::make_unique<CellClutter>(view, name, std::move(model));
}

std::unique_ptr<ClutterSpec> readSecondTimeAround(ParameterReader& reader, const ReadingContext& context) {
  auto ring = std::make_unique<SecondTimeAround>();
  readCommon(reader, context, 40.0, *ring);
  reader.number("unambiguous_range_m", ring->unambiguous_range, 1000.0, kFarthest);
  readInterval(reader, "true_range_m", ring->range, 1.0, 1000.0, kFarthest);
  readInterval(reader, "azimuth_deg", ring->azimuth, tws::kRadiansPerDegree, 0.0, 720.0);
  readDecibels(reader, "sigma0_db", ring->reflectivity, -80.0, 10.0);
  reader.number("height_m", ring->height, 0.0, 9000.0);
  reader.number("steady_share", ring->steady_share, 0.0, 1.0);
  readTexture(reader, ring->texture);
  if (ring->range.greatest <= ring->unambiguous_range)
    reader.fail("true_range_m", "ends within unambiguous_range_m: there is nothing to fold");
  return ring;
}

}  // namespace radar_sim
