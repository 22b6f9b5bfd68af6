#include "clutter/cell_clutter.h"

#include <map>
#include <set>

#include "clutter/clutter_test_helpers.h"
#include "detection_probability.h"

namespace radar_sim {
namespace {

/// The same mean clutter-to-noise ratio from 20 to 30 km all round.
struct EvenRing : ClutterSpec {
  EvenRing(double cnr, double steady) : cnr(cnr), steady(steady) { name = "ring"; }
  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override {
    CellModel model;
    model.profile = [value = cnr](double range) { return range >= 20e3 && range < 30e3 ? value : 0.0; };
    model.factor = [](const Cell&) { return 1.0; };
    model.steady_share = steady;
    return std::make_unique<CellClutter>(view, name, std::move(model));
  }
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return {}; }
  double cnr, steady;
};

double cellsOfTheRing(const RadarParams& radar) {
  return spokes(radar.azimuth_beamwidth) * std::round(10e3 / rangeCell(radar));
}

// If it fails, a scenario's rain makes more or fewer plots than the radar equation says.
TEST(CellClutter, CellsCrossTheThresholdAtTheRateOfTheirMeanPower) {
  const ClutterView view = viewOf("sps12");
  for (const double cnr : {1.0, 4.0, 15.0}) {
    const double expected = 20 * cellsOfTheRing(view.params) * std::pow(1e-6, 1.0 / (1.0 + cnr));
    const double crossed = static_cast<double>(ClutterScans(EvenRing(cnr, 0.0), view).next(20).size());
    EXPECT_NEAR(crossed, expected, poissonBound(expected)) << "clutter-to-noise ratio " << cnr;
  }
}

TEST(CellClutter, TellsTheExpectedNumberOfCrossings) {
  const ClutterView view = viewOf("sps12");
  const EvenRing ring(8.0, 0.6);
  ClutterView one = view;
  SpokeFeed feed(Antenna(6.0, 0.0, kTestStart), view.params.azimuth_beamwidth, kTestStart);
  const auto clutter = ring.seenBy(one);
  const Spoke spoke{0, 0, 0.0, view.params.azimuth_beamwidth, kTestStart, 0.03};
  const double expected =
      20 * spokes(view.params.azimuth_beamwidth) * static_cast<const CellClutter&>(*clutter).expectedCrossings(spoke);
  EXPECT_NEAR(static_cast<double>(ClutterScans(ring, view).next(20).size()), expected, poissonBound(expected));
}

/// How often a cell crosses that crossed on the scan before.
double repeated(const EvenRing& ring) {
  const ClutterView view = viewOf("sps12");
  ClutterScans scans(ring, view);
  std::set<std::pair<long, long>> before;
  double again = 0.0, all = 0.0;
  for (int scan = 0; scan < 20; ++scan) {
    std::set<std::pair<long, long>> now;
    for (const Echo& echo : scans.next()) now.insert(cellOf(echo, view.params));
    for (const auto& cell : before) again += static_cast<double>(now.count(cell));
    all += static_cast<double>(before.size());
    before = now;
  }
  return again / all;
}

TEST(CellClutter, WhereThePowerIsEvenScansAreIndependent) {
  const double chance = std::pow(1e-6, 1.0 / 5.0);
  EXPECT_NEAR(repeated(EvenRing(4.0, 0.0)), chance, 4.5 * std::sqrt(chance / 4000.0));
}

// Plots of rocks come from the same place on every scan: a tracker's clutter map lives on that.
TEST(CellClutter, TheSteadyShareStaysWhereItIs) {
  const ClutterView view = viewOf("sps12");
  const auto spread = [&](double steady) {
    std::map<std::pair<long, long>, std::vector<double>> ranges;
    for (const Echo& echo : ClutterScans(EvenRing(100.0, steady), view).next(20))
      ranges[cellOf(echo, view.params)].push_back(echo.range);
    double sum = 0.0;
    for (const auto& [cell, all] : ranges)
      sum += *std::max_element(all.begin(), all.end()) - *std::min_element(all.begin(), all.end());
    return sum / static_cast<double>(ranges.size()) / rangeCell(view.params);
  };
  EXPECT_LT(spread(1.0), 1e-9);
  EXPECT_NEAR(spread(0.5), 0.5 * spread(0.0), 0.05);
}

TEST(CellClutter, FarBelowTheNoiseThereIsNone) {
  EXPECT_TRUE(ClutterScans(EvenRing(0.09, 0.0), viewOf("sps12")).next(100).empty());
}

TEST(CellClutter, ARadarsOwnSuppressionWeakensIt) {
  ClutterView view = viewOf("sps12");
  const auto plain = ClutterScans(EvenRing(3.0, 0.0), view).next(5).size();
  view.params.clutter_suppression = 10.0;
  const auto weakened = ClutterScans(EvenRing(30.0, 0.0), view).next(5).size();
  EXPECT_EQ(plain, weakened);
}

// If it fails, plots are lost or doubled where one sector ends and the next begins.
TEST(SpokeFeed, PassesEachSpokeOnceHoweverItIsAsked) {
  const ClutterView view = viewOf("sps12");
  const EvenRing ring(10.0, 0.0);
  const auto whole = ClutterScans(ring, view).next();
  SpokeFeed feed(Antenna(6.0, 0.0, kTestStart), view.params.azimuth_beamwidth, kTestStart);
  feed.add(std::make_shared<EvenRing>(ring), ring.seenBy(view));
  std::vector<Echo> pieces;
  for (double time = kTestStart; time < kTestStart + 6.0; time += 0.017) feed.raise(time, pieces);
  ASSERT_GE(pieces.size() + 100, whole.size());
  for (std::size_t i = 0; i < std::min(pieces.size(), whole.size()); ++i) EXPECT_EQ(pieces[i].time, whole[i].time);
}

TEST(SpokeFeed, RaisesNothingBeforeTheStartNorOutsideItsLife) {
  const ClutterView view = viewOf("sps12");
  auto ring = std::make_shared<EvenRing>(10.0, 0.0);
  ring->from = kTestStart + 1.0;
  ring->to = kTestStart + 2.0;
  SpokeFeed feed(Antenna(6.0, 1.0, kTestStart), view.params.azimuth_beamwidth, kTestStart);
  feed.add(ring, ring->seenBy(view));
  std::vector<Echo> echoes;
  feed.raise(kTestStart + 6.0, echoes);
  ASSERT_FALSE(echoes.empty());
  EXPECT_GE(echoes.front().time, ring->from);
  EXPECT_LT(echoes.back().time, ring->to + 0.04);
}

}  // namespace
}  // namespace radar_sim
