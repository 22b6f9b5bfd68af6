#include "sector_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

constexpr double kPeriod = 4.0;
constexpr double kStart = 1000.0;  // the beam points north

// A radar with a report each tenth of a second and north marks, and what comes out.
class SectorCutterTest : public ::testing::Test {
 protected:
  SectorCutterTest()
      : cutter_({}, {[this](CutSector&& sector) { sectors_.push_back(std::move(sector)); },
                     [this](const std::string& counter, const std::string& reason) {
                       ++faults_[counter];
                       reason_ = reason;
                     }}) {}

  static TargetReport reportAt(double time) {
    TargetReport report;
    report.range = 10000.0;
    report.azimuth = tws::wrapTwoPi(tws::kTwoPi * (time - kStart) / kPeriod);
    return report;
  }
  void play(double from, double to) {
    for (long tenth = std::lround(10.0 * from); tenth < std::lround(10.0 * to); ++tenth) {
      const double time = static_cast<double>(tenth) / 10.0;
      if (std::abs(std::fmod(time - kStart, kPeriod)) < 0.01) cutter_.mark(time, 0.0);
      cutter_.add(reportAt(time + 0.01), time + 0.01);
      cutter_.advance(time + 0.01);
    }
  }
  std::size_t reports() const {
    std::size_t count = 0;
    for (const CutSector& sector : sectors_) count += sector.reports.size();
    return count;
  }

  std::vector<CutSector> sectors_;
  std::map<std::string, int> faults_;
  std::string reason_;  // of the latest
  SectorCutter cutter_;
};

// If this fails, trackers get detections twice, not at all, or in sectors where the beam was not.
TEST_F(SectorCutterTest, GivesEachReportOnceInTheSectorThatTheBeamWasIn) {
  play(kStart, kStart + 60.0);
  cutter_.finish();
  EXPECT_EQ(reports(), 600u);
  EXPECT_TRUE(faults_.empty());
  for (std::size_t i = 0; i < sectors_.size(); ++i) {
    const CutSector& sector = sectors_[i];
    EXPECT_EQ(sector.sector, sector.running % 64);
    EXPECT_NEAR(sector.leave_time - sector.enter_time, kPeriod / 64.0, 0.01);
    EXPECT_LT(std::abs(tws::angularDifference(tws::sectorStart(sector.sector),
                                              tws::kTwoPi * (sector.enter_time - kStart) / kPeriod)),
              0.01);
    for (const TimedReport& report : sector.reports) {
      EXPECT_GE(report.time, sector.enter_time - 1e-9);
      EXPECT_LT(report.time, sector.leave_time);
    }
    if (i == 0) continue;
    EXPECT_EQ(sector.running, sectors_[i - 1].running + 1);
    EXPECT_DOUBLE_EQ(sector.enter_time, sectors_[i - 1].leave_time);
  }
}

TEST_F(SectorCutterTest, ClosesASectorOnceTheRadarWasHeardASecondBeyondIt) {
  play(kStart, kStart + 60.0);
  ASSERT_FALSE(sectors_.empty());
  EXPECT_LE(sectors_.back().leave_time, kStart + 59.0);
  EXPECT_GT(sectors_.back().leave_time, kStart + 58.8);
}

// In bursts, the marks would come after the detections of many sectors, and be taken for lost.
TEST_F(SectorCutterTest, ClosesSectorsOneByOneWithTheFeedsTimeWhenSteady) {
  SectorCutter::Options options;
  options.steady = true;
  std::size_t most = 0;
  std::size_t before = 0;
  SectorCutter cutter(options, {[this](CutSector&& sector) { sectors_.push_back(std::move(sector)); },
                                [this](const std::string& counter, const std::string&) { ++faults_[counter]; }});
  for (int hundredth = 0; hundredth < 6000; ++hundredth) {
    const double time = kStart + hundredth / 100.0;
    if (hundredth % 400 == 0) cutter.mark(time, 0.0);
    if (hundredth % 170 == 0) cutter.add(reportAt(time), time);  // seldom
    cutter.advance(time);
    if (hundredth > 3000) most = std::max(most, sectors_.size() - before);
    before = sectors_.size();
  }
  EXPECT_EQ(most, 1u);
  EXPECT_NEAR(sectors_.back().leave_time, kStart + 60.0 - options.latency, 0.2);
  EXPECT_TRUE(faults_.empty());
}

// Reports leave a radar in the order in which they were worked on.
TEST_F(SectorCutterTest, PutsReportsThatComeOutOfOrderInOrder) {
  play(kStart, kStart + 40.0);
  cutter_.add(reportAt(kStart + 39.52), kStart + 39.52);
  cutter_.finish();
  EXPECT_EQ(reports(), 401u);
  EXPECT_TRUE(faults_.empty());
  for (const CutSector& sector : sectors_)
    for (std::size_t i = 1; i < sector.reports.size(); ++i)
      EXPECT_GE(sector.reports[i].time, sector.reports[i - 1].time);
}

TEST_F(SectorCutterTest, CountsALateReportAndKeepsIt) {
  play(kStart, kStart + 40.0);
  cutter_.add(reportAt(kStart + 35.0), kStart + 35.0);
  cutter_.finish();
  EXPECT_EQ(faults_["late reports"], 1);
  EXPECT_EQ(reports(), 401u);
}

TEST_F(SectorCutterTest, IgnoresASingleReportFromAnotherTime) {
  play(kStart, kStart + 40.0);
  cutter_.add(reportAt(kStart + 7000.0), kStart + 7000.0);
  cutter_.add(reportAt(kStart - 7000.0), kStart - 7000.0);
  play(kStart + 40.0, kStart + 60.0);
  cutter_.finish();
  EXPECT_EQ(faults_["reports at impossible times"], 2);
  EXPECT_EQ(reports(), 600u);
}

// A feed that is started again from its beginning, as a recording in a loop.
TEST_F(SectorCutterTest, BeginsAnewWhenTimeGoesBackForGood) {
  play(kStart + 400.0, kStart + 440.0);
  play(kStart, kStart + 40.0);
  cutter_.finish();
  EXPECT_EQ(faults_["new runs"], 1);
  EXPECT_EQ(reports(), 797u);                   // but for those before it was certain
  EXPECT_EQ(sectors_.back().running / 64, 10);  // from the second turn on
  EXPECT_NEAR(sectors_.back().leave_time, kStart + 40.0, 0.1);
}

// A tracker must not coast through an outage as if the radar had looked and seen nothing.
TEST_F(SectorCutterTest, IsSilentWhenTheRadarIsAndGoesOnInTheRightSector) {
  play(kStart, kStart + 40.0);
  play(kStart + 80.0, kStart + 120.0);
  cutter_.finish();
  EXPECT_EQ(faults_["silences"], 1);
  EXPECT_EQ(reports(), 800u);
  std::size_t in_gap = 0;
  for (const CutSector& sector : sectors_)
    in_gap += sector.enter_time > kStart + 41.0 && sector.leave_time < kStart + 79.0;
  EXPECT_EQ(in_gap, 0u);
  EXPECT_NEAR(static_cast<double>(sectors_.back().running - sectors_.front().running), 120.0 / kPeriod * 64.0, 2.0);
}

// Another speed, another phase: the sectors go on, their numbers and times grow, and it is said.
TEST_F(SectorCutterTest, FollowsAnAntennaThatChangesItsSpeed) {
  play(kStart, kStart + 40.0);
  const double changed = kStart + 40.0, period = 5.0;
  for (int tenth = 0; tenth < 400; ++tenth) {
    const double time = changed + tenth / 10.0;
    TargetReport report = reportAt(time);
    report.azimuth = tws::wrapTwoPi(tws::kTwoPi * (time - changed) / period);
    cutter_.add(report, time);
    cutter_.advance(time);
  }
  cutter_.finish();
  EXPECT_EQ(faults_["beam breaks"], 1);
  EXPECT_EQ(reports(), 800u);
  int off = 0;
  for (std::size_t i = 1; i < sectors_.size(); ++i) {
    EXPECT_GT(sectors_[i].running, sectors_[i - 1].running);
    EXPECT_GE(sectors_[i].enter_time, sectors_[i - 1].leave_time - 1e-9);
    for (const TimedReport& report : sectors_[i].reports)
      off += std::abs(tws::angularDifference(report.report.azimuth,
                                             tws::sectorStart(sectors_[i].sector) + tws::kSectorWidth / 2.0)) > 0.3;
  }
  EXPECT_LT(off, 30);  // less than a turn's
  EXPECT_NEAR(sectors_.back().period, period, 0.05);
}

// A stranger's plot, or a radar's bad one, is not the time: the feed is.
TEST_F(SectorCutterTest, TakesNoReportFromAheadOfALiveFeed) {
  SectorCutter::Options options;
  options.steady = true;
  SectorCutter cutter(options, {[this](CutSector&& sector) { sectors_.push_back(std::move(sector)); },
                                [this](const std::string& counter, const std::string&) { ++faults_[counter]; }});
  for (int tenth = 0; tenth < 600; ++tenth) {
    const double time = kStart + tenth / 10.0;
    cutter.add(reportAt(time), time);
    if (tenth % 100 == 50) cutter.add(reportAt(time + 40.0), time + 40.0);
    cutter.advance(time);
  }
  EXPECT_EQ(faults_["reports at impossible times"], 6);
  EXPECT_EQ(faults_["late reports"], 0);
  EXPECT_EQ(faults_["new runs"], 0);
}

// Without a time of its own a report belongs where the beam was, not where the latest mark was.
TEST_F(SectorCutterTest, PlacesAReportWithALentTimeByItsAzimuth) {
  play(kStart, kStart + 40.0);
  TargetReport report = reportAt(kStart + 39.0);
  report.time_from = TimeFrom::kMark;
  cutter_.add(report, kStart + 36.0);
  report.time_from = TimeFrom::kReception;
  cutter_.add(report, kStart + 39.4);
  cutter_.finish();
  EXPECT_EQ(reports(), 402u);
  int there = 0;
  for (const CutSector& sector : sectors_)
    for (const TimedReport& timed : sector.reports)
      there += timed.report.time_from != TimeFrom::kReport && std::abs(timed.time - (kStart + 39.0)) < 0.05;
  EXPECT_EQ(there, 2);
}

TEST_F(SectorCutterTest, SaysThatAnAntennaTurnsCounterClockwise) {
  std::string reason;
  SectorCutter cutter({}, {[](CutSector&&) {}, [&](const std::string&, const std::string& text) { reason = text; }});
  for (int tenth = 0; tenth < 600; ++tenth) {
    TargetReport report = reportAt(kStart + tenth / 10.0);
    report.azimuth = tws::kTwoPi - report.azimuth;
    cutter.add(report, kStart + tenth / 10.0);
  }
  cutter.finish();
  EXPECT_NE(reason.find("counter-clockwise, once in 4.0"), std::string::npos) << reason;
}

// A radar that scans a sector of 90 degrees in 3 s, to and fro; a report each tenth of a second, marks at each sector.
class ToAndFro : public SectorCutterTest {
 protected:
  static double azimuthAt(double time) {
    return tws::radians(300.0) + std::abs(std::remainder(time - kStart, 6.0)) / 3.0 * tws::kPi / 2.0;
  }
  static int sectorAt(double time) { return static_cast<int>(std::floor(azimuthAt(time) / tws::kSectorWidth)); }
  void sweep(double from, double to, bool with_marks) {
    for (long hundredth = std::lround(100.0 * from); hundredth < std::lround(100.0 * to); ++hundredth) {
      const double time = static_cast<double>(hundredth) / 100.0;
      const int sector = std::max(sectorAt(time), sectorAt(time - 0.01));
      if (with_marks && sectorAt(time) != sectorAt(time - 0.01))
        cutter_.mark(time, tws::wrapTwoPi(tws::kSectorWidth * sector));
      if (hundredth % 10 == 0) {
        TargetReport report = reportAt(time);
        report.azimuth = tws::wrapTwoPi(azimuthAt(time));
        cutter_.add(report, time);
      }
      cutter_.advance(time);
    }
  }
};

// If these fail, trackers get sectors that the radar never scanned, and its aircraft make tracks that are none.
TEST_F(ToAndFro, IsLeftOutAndNamed) {
  sweep(kStart, kStart + 300.0, false);
  EXPECT_EQ(faults_["unknown beams"], 1) << "live, nothing else says why there is no sector";
  cutter_.finish();
  EXPECT_TRUE(sectors_.empty());
  EXPECT_NE(reason_.find("scans to and fro, at about 30 deg/s"), std::string::npos) << reason_;
}

TEST_F(ToAndFro, IsLeftOutWithMarksToo) {
  sweep(kStart, kStart + 300.0, true);
  cutter_.finish();
  EXPECT_LE(sectors_.size(), 20U) << "the first sweep looks like any other antenna's";
  EXPECT_NE(reason_.find("scans to and fro, at about 30 deg/s"), std::string::npos) << reason_;
}

// Some radars do both.
TEST_F(ToAndFro, ARadarThatTurnsAgainIsReadAgain) {
  play(kStart, kStart + 60.0);
  sweep(kStart + 60.0, kStart + 180.0, false);
  const std::size_t until_then = sectors_.size();
  EXPECT_LE(until_then, 17U * 64U);
  EXPECT_EQ(faults_["beams lost"], 1);
  play(kStart + 180.0, kStart + 260.0);
  EXPECT_GT(sectors_.size(), until_then + 10U * 64U);
}

TEST_F(SectorCutterTest, GoesOnWithoutPlotsFromMarksAlone) {
  for (int turn = 0; turn < 20; ++turn) {
    cutter_.mark(kStart + turn * kPeriod, 0.0);
    cutter_.advance(kStart + turn * kPeriod);
  }
  EXPECT_GT(sectors_.size(), 18u * 64u);
}

TEST_F(SectorCutterTest, SaysWhenTheBeamWasNeverFound) {
  cutter_.add(reportAt(kStart), kStart);
  cutter_.finish();
  EXPECT_TRUE(sectors_.empty());
  EXPECT_EQ(faults_["reports of an unknown beam"], 1);
}

}  // namespace
}  // namespace asterix_bridge
