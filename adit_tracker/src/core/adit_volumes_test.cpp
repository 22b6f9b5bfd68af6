// Parameters that depend on the place.
#include <gtest/gtest.h>

#include <cmath>

#include "core/adit.h"
#include "core/adit_test_helpers.h"
#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kBorder = 30e3;

/// One that reaches from the site to the border, and at first changes nothing.
Volume inner(const AditParams& params) {
  Volume volume{"inner", {}, params};
  volume.region.greatest_range = kBorder;
  return volume;
}

/// Two radars of 6 and 8 s see these targets, with errors and false plots.
RadarSectors seen(const std::vector<TestTarget>& targets, double to, double false_plots) {
  RadarSectors radars;
  auto generator = tws::seededGenerator();
  for (const double period : {6.0, 8.0}) {
    const TestRadar radar(period);
    radars.push_back(radar.sectors(0.0, to));
    for (const TestTarget& target : targets) radar.see(target, radars.back());
    disturb(radars.back(), 50.0, 0.002, 0.95, false_plots, generator);
  }
  return radars;
}

std::unique_ptr<Listener> track(const AditParams& params, const RadarSectors& radars) {
  auto listener = std::make_unique<Listener>(params);
  feedInOrder(listener->adit, radars);
  listener->adit.finish();
  return listener;
}

/// To and fro across the border, and along it.
std::vector<TestTarget> crossing() {
  return {{-60e3, 5e3, 200.0, 0.0}, {10e3, -50e3, 0.0, 150.0}, {kBorder - 100.0, -40e3, 0.5, 180.0}};
}

// If this fails, a border that parts nothing from nothing disturbs the tracks that cross it.
TEST(Volumes, ThoseThatChangeNothingChangeNotOneBit) {
  const RadarSectors radars = seen(crossing(), 400.0, 0.3);
  AditParams params = paramsFor("default", {6.0, 8.0});
  const std::string without = track(params, radars)->bytes();
  params.volumes.push_back(inner(params));
  EXPECT_EQ(track(params, radars)->bytes(), without);
}

// If this fails, an aircraft that crosses a border is lost there, or gets another number.
TEST(Volumes, AnAircraftThatCrossesABorderKeepsItsTrack) {
  AditParams params = paramsFor("default", {6.0, 8.0});
  Volume volume = inner(params);
  volume.params = AditParams::named("airport");
  params.volumes.push_back(volume);
  const auto listener = track(params, seen(crossing(), 400.0, 0.0));
  const auto firm = listener->confirmed();
  EXPECT_EQ(firm.size(), crossing().size());
  for (const RecordedUpdate& end : listener->of(TrackEvent::kDropped)) EXPECT_EQ(firm.count(end.uid), 0U);
}

// A boat of 15 kn in front of the border and one behind it. If this fails, what a volume says does not count there, or
// counts elsewhere too.
TEST(Volumes, WhatIsSlowIsATrackWhereItsVolumeSaysSo) {
  AditParams params = paramsFor("default", {6.0, 8.0});
  Volume volume = inner(params);
  volume.params.conversion.speed_up = tws::speedFromKnots(4.0);
  volume.params.conversion.speed_down = tws::speedFromKnots(2.0);
  params.volumes.push_back(volume);
  const auto listener = track(params, seen({{0.0, 10e3, 7.7, 0.0}, {0.0, 60e3, 7.7, 0.0}}, 400.0, 0.0));
  const double late = 300.0;
  bool near = false, far = false;
  for (const RecordedUpdate& update : listener->updates) {
    if (!update.confirmed || update.sector_time < late) continue;
    (update.kinematics.range < kBorder ? near : far) = true;
  }
  EXPECT_TRUE(near);
  EXPECT_FALSE(far);
}

// If this fails, an airliner that passes over the airport counts as traffic of the airport although its height is
// known.
TEST(Volumes, AHeightThatIsKnownCountsFromTheFirstPlotAndAsTheTargetClimbs) {
  AditParams params = paramsFor("default", {6.0});
  params.volumes.push_back(inner(params));
  params.volumes[0].region.greatest_height = 2000.0;
  AditCounts counts;
  Radars radars(params);
  TrackBook book(params, radars, counts);
  book.begin({0, 100}, 10.0);
  const auto plot = [](double time, double height) {
    tws::Plot plot = plotAt(time, 20e3, 1.0);
    if (!std::isnan(height)) plot.elevation = std::asin(height / plot.range);
    return plot;
  };
  const auto started = [&](double height) { return *book.create(0, plot(10.0, height)); };
  EXPECT_EQ(book.at(started(VolumePlace{}.height)).volume, 1);
  EXPECT_EQ(book.at(started(9000.0)).volume, 0);
  const auto slot = started(1000.0);
  EXPECT_EQ(book.at(slot).volume, 1);
  for (int i = 1; i <= 20; ++i)
    book.update(slot, {0, 100 + 64 * i}, radars.at(0).quality, plot(10.0 + 6.0 * i, 1000.0 + 200.0 * i), nullptr,
                false);
  EXPECT_EQ(book.at(slot).volume, 0);
}

// If this fails, of two volumes that overlap not the first counts, or a track that leaves it for a moment is judged by
// others at each plot.
TEST(Volumes, TheFirstThatHoldsAPlaceCountsAndIsLeftWithAMargin) {
  AditParams params = paramsFor("default", {6.0});
  params.volumes = {inner(params), inner(params)};
  params.volumes[1].name = "outer";
  params.volumes[1].region.greatest_range = 60e3;
  EXPECT_EQ(params.volumeAt({10e3, 0.0}), 1);
  EXPECT_EQ(params.volumeAt({kBorder + 100.0, 0.0}), 2);
  EXPECT_EQ(params.volumeAt({kBorder + 100.0, 0.0}, 1), 1);
  EXPECT_EQ(params.volumeAt({kBorder - 100.0, 0.0}, 2), 1);
  EXPECT_EQ(params.volumeAt({70e3, 0.0}, 2), 0);
}

}  // namespace
}  // namespace adit_tracker
