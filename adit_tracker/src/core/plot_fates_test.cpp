#include "core/plot_fates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// A tracker with all that became of its plots.
struct Asked {
  explicit Asked(const AditParams& params) : listener(params) {
    listener.adit.tellPlots([this](const SectorFates& sector) {
      for (const PlotFate& fate : sector.plots) fates.push_back(fate);
    });
  }

  void fly(const RadarSectors& radars) {
    feedInOrder(listener.adit, radars);
    listener.adit.finish();
  }

  std::size_t count(PlotFate::Kind kind) const {
    return static_cast<std::size_t>(
        std::count_if(fates.begin(), fates.end(), [&](const PlotFate& fate) { return fate.kind == kind; }));
  }

  Listener listener;
  std::vector<PlotFate> fates;
};

class PlotFatesOfBothSets : public BothSets {
 protected:
  /// Two aircraft 2 km apart, something that stands, false plots.
  RadarSectors busySky() const {
    auto generator = tws::seededGenerator();
    RadarSectors radars =
        twoRadars(300.0, {{60e3, 20e3, -150.0, 120.0}, {62e3, 20e3, -150.0, 120.0}, {30e3, -40e3, 0.0, 0.0}});
    for (auto& sectors : radars) disturb(sectors, 50.0, 0.003, 0.9, 1.0, generator);
    return radars;
  }
};

INSTANTIATE_TEST_SUITE_P(Sets, PlotFatesOfBothSets, testing::Values("default", "nrl7952"),
                         [](const auto& info) { return info.param; });

// If this fails, some plots are not accounted for: whoever looks for a lost aircraft's plot does not find it, or twice.
TEST_P(PlotFatesOfBothSets, EachPlotHasOneFateAndAskingChangesNone) {
  const RadarSectors radars = busySky();
  Listener silent(params());
  feedInOrder(silent.adit, radars);
  silent.adit.finish();
  Asked asked(params());
  asked.fly(radars);
  EXPECT_EQ(asked.listener.bytes(), silent.bytes());
  EXPECT_EQ(asked.fates.size(), plotsIn(radars));
  std::set<std::tuple<double, double, double>> places;
  for (const PlotFate& fate : asked.fates) places.insert({fate.plot.time, fate.plot.range, fate.plot.azimuth});
  EXPECT_EQ(places.size(), plotsIn(radars));
  const std::size_t absorbed = asked.listener.adit.clutter().absorbed();
  EXPECT_EQ(asked.count(PlotFate::kClutter), absorbed);
  EXPECT_EQ(asked.count(PlotFate::kStarted),
            asked.listener.of(TrackEvent::kStarted).size() - asked.listener.adit.counts().to_track);
}

// A minute's sectors come at once and are passed over; then all goes on. If this fails, plots that nobody looked at are
// told as clutter, twice or not at all.
TEST_P(PlotFatesOfBothSets, SkippedPlotsAreToldAsSuch) {
  RadarSectors radars = busySky();
  Asked asked(params());
  Adit& adit = asked.listener.adit;
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> order;
  for (std::size_t r = 0; r < 2; ++r) {
    for (std::size_t i = 0; i < radars[r].size(); ++i) order.push_back({radars[r][i].leave_time, {r, i}});
  }
  std::sort(order.begin(), order.end());
  for (const auto& [time, place] : order) {
    adit.add(place.first, radars[place.first][place.second]);
    if (time > 120.0 && time < 180.0) continue;
    if (adit.order().waiting() > 64) adit.skip();
    while (adit.step()) continue;
  }
  adit.finish();
  const std::size_t absorbed = adit.clutter().absorbed();
  EXPECT_EQ(asked.fates.size(), plotsIn(radars));
  EXPECT_NEAR(static_cast<double>(asked.count(PlotFate::kSkipped)), plotsIn(radars) / 5.0, plotsIn(radars) / 15.0);
  EXPECT_LE(asked.count(PlotFate::kClutter), absorbed);
  EXPECT_GT(asked.count(PlotFate::kClutter) + 5, absorbed) << "some may have been skipped afterwards";
}

// If this fails, the reason that is given for a plot names another track than the one that took it.
TEST_P(PlotFatesOfBothSets, APlotThatUpdatedATrackNamesItAndItsClaim) {
  Asked asked(params());
  asked.fly(busySky());
  std::map<std::pair<double, std::uint32_t>, int> updates;  // by time and track
  for (const RecordedUpdate& w : asked.listener.updates) ++updates[{w.kinematics.time, w.uid}];
  std::size_t found = 0;
  for (const PlotFate& fate : asked.fates) {
    if (fate.kind != PlotFate::kUpdated) continue;
    found += updates.count({fate.plot.time, fate.uid});
    const auto own = [&](const PlotClaim& claim) { return claim.uid == fate.uid && claim.took; };
    EXPECT_EQ(std::count_if(fate.claims.begin(), fate.claims.end(), own), 1);
  }
  // Tracks that share a plot, or were stitched since, aside.
  EXPECT_GT(static_cast<double>(found), 0.97 * static_cast<double>(asked.count(PlotFate::kUpdated)));
}

// If this fails, "how sure was it?" is answered wrongly for two aircraft side by side.
TEST_P(PlotFatesOfBothSets, ChancesOfTheClaimsMakeOneAtMost) {
  Asked asked(params());
  asked.fly(busySky());
  std::size_t disputed = 0;
  for (const PlotFate& fate : asked.fates) {
    double sum = 0.0;
    for (const PlotClaim& claim : fate.claims) {
      EXPECT_GE(claim.chance, 0.0F);
      EXPECT_EQ(std::isfinite(claim.sigmas), GetParam() == "default");
      sum += static_cast<double>(claim.chance);
    }
    EXPECT_LT(sum, 1.0 + 1e-3);
    if (fate.claims.size() > 1 && fate.kind == PlotFate::kUpdated) ++disputed;
  }
  EXPECT_GT(disputed, 20U);
}

}  // namespace
}  // namespace adit_tracker
