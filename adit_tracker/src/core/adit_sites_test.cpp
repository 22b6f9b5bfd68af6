#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

// Radars at different sites, joined to one picture. If these fail, an aircraft seen by both is two tracks, or one that
// only the second site sees is none.

const tws::SiteFrame kIsland{38e3, 12e3, 0.008};

/// What two radars report of targets that fly straight over the plane of the first one, at a height above a round
/// earth.
class SecondSite : public testing::Test {
 protected:
  AditParams params_ = paramsFor("default", {6.0, 8.0});
  TestRadar first_{6.0}, second_{8.0, 0.5};

  /// As TestRadar does, but from the radar's own place: straight flight stays straight there, to a metre.
  static TestTarget from(const tws::SiteFrame& site, const TestTarget& target, double height) {
    const tws::EarthSite radar(tws::EarthPlane{}, site);
    const tws::SiteView a = radar.view(target.x, target.y, height);
    const tws::SiteView b = radar.view(target.x + 100.0 * target.vx, target.y + 100.0 * target.vy, height);
    return {a.east, a.north, 0.01 * (b.east - a.east), 0.01 * (b.north - a.north), target.from, target.to};
  }
  /// From horizontal range to slant range.
  static void lift(const tws::SiteFrame& site, double height, std::vector<tws::RadarSector>& sectors) {
    const tws::EarthPlane plane;
    const tws::EarthSite radar(plane, site);
    for (auto& sector : sectors)
      for (auto& plot : sector.plots) {
        const double azimuth = site.onPlane(plot.azimuth);
        plot.range =
            radar.view(site.x + plot.range * std::sin(azimuth), site.y + plot.range * std::cos(azimuth), height).range;
      }
  }

  /// `reach`: how far each radar sees [m].
  RadarSectors flights(const std::vector<TestTarget>& targets, double height, double reach = 150e3) const {
    RadarSectors radars = {first_.sectors(0.0, 200.0), second_.sectors(0.0, 200.0)};
    for (const TestTarget& target : targets) {
      first_.see(from({}, target, height), radars[0]);
      second_.see(from(kIsland, target, height), radars[1]);
    }
    lift({}, height, radars[0]);
    lift(kIsland, height, radars[1]);
    for (auto& sectors : radars) {
      for (auto& sector : sectors) {
        sector.plots.erase(std::remove_if(sector.plots.begin(), sector.plots.end(),
                                          [&](const tws::Plot& plot) { return plot.range > reach; }),
                           sector.plots.end());
      }
    }
    return radars;
  }

  const std::vector<TestTarget> targets_ = {{-20e3, 40e3, 200.0, 30.0},
                                            {60e3, -30e3, -150.0, 180.0},
                                            {30e3, 60e3, 40.0, -220.0},
                                            {70e3, 20e3, -210.0, -20.0}};
};

TEST_F(SecondSite, OneTrackAnAircraftAtAnyHeight) {
  for (const double height : {0.0, 4e3, 9e3}) {
    Listener listener(params_);
    listener.adit.place(1, kIsland);
    feedInOrder(listener.adit, flights(targets_, height));
    EXPECT_EQ(listener.confirmed().size(), targets_.size()) << height;
    EXPECT_EQ(listener.adit.tracks().size(), targets_.size()) << height;
    for (const auto slot : listener.adit.tracks().living()) {
      const Track& track = listener.adit.tracks().at(slot);
      EXPECT_EQ(track.detected_by, 3) << height;
      const Kinematics k = listener.adit.tracks().extrapolate(slot, 199.0).kinematics;
      double nearest = 1e9;
      for (const auto& t : targets_)
        nearest = std::min(nearest, std::hypot(k.x - t.x - t.vx * 199.0, k.y - t.y - t.vy * 199.0));
      EXPECT_LT(nearest, 200.0) << height;  // twice a radar's error of range
      // Slant range hardly changes with the height of what is low: 1.7 km are 40 m at 40 km.
      EXPECT_NEAR(static_cast<double>(track.height_guess.height), height, height > 0.0 ? 1500.0 : 2000.0) << height;
    }
  }
}

TEST_F(SecondSite, TheSecondRadarAloneHoldsWhatTheFirstDoesNotSee) {
  Listener listener(params_);
  listener.adit.place(1, kIsland);
  const std::vector<TestTarget> far = {{90e3, 30e3, -100.0, 100.0}, {70e3, 50e3, 150.0, -60.0}};
  feedInOrder(listener.adit, flights(far, 0.0, 75e3));
  EXPECT_EQ(listener.confirmed().size(), far.size());
  for (const RecordedUpdate& update : listener.of(TrackEvent::kUpdated)) EXPECT_EQ(update.radar, 1U);
}

TEST_F(SecondSite, TheResultDoesNotDependOnHowTheRadarsInterleave) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = flights(targets_, 5e3);
  for (auto& sectors : radars) disturb(sectors, 100.0, 0.005, 0.9, 0.3, generator);
  std::string first;
  for (int i = 0; i < 4; ++i) {
    Listener listener(params_);
    listener.adit.place(1, kIsland);
    feed(listener.adit, radars, i == 0 ? 0.0 : 0.45, generator);
    if (i == 0) first = listener.bytes();
    EXPECT_TRUE(listener.bytes() == first) << i;
  }
}

TEST_F(SecondSite, ARadarBesideTheFirstOneIsAtItsSite) {
  Listener beside(params_), same(params_);
  beside.adit.place(1, {60.0, -40.0, 0.0});
  RadarSectors radars = {first_.sectors(0.0, 100.0), second_.sectors(0.0, 100.0)};
  for (const TestTarget& target : targets_) {
    first_.see(target, radars[0]);
    second_.see(target, radars[1]);
  }
  feedInOrder(beside.adit, radars);
  feedInOrder(same.adit, radars);
  EXPECT_TRUE(beside.bytes() == same.bytes());
}

TEST_F(SecondSite, AnOperatorsPointIsWhereHeSaysWhicheverRadarIsAtWork) {
  Listener listener(params_);
  listener.adit.place(1, kIsland);
  feedInOrder(listener.adit, flights(targets_, 5e3));
  const auto slot = listener.adit.manual().start(50e3, 1.0, 500.0);
  ASSERT_TRUE(slot);
  const Kinematics& k = listener.adit.tracks().at(*slot).smoothed;
  EXPECT_NEAR(k.x, 50e3 * std::sin(1.0), 1.0);
  EXPECT_NEAR(k.y, 50e3 * std::cos(1.0), 1.0);
}

TEST_F(SecondSite, TheReportsFilterCannotJoinSites) {
  Adit adit(paramsFor("nrl7952", {6.0, 8.0}), {});
  EXPECT_NO_THROW(adit.place(1, {60.0, 0.0, 0.0}));
  EXPECT_THROW(adit.place(1, kIsland), std::invalid_argument);
}

}  // namespace
}  // namespace adit_tracker
