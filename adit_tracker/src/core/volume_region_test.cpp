#include "core/volume_region.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace adit_tracker {
namespace {

VolumePlace at(double range, double azimuth_deg, double height = VolumePlace{}.height) {
  return {range, tws::radians(azimuth_deg), height};
}

/// 5 to 20 km, from 350 to 20 degrees, up to 1000 m.
VolumeRegion region() {
  VolumeRegion r;
  r.least_range = 5e3;
  r.greatest_range = 20e3;
  r.first_azimuth = tws::radians(350.0);
  r.azimuths = tws::radians(30.0);
  r.greatest_height = 1000.0;
  return r;
}

TEST(VolumeRegion, OneThatSaysNothingHoldsEverything) {
  EXPECT_TRUE(VolumeRegion{}.contains(at(1e6, 123.0, 50e3)));
  EXPECT_TRUE(VolumeRegion{}.contains(at(1e6, 123.0)));
}

// If this fails, a volume is elsewhere than its file says, or a sector across north is empty.
TEST(VolumeRegion, HoldsItsLimitsAndWhatIsBetweenAlsoAcrossNorth) {
  for (const double azimuth : {350.1, 359.0, 0.0, 19.9}) {
    EXPECT_TRUE(region().contains(at(5e3, azimuth, 1000.0))) << azimuth;
    EXPECT_TRUE(region().contains(at(20e3, azimuth, -50.0))) << azimuth;
    EXPECT_FALSE(region().contains(at(4999.0, azimuth, 0.0))) << azimuth;
    EXPECT_FALSE(region().contains(at(20001.0, azimuth, 0.0))) << azimuth;
    EXPECT_FALSE(region().contains(at(10e3, azimuth, 1001.0))) << azimuth;
  }
  for (const double azimuth : {349.9, 20.1, 180.0}) EXPECT_FALSE(region().contains(at(10e3, azimuth, 0.0))) << azimuth;
}

// If this fails, a radar that knows no heights has no volume with a limit of height, or only such ones.
TEST(VolumeRegion, SaysItselfWhetherItHoldsWhatHasNoKnownHeight) {
  VolumeRegion r = region();
  EXPECT_TRUE(r.contains(at(10e3, 0.0)));
  r.holds_unknown_height = false;
  EXPECT_FALSE(r.contains(at(10e3, 0.0)));
  EXPECT_TRUE(r.contains(at(10e3, 0.0, 500.0)));
}

// If this fails, a track along a border changes its parameters with each error of its plots.
TEST(VolumeRegion, WithAMarginHoldsWhatIsOffByLess) {
  EXPECT_TRUE(region().contains(at(20.29e3, 0.0, 0.0), 300.0));
  EXPECT_FALSE(region().contains(at(20.31e3, 0.0, 0.0), 300.0));
  EXPECT_TRUE(region().contains(at(10e3, 0.0, 1029.0), 300.0));
  EXPECT_FALSE(region().contains(at(10e3, 0.0, 1031.0), 300.0));
  const double aside = tws::degrees(300.0 / 10e3);
  for (const double off : {-1.0, 1.0}) {
    const double border = off < 0.0 ? 350.0 : 20.0;
    EXPECT_TRUE(region().contains(at(10e3, border + 0.9 * off * aside, 0.0), 300.0)) << off;
    EXPECT_FALSE(region().contains(at(10e3, border + 1.1 * off * aside, 0.0), 300.0)) << off;
  }
}

}  // namespace
}  // namespace adit_tracker
