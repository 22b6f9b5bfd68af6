// Radars that measure range rates (Doppler): what the whole tracker makes of them.
#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"
#include "core/passage.h"
#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kSigma = 2.0;  // [m/s]

AditParams withRates(AditParams params) {
  for (RadarParams& radar : params.radars) radar.range_rate_sigma = kSigma;
  return params;
}

/// Planes that a TestRadar sees, as it would see them from a place; their plots have errors and range rates.
class RangeRateFlights : public testing::Test {
 protected:
  static double rateOf(const TestTarget& target, double t) {
    const double x = target.x + target.vx * t, y = target.y + target.vy * t;
    return (x * target.vx + y * target.vy) / std::hypot(x, y);
  }

  /// 200 s of one radar.
  RadarSectors flights(const std::vector<TestTarget>& targets) {
    std::normal_distribution<double> normal;
    RadarSectors radars = {radar_.sectors(0.0, 200.0)};
    for (const TestTarget& target : targets) {
      std::vector<tws::RadarSector> own = radar_.sectors(0.0, 200.0);
      radar_.see(target, own);
      for (std::size_t i = 0; i < own.size(); ++i) {
        for (tws::Plot plot : own[i].plots) {
          plot.range += 60.0 * normal(generator_);
          plot.azimuth = tws::wrapTwoPi(plot.azimuth + 0.003 * normal(generator_));
          plot.range_rate = rateOf(target, plot.time) + kSigma * normal(generator_);
          radars[0][i].plots.push_back(plot);
        }
      }
    }
    for (tws::RadarSector& sector : radars[0]) {
      std::sort(sector.plots.begin(), sector.plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    }
    return radars;
  }

  /// Of the radial velocity of new tracks, second to eighth plot, over ten flights of one target: root mean square
  /// error without and with range rates [m/s]. Later, nobody errs much in straight flight. `fold`: they are told modulo
  /// this [m/s]; 0: whole.
  std::pair<double, double> errors(const AditParams& with, double fold) {
    double squares[2] = {0.0, 0.0}, count[2] = {0.0, 0.0};
    for (int flight = 0; flight < 10; ++flight) {
      RadarSectors radars = flights({target_});
      for (auto& sector : radars[0])
        for (tws::Plot& plot : sector.plots)
          if (fold > 0.0) plot.range_rate = std::remainder(plot.range_rate, fold);
      for (const int run : {0, 1}) {
        Listener listener(run == 0 ? params_ : with);
        feedInOrder(listener.adit, radars);
        EXPECT_EQ(listener.confirmed().size(), 1U);
        for (const RecordedUpdate& w : listener.updates) {
          if (w.event != TrackEvent::kUpdated || w.kinematics.time > 48.0) continue;
          squares[run] += std::pow(w.kinematics.range_rate - rateOf(target_, w.kinematics.time), 2);
          ++count[run];
        }
      }
    }
    return {std::sqrt(squares[0] / count[0]), std::sqrt(squares[1] / count[1])};
  }

  TestRadar radar_{6.0};
  std::mt19937_64 generator_ = tws::seededGenerator();
  AditParams params_ = paramsFor("default", {6.0});
  const TestTarget target_{-30e3, 50e3, 120.0, -160.0};
};

TEST_F(RangeRateFlights, MakeVelocitiesBetter) {
  const auto [without, with] = errors(withRates(params_), 0.0);
  EXPECT_LT(with, 0.2 * without);
}

// If this fails, the first rows of a new track still tell that its target stands.
TEST_F(RangeRateFlights, ANewTrackFliesAtItsRangeRateAtOnce) {
  Listener listener(withRates(params_));
  feedInOrder(listener.adit, flights({target_}));
  const auto started = listener.of(TrackEvent::kStarted);
  ASSERT_FALSE(started.empty());
  EXPECT_NEAR(started.front().kinematics.range_rate, rateOf(target_, started.front().kinematics.time), 4.0 * kSigma);
}

// If this fails, whoever has no Doppler gets other tracks since there is some.
TEST_F(RangeRateFlights, WithoutRatesNothingChangesByABit) {
  RadarSectors radars = flights({target_, {40e3, 10e3, -90.0, 100.0}});
  const auto bytesOf = [&](const AditParams& params) {
    Listener listener(params);
    feedInOrder(listener.adit, radars);
    return listener.bytes();
  };
  const std::string ignored = bytesOf(params_);
  EXPECT_NE(bytesOf(withRates(params_)), ignored);
  for (auto& sector : radars[0])
    for (tws::Plot& plot : sector.plots) plot.range_rate = tws::Plot::kUnknown;
  EXPECT_EQ(bytesOf(withRates(params_)), ignored);
  EXPECT_EQ(bytesOf(params_), ignored);
}

TEST_F(RangeRateFlights, TheReportsSetIgnoresThem) {
  const RadarSectors radars = flights({target_});
  Listener without(paramsFor("nrl7952", {6.0})), with(withRates(paramsFor("nrl7952", {6.0})));
  feedInOrder(without.adit, radars);
  feedInOrder(with.adit, radars);
  EXPECT_EQ(with.bytes(), without.bytes());
}

// Two that pass each other within their errors, one inbound and one outbound. If this fails, their tracks may change.
TEST_F(RangeRateFlights, TellTargetsApartThatMeet) {
  const std::vector<TestTarget> both = {{100.0, 20e3, 0.0, 220.0}, {-100.0, 64e3, 0.0, -220.0}};
  Listener listener(withRates(params_));
  feedInOrder(listener.adit, flights(both));
  ASSERT_EQ(listener.confirmed().size(), 2U);
  for (const auto slot : listener.adit.tracks().living()) {
    const Track& track = listener.adit.tracks().at(slot);
    const bool first = track.uid == *listener.confirmed().begin();
    const auto begun = std::find_if(listener.updates.begin(), listener.updates.end(),
                                    [&](const RecordedUpdate& w) { return w.uid == track.uid; });
    EXPECT_GT(begun->kinematics.vy * track.smoothed.vy, 0.0) << first;
  }
}

// A radar with an unambiguous velocity of 50 m/s: aircraft fold several times.
TEST_F(RangeRateFlights, MayBeFolded) {
  AditParams folded = withRates(params_);
  folded.radars[0].range_rate_ambiguity = 100.0;
  const auto [without, with] = errors(folded, 100.0);
  EXPECT_LT(with, 0.7 * without);
}

// What a broken feed may send. If this fails, one plot ends the run or holds a track for ever.
TEST_F(RangeRateFlights, NonsenseDoesNoHarm) {
  RadarSectors radars = flights({target_});
  const double nonsense[] = {1e300, -1e5, 9e4, std::numeric_limits<double>::infinity(), 0.0, tws::Plot::kUnknown};
  std::size_t next = 0;
  for (auto& sector : radars[0])
    for (tws::Plot& plot : sector.plots)
      if (next++ % 3 == 0) plot.range_rate = nonsense[next / 3 % std::size(nonsense)];
  Listener listener(withRates(params_));
  feedInOrder(listener.adit, radars);
  EXPECT_GE(listener.confirmed().size(), 1U);
  for (const RecordedUpdate& w : listener.updates) EXPECT_TRUE(std::isfinite(w.kinematics.x + w.kinematics.vx));
}

TEST(RangeRateParams, AreChecked) {
  AditParams params = paramsFor("default", {6.0});
  params.radars[0].range_rate_sigma = -1.0;
  EXPECT_THROW(check(params), std::invalid_argument);
  params.radars[0].range_rate_sigma = 2.0;
  params.radars[0].range_rate_span = 0.0;
  EXPECT_THROW(check(params), std::invalid_argument);
  params.radars[0].range_rate_span = 600.0;
  params.radars[0].range_rate_ambiguity = -5.0;
  EXPECT_THROW(check(params), std::invalid_argument);
}

// If this fails, what stands seems to come at a ship that sails towards it.
TEST(RangeRateOnOwnShip, IsToldAsIfTheShipStood) {
  const Passage ship{10.0, 11.0, {0.0, 0.0, 0.0}, {0.0, 8.0, 0.0}};
  tws::Plot ahead = plotAt(10.5, 3000.0, 0.0), abeam = plotAt(10.5, 3000.0, 0.5 * tws::kPi);
  ahead.range_rate = -8.0;  // A rock.
  abeam.range_rate = 0.0;
  EXPECT_NEAR(seenFrom({}, ship, ahead).range_rate, 0.0, 1e-9);
  EXPECT_NEAR(seenFrom({}, ship, abeam).range_rate, 0.0, 1e-9);
  const Passage turned{10.0, 11.0, {0.0, 0.0, 0.5 * tws::kPi}, {8.0, 0.0, 0.5 * tws::kPi}};
  EXPECT_NEAR(seenFrom({}, turned, ahead).range_rate, 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(seenFrom({}, {10.0, 10.0, {}, {}}, ahead).range_rate));
  EXPECT_TRUE(std::isnan(seenFrom({}, ship, plotAt(10.5, 3000.0)).range_rate));
}

/// A radar 38 km to the east of the first one, and a target at a height.
TEST(RangeRateOfSites, CountsFromTheRadarsOwnPlace) {
  const tws::SiteFrame island{38e3, 12e3, 0.008};
  AditParams params = withRates(paramsFor("default", {6.0, 8.0}));
  TestRadar first(6.0), second(8.0, 0.5);
  const TestTarget target{60e3, -30e3, -150.0, 180.0};
  const double c = std::cos(island.turn), s = std::sin(island.turn), x = target.x - island.x, y = target.y - island.y;
  const TestTarget seen{c * x + s * y, c * y - s * x, c * target.vx + s * target.vy, c * target.vy - s * target.vx};
  RadarSectors radars = {first.sectors(0.0, 200.0), second.sectors(0.0, 200.0)};
  first.see(target, radars[0]);
  second.see(seen, radars[1]);
  constexpr double kHeight = 4000.0;
  const auto measure = [&](std::vector<tws::RadarSector>& sectors, const TestTarget& from) {
    for (auto& sector : sectors) {
      for (tws::Plot& plot : sector.plots) {
        const double px = from.x + from.vx * plot.time, py = from.y + from.vy * plot.time;
        plot.range = std::hypot(plot.range, kHeight);
        plot.range_rate = (px * from.vx + py * from.vy) / plot.range;
      }
    }
  };
  measure(radars[0], target);
  measure(radars[1], seen);
  Listener listener(params);
  listener.adit.place(1, island);
  feedInOrder(listener.adit, radars);
  ASSERT_EQ(listener.confirmed().size(), 1U);
  ASSERT_EQ(listener.adit.tracks().living().size(), 1U);
  const Kinematics k = listener.adit.tracks().extrapolate(listener.adit.tracks().living().front(), 199.0).kinematics;
  EXPECT_NEAR(k.vx, target.vx, 2.0);
  EXPECT_NEAR(k.vy, target.vy, 2.0);
}

}  // namespace
}  // namespace adit_tracker
