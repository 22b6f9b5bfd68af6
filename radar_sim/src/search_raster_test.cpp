#include "search_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace radar_sim {
namespace {

ArrayParams array() {
  ArrayParams params;
  params.name = "esa";
  params.beamwidth_u = 0.04;
  params.beamwidth_v = 0.02;
  params.search_u_from = -0.06;
  params.search_u_to = 0.06;
  params.search_v_from = 0.0;
  params.search_v_to = 0.03;
  params.search_spacing = 0.75;
  return params;
}

// Spacings of 0.03 and 0.015: four columns and two rows.
TEST(SearchRaster, GoesRowByRowOverItsPartOfSineSpaceAndBeginsAnew) {
  SearchRaster raster(array());
  ASSERT_EQ(raster.beams().size(), 8u);
  const double u[] = {-0.045, -0.015, 0.015, 0.045};
  for (int i = 0; i < 17; ++i) {
    const BeamPoint& beam = raster.next();
    EXPECT_NEAR(beam.u, u[i % 4], 1e-12) << i;
    EXPECT_NEAR(beam.v, (i / 4) % 2 == 0 ? 0.0075 : 0.0225, 1e-12) << i;
  }
}

// A hole in the raster is a place where nothing is ever found.
TEST(SearchRaster, LeavesNoPointFurtherFromABeamThanTheDiagonalOfItsGrid) {
  const SearchRaster raster(array());
  for (double u = -0.06; u <= 0.06; u += 0.001) {
    for (double v = 0.0; v <= 0.03; v += 0.001) {
      double nearest = 1.0;
      for (const BeamPoint& beam : raster.beams()) nearest = std::min(nearest, beamwidthsApart(array(), beam, {u, v}));
      EXPECT_LE(nearest, 0.375 * std::sqrt(2.0) + 1e-9) << u << " " << v;
    }
  }
}

TEST(SearchRaster, LeavesOutWhatCannotBeSteered) {
  ArrayParams wide = array();
  wide.search_u_from = -1.0;
  wide.search_u_to = 1.0;
  const SearchRaster raster(wide);
  for (const BeamPoint& beam : raster.beams()) EXPECT_LE(std::hypot(beam.u, beam.v), std::sqrt(0.75) + 1e-12);
  wide.search_u_from = 0.95;
  EXPECT_THROW(SearchRaster{wide}, std::invalid_argument);
}

}  // namespace
}  // namespace radar_sim
