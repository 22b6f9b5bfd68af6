#include "frame_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/random_test_helpers.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kApart = 0.2;  // ten beamwidths

/// A dwell at one of the places 0, 1, 2, ... far apart, named by its number.
Dwell dwellAtPlace(std::uint32_t number, int place, const std::vector<std::uint32_t>& tracks = {}) {
  Dwell dwell = dwellAt(0.02 * number, kApart * place, 0.0, {measurementAt(50e3, kApart * place, 0.0)});
  dwell.number = number;
  dwell.group_indices = tracks;
  return dwell;
}

ResourcePeriod period(std::vector<Dwell> dwells, double next_dwell = 0.0) {
  return {0.1, next_dwell, std::move(dwells)};
}

using Numbers = std::vector<std::vector<std::uint32_t>>;

/// The numbers of the dwells of each frame.
Numbers numbersOf(const std::vector<Frame>& frames) {
  Numbers numbers;
  for (const Frame& frame : frames) {
    numbers.emplace_back();
    for (const Dwell& dwell : frame.dwells) numbers.back().push_back(dwell.number);
  }
  return numbers;
}

FrameBuilderParams paramsOf(Algorithm algorithm) {
  FrameBuilderParams params;
  params.algorithm = algorithm;
  return params;
}

TEST(FrameBuilder, Algorithm1MakesEachDwellAFrame) {
  FrameBuilder builder(paramsOf(Algorithm::kDwellIsFrame));
  const auto frames = builder.take(period({dwellAtPlace(0, 0), dwellAtPlace(1, 1), dwellAtPlace(2, 0)}));
  EXPECT_EQ(numbersOf(frames), (Numbers{{0}, {1}, {2}}));
  EXPECT_TRUE(builder.partialFrames().empty());
  for (std::uint32_t n = 0; n < 3; ++n) {
    EXPECT_TRUE(frames[n].closed);
    EXPECT_EQ(frames[n].number, n);
  }
}

TEST(FrameBuilder, Algorithm2MergesWithinThePeriodUntilABeamPointRepeats) {
  FrameBuilder builder(paramsOf(Algorithm::kWithinPeriod));
  const auto frames = builder.take(
      period({dwellAtPlace(0, 0), dwellAtPlace(1, 1), dwellAtPlace(2, 0), dwellAtPlace(3, 2), dwellAtPlace(4, 1)}));
  EXPECT_EQ(numbersOf(frames), (Numbers{{0, 1}, {2, 3, 4}}));
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(5, 3)}))), (Numbers{{5}})) << "the period's end closes it";
  EXPECT_TRUE(builder.take(period({})).empty());
}

TEST(FrameBuilder, Algorithm3GoesOnAcrossPeriods) {
  FrameBuilder builder(paramsOf(Algorithm::kAcrossPeriods));
  EXPECT_TRUE(builder.take(period({dwellAtPlace(0, 0), dwellAtPlace(1, 1)})).empty());
  EXPECT_TRUE(builder.take(period({dwellAtPlace(2, 2)})).empty());
  EXPECT_EQ(numbersOf(builder.partialFrames()), (Numbers{{0, 1, 2}}));
  EXPECT_FALSE(builder.partialFrames()[0].closed);
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(3, 1)}))), (Numbers{{0, 1, 2}}));
  EXPECT_EQ(numbersOf(builder.partialFrames()), (Numbers{{3}}));
  EXPECT_EQ(builder.partialFrames()[0].number, 1U) << "the number that the closed frame will have";
}

TEST(FrameBuilder, Algorithm3ClosesAFrameThatADwellWouldKeepOpenTooLong) {
  FrameBuilderParams params = paramsOf(Algorithm::kAcrossPeriods);
  params.max_frame_time = 0.1;
  FrameBuilder builder(params);
  builder.take(period({dwellAtPlace(0, 0), dwellAtPlace(5, 1)}));  // 0.1 s later
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(6, 2)}))), (Numbers{{0, 5}}));
}

// With one period of allowance, 0.1 s: a dwell after that is judged by the tracks expected in it, not by its beam.
TEST(FrameBuilder, Algorithm3ComparesTracksInsteadOfBeamPointsOnceTargetsMayHaveMoved) {
  FrameBuilderParams params = paramsOf(Algorithm::kAcrossPeriods);
  params.greatest_allowance_periods = 1;
  {
    FrameBuilder builder(params);
    builder.take(period({dwellAtPlace(0, 0, {1})}));
    EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(4, 0, {2})}))), (Numbers{{0}})) << "0.08 s: the same beam";
  }
  FrameBuilder builder(params);
  builder.take(period({dwellAtPlace(0, 0, {1})}));
  EXPECT_TRUE(builder.take(period({dwellAtPlace(5, 0, {2})})).empty()) << "0.1 s: other tracks";
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(6, 3, {1})}))), (Numbers{{0, 5}}))
      << "the same track elsewhere";
}

TEST(FrameBuilder, Algorithm3ClosesAtThePeriodsEndWhenNoDwellIsExpectedInTime) {
  FrameBuilder builder(paramsOf(Algorithm::kAcrossPeriods));  // T_frame^max 0.5 s
  EXPECT_TRUE(builder.take(period({dwellAtPlace(0, 0)}, 0.5)).empty());
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(1, 1)}, 0.51))), (Numbers{{0, 1}}));
  EXPECT_EQ(numbersOf(builder.take(period({dwellAtPlace(2, 0)}, kNever))), (Numbers{{2}})) << "no track: none expected";
}

TEST(FrameBuilder, OnALiveSystemTheTimerClosesWhatIsStale) {
  FrameBuilderParams params = paramsOf(Algorithm::kAcrossPeriods);
  params.expects_next_dwell = false;
  FrameBuilder builder(params);
  EXPECT_TRUE(builder.take(period({dwellAtPlace(5, 0)}, kNever)).empty());  // at 0.1 s
  EXPECT_TRUE(builder.closeStale(0.6).empty());
  EXPECT_EQ(numbersOf(builder.closeStale(0.61)), (Numbers{{5}}));
  EXPECT_TRUE(builder.closeStale(9.0).empty());
}

// What the paper names as a variation: {1, 3, 5} in one frame and {2, 4, 6} in another, here with three places.
TEST(FrameBuilder, Algorithm4FillsSeveralFramesAtOnce) {
  const std::vector<Dwell> dwells{dwellAtPlace(0, 0), dwellAtPlace(1, 0), dwellAtPlace(2, 1),
                                  dwellAtPlace(3, 1), dwellAtPlace(4, 2), dwellAtPlace(5, 2)};
  FrameBuilder four(paramsOf(Algorithm::kSeveralOpen)), three(paramsOf(Algorithm::kAcrossPeriods));
  EXPECT_TRUE(four.take(period(dwells)).empty());
  EXPECT_EQ(numbersOf(four.partialFrames()), (Numbers{{0, 2, 4}, {1, 3, 5}}));
  EXPECT_EQ(numbersOf(three.take(period(dwells))), (Numbers{{0}, {1, 2}, {3, 4}})) << "in order of time";
}

TEST(FrameBuilder, Algorithm4ClosesTheOldestWhenTooManyAreOpen) {
  FrameBuilderParams params = paramsOf(Algorithm::kSeveralOpen);
  params.open_frames = 2;
  FrameBuilder builder(params);
  const auto frames =
      builder.take(period({dwellAtPlace(0, 0), dwellAtPlace(1, 0), dwellAtPlace(2, 1), dwellAtPlace(3, 0)}));
  EXPECT_EQ(numbersOf(frames), (Numbers{{0, 2}}));
  EXPECT_EQ(numbersOf(builder.partialFrames()), (Numbers{{1}, {3}}));
}

// A dwell beside the one in the younger frame may see its targets again: it must not go to the older frame, which the
// tracker gets first.
TEST(FrameBuilder, Algorithm4NeverPutsATargetsLaterDwellIntoAnEarlierFrame) {
  FrameBuilder builder(paramsOf(Algorithm::kSeveralOpen));
  Dwell beside = dwellAtPlace(3, 0);
  beside.u += 0.015;  // 0.75 beamwidths: merges
  builder.take(period({dwellAtPlace(0, 0), dwellAtPlace(1, 0), dwellAtPlace(2, 1), beside}));
  EXPECT_EQ(numbersOf(builder.partialFrames()), (Numbers{{0, 2}, {1, 3}}));
}

// If this fails, dwells are lost or come twice, or frames and their dwells are out of order.
TEST(FrameBuilder, EveryDwellIsInExactlyOneFrameAndFramesStartInOrder) {
  auto generator = tws::seededGenerator();
  for (int algorithm = 1; algorithm <= 4; ++algorithm) {
    FrameBuilder builder(paramsOf(static_cast<Algorithm>(algorithm)));
    std::vector<Frame> frames;
    std::uint32_t dwells = 0;
    for (int n = 0; n < 500; ++n) {
      std::vector<Dwell> taken;
      for (int k = tws::uniformInt(generator, 0, 6); k > 0; --k)
        taken.push_back(dwellAtPlace(dwells++, tws::uniformInt(generator, 0, 5)));
      for (Frame& frame : builder.take(period(taken, 0.02 * dwells))) frames.push_back(std::move(frame));
    }
    for (Frame& frame : builder.closeStale(kNever)) frames.push_back(std::move(frame));
    std::vector<bool> seen(dwells, false);
    double start = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i].number, i);
      EXPECT_GE(frames[i].dwells.front().time, start);
      double time = start = frames[i].dwells.front().time;
      for (const Dwell& dwell : frames[i].dwells) {
        EXPECT_GE(dwell.time, time);
        time = dwell.time;
        EXPECT_FALSE(seen[dwell.number]);
        seen[dwell.number] = true;
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0) << "algorithm " << algorithm;
  }
}

}  // namespace
}  // namespace esa_frame_builder
