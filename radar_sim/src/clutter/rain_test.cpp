#include "clutter/rain.h"

#include <algorithm>
#include <set>

#include "clutter/clutter_test_helpers.h"

namespace radar_sim {
namespace {

Rain shower() {
  Rain rain;
  rain.name = "shower";
  rain.from = kTestStart;
  rain.centre = {20e3, 10e3};
  rain.velocity = {12.0, 5.0};
  rain.radius = 6000.0;
  rain.rate = 20.0 * kMillimetrePerHour;
  rain.suppression = 30.0;
  rain.texture.spread_db = 0.0;
  return rain;
}

Eigen::Vector2d middleOf(const std::vector<Echo>& echoes) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (const Echo& echo : echoes) sum += placeOf(echo);
  return sum / static_cast<double>(echoes.size());
}

// Skolnik gives η = 5.7e-14 r^1.6 / λ⁴ for Z = 200 r^1.6 (r in mm/h, λ in m).
TEST(Rain, ReflectsAsTheTextbookSays) {
  EXPECT_NEAR(rainReflectivity(10.0 * kMillimetrePerHour, 0.1) / (5.7e-14 * std::pow(10.0, 1.6) / 1e-4), 1.0, 0.01);
}

// If it fails, a tracker that learns where it rains is tested on rain that stands still.
TEST(Rain, DriftsWithItsVelocity) {
  const ClutterView view = viewOf("sps12");
  const Eigen::Vector2d first = middleOf(ClutterScans(shower(), view).next(10));
  const Eigen::Vector2d later = middleOf(ClutterScans(shower(), view, kTestStart + 360.0).next(10));
  EXPECT_NEAR((later - first).x(), 12.0 * 360.0, 700.0);
  EXPECT_NEAR((later - first).y(), 5.0 * 360.0, 700.0);
}

TEST(Rain, StaysWithinItsCellAndItsOutlineFollows) {
  const Rain rain = shower();
  const auto echoes = ClutterScans(rain, viewOf("sps12")).next(10);
  ASSERT_GT(echoes.size(), 100u);
  for (const Echo& echo : echoes) EXPECT_LT((placeOf(echo) - rain.centre).norm(), 2.7 * rain.radius + 2000.0);
  for (const Eigen::Vector2d& point : rain.outlineAt(kTestStart + 100.0))
    EXPECT_NEAR((point - rain.centre - Eigen::Vector2d(1200.0, 500.0)).norm(), rain.radius, 1e-6);
}

// If it fails, a radar on a mountain sees no rain near by: what lies farther below than the range is no elevation.
TEST(Rain, IsSeenNearByFromAnAntennaAmidIt) {
  Rain rain = shower();
  rain.centre = {1000.0, 0.0};
  rain.velocity = {0.0, 0.0};
  ClutterView view = viewOf("sps12");
  view.params.antenna_height = 3000.0;
  const auto echoes = ClutterScans(rain, view).next(3);
  EXPECT_TRUE(std::any_of(echoes.begin(), echoes.end(), [](const Echo& echo) { return echo.range < 2000.0; }));
}

TEST(Rain, HeavierRainAndAShorterWaveGiveMorePlots) {
  const auto count = [](double rate, double wavelength) {
    Rain rain = shower();
    rain.rate = rate * kMillimetrePerHour;
    ClutterView view = viewOf("sps12");
    view.params.wavelength = wavelength;
    return ClutterScans(rain, view).next(10).size();
  };
  EXPECT_GT(count(20.0, 0.23), 1.3 * count(10.0, 0.23));
  EXPECT_GT(count(10.0, 0.1), 2 * count(10.0, 0.23));
}

// Speckle is new on every scan, but where it rains hard it rains hard on the next scan, too.
TEST(Rain, ItsTexturePersistsFromScanToScanForItsTime) {
  const auto repeated = [](double spread_db) {
    Rain rain = shower();
    rain.velocity = {0.0, 0.0};
    rain.texture = {spread_db, 2000.0, 300.0};
    rain.suppression = 300.0;
    const ClutterView view = viewOf("sps12");
    double again = 0.0, all = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      ClutterScans scans(rain, viewOf("sps12", seed));
      std::set<std::pair<long, long>> first, second;
      for (const Echo& echo : scans.next()) first.insert(cellOf(echo, view.params));
      for (const Echo& echo : scans.next()) second.insert(cellOf(echo, view.params));
      for (const auto& cell : first) again += static_cast<double>(second.count(cell));
      all += static_cast<double>(first.size());
    }
    return again / all;
  };
  EXPECT_GT(repeated(10.0), 1.5 * repeated(0.0));
}

}  // namespace
}  // namespace radar_sim
