#include "core/alignment.h"

#include <gtest/gtest.h>

#include <sstream>

#include <tws_core/units.h>

#include "core/adit_test_helpers.h"
#include "io/registration_csv.h"

namespace adit_tracker {
namespace {

// Two radars, of which the second errs. If these fail, every aircraft jumps to and fro between two places, or the
// learned errors swallow what is wrong.

class TwoRadars : public testing::Test {
 protected:
  /// Thirty aircraft over 300 s; the second radar is off by so much.
  RadarSectors flights(double range_bias, double azimuth_bias, std::size_t aircraft = 30) const {
    const TestRadar first{6.0}, second{8.0, 0.5};
    RadarSectors radars = {first.sectors(0.0, 300.0), second.sectors(0.0, 300.0)};
    for (std::size_t i = 0; i < aircraft; ++i) {
      const double azimuth = 2.4 * static_cast<double>(i), range = 30e3 + 1.5e3 * static_cast<double>(i);
      const double course = 1.1 * static_cast<double>(i);
      const TestTarget target{range * std::sin(azimuth), range * std::cos(azimuth), 120.0 * std::sin(course),
                              120.0 * std::cos(course)};
      first.see(target, radars[0]);
      second.see(target, radars[1]);
    }
    auto generator = tws::seededGenerator();
    for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 0.9, 0.1, generator);
    for (auto& sector : radars[1]) {
      for (auto& plot : sector.plots) {
        plot.range += range_bias;
        plot.azimuth = tws::wrapTwoPi(plot.azimuth + azimuth_bias);
      }
    }
    return radars;
  }

  AditParams params_ = paramsFor("default", {6.0, 8.0});
};

TEST_F(TwoRadars, AreAlignedAndTheLearnedErrorsAreThoseOfNoise) {
  Listener listener(params_);
  feedInOrder(listener.adit, flights(-194.0, -0.0093));
  const auto& reports = listener.adit.registration().reports();
  EXPECT_EQ(reports[1].state, tws::RegistrationState::kApplied);
  EXPECT_NEAR(reports[1].applied[tws::kAzimuthBias] - reports[0].applied[tws::kAzimuthBias], -0.0093, 0.0009);
  EXPECT_NEAR(reports[1].applied[tws::kRangeBias] - reports[0].applied[tws::kRangeBias], -194.0, 30.0);
  EXPECT_LT(listener.adit.radars().quality(1).azimuthSigma(), 1.25 * 0.004);
}

TEST_F(TwoRadars, ThatAgreeGiveTheSameTracksAsWithoutIt) {
  Listener with(params_);
  params_.registration.mode = tws::RegistrationMode::kOff;
  Listener without(params_);
  feedInOrder(with.adit, flights(0.0, 0.0));
  feedInOrder(without.adit, flights(0.0, 0.0));
  EXPECT_EQ(with.adit.registration().applied(1)[tws::kAzimuthBias], 0.0);
  EXPECT_TRUE(with.bytes() == without.bytes());
  EXPECT_GT(with.adit.registration().reports()[1].pairings, 500U);
}

TEST_F(TwoRadars, TheResultDoesNotDependOnHowTheyInterleave) {
  const RadarSectors radars = flights(-194.0, -0.0093);
  auto generator = tws::seededGenerator();
  std::string first;
  for (int i = 0; i < 3; ++i) {
    Listener listener(params_);
    feed(listener.adit, radars, i == 0 ? 0.0 : 0.45, generator);
    if (i == 0) first = listener.bytes();
    EXPECT_TRUE(listener.bytes() == first) << i;
  }
}

TEST_F(TwoRadars, WhoseOnlyAircraftFliesRadiallyStayAsTheyAre) {
  const TestRadar first{6.0}, second{8.0, 0.5};
  RadarSectors radars = {first.sectors(0.0, 300.0), second.sectors(0.0, 300.0)};
  const TestTarget target{50e3, 60e3, 128.0, 153.6};
  first.see(target, radars[0]);
  second.see(target, radars[1]);
  auto generator = tws::seededGenerator();
  for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 1.0, 0.1, generator);
  for (auto& sector : radars[1])
    for (auto& plot : sector.plots) plot.azimuth += 0.008;
  Listener listener(params_);
  feedInOrder(listener.adit, radars);
  EXPECT_EQ(listener.adit.registration().reports()[1].state, tws::RegistrationState::kUnobservable);
  EXPECT_EQ(listener.adit.registration().applied(1), tws::RegistrationTerms{});
}

TEST_F(TwoRadars, AReferenceTellsWhichOneIsWrong) {
  params_.registration_references.push_back({"mast", 20e3, 30e3, 0.0, 10.0});
  params_.registration_references.push_back({"monitor", -25e3, -10e3, 0.0, 10.0});
  RadarSectors radars = flights(0.0, 0.00873);
  const TestRadar first{6.0}, second{8.0, 0.5};
  RadarSectors fixed = {first.sectors(0.0, 300.0), second.sectors(0.0, 300.0)};
  for (const auto& reference : params_.registration_references) {
    first.see({reference.x, reference.y, 0.0, 0.0}, fixed[0]);
    second.see({reference.x, reference.y, 0.0, 0.0}, fixed[1]);
  }
  auto generator = tws::seededGenerator();
  for (std::size_t r = 0; r < 2; ++r) {
    disturb(fixed[r], 30.0, 0.002, 1.0, 0.0, generator);
    for (std::size_t i = 0; i < fixed[r].size(); ++i) {
      for (tws::Plot plot : fixed[r][i].plots) {
        if (r == 1) plot.azimuth = tws::wrapTwoPi(plot.azimuth + 0.00873);
        radars[r][i].plots.push_back(plot);
      }
      auto& plots = radars[r][i].plots;
      std::sort(plots.begin(), plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    }
  }
  Listener listener(params_);
  feedInOrder(listener.adit, radars);
  EXPECT_NEAR(listener.adit.registration().applied(1)[tws::kAzimuthBias], 0.00873, 0.001);
  EXPECT_NEAR(listener.adit.registration().applied(0)[tws::kAzimuthBias], 0.0, 0.001);
}

TEST_F(TwoRadars, OfTheReportsSetAreLeftAlone) {
  Listener listener(paramsFor("nrl7952", {6.0, 8.0}));
  feedInOrder(listener.adit, flights(-194.0, -0.0093));
  EXPECT_EQ(listener.adit.registration().reports()[1].state, tws::RegistrationState::kOff);
  EXPECT_EQ(listener.adit.registration().reports()[1].pairings, 0U);
}

TEST_F(TwoRadars, GoOnFromASavedFile) {
  Listener before(params_), after(params_);
  feedInOrder(before.adit, flights(-194.0, -0.0093));
  std::stringstream file;
  writeRegistration(file, before.adit);
  readRegistration(file, "file", after.adit);
  EXPECT_EQ(after.adit.registration().filter().mean(), before.adit.registration().filter().mean());
  EXPECT_NE(after.adit.registration().applied(1)[tws::kAzimuthBias], 0.0);
  for (const char* broken : {"radar,term,value\n", "radar,term,value\nr0,range_m,1\n", "radar,term\n", "x"}) {
    std::stringstream bad(broken);
    EXPECT_THROW(readRegistration(bad, "file", after.adit), std::runtime_error) << broken;
  }
}

TEST_F(TwoRadars, APlotIsToldAsItsRadarHasToldIt) {
  const tws::RegistrationTerms taken{-194.0, 1e-4, 0.01, 0.002, -0.001, 0.3};
  const double told_range = 50e3, told_azimuth = 1.0;
  double time = 99.7, range = (told_range + 194.0) / 1.0001, azimuth = told_azimuth - tws::azimuthError(taken, 1.0);
  asTold(taken, time, range, azimuth);
  EXPECT_NEAR(time, 100.0, 1e-9);
  EXPECT_NEAR(range, told_range, 1e-6);
  EXPECT_NEAR(azimuth, told_azimuth, 1e-9);
}

}  // namespace
}  // namespace adit_tracker
