#include "run_summary.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <sstream>

#include <tws_core/temporary_folder_test_helpers.h>

namespace tws_launch {
namespace {

using tws::TemporaryFolder;

// A user judges a run by this table: what it says must be what happened.

using tws_msgs::Track;

tws_msgs::Detections detections(const std::string& radar, double time, std::size_t plots) {
  tws_msgs::Detections message;
  message.header.stamp = ros::Time(time);
  message.radar = radar;
  message.detections.resize(plots);
  return message;
}

tws_msgs::Tracks tracks(const std::vector<std::pair<std::uint32_t, std::uint8_t>>& uids_and_states) {
  tws_msgs::Tracks message;
  message.tracker = "adit";
  for (const auto& [uid, state] : uids_and_states) {
    message.tracks.emplace_back();
    message.tracks.back().uid = uid;
    message.tracks.back().state = state;
  }
  return message;
}

std::string printed(const RunSummary& summary, const std::vector<tws_runtime::CounterReading>& counters = {}) {
  std::ostringstream out;
  summary.print(out, counters, 2.5);
  return out.str();
}

/// The numbers of the row that begins with `name`.
std::vector<double> row(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != name) continue;
    std::vector<double> numbers;
    for (double number = 0.0; words >> number;) numbers.push_back(number);
    return numbers;
  }
  return {};
}

// If these fail, a run in which nothing was understood ends as well as one with a hundred tracks.
TEST(RunSummary, ARunWithoutATrackFailsAndSaysWhatWasInIt) {
  EXPECT_NE(RunSummary().failure().find("no radar's plots came out of the input"), std::string::npos);
  RunSummary summary;
  summary.add(detections("a", 0.5, 0));
  summary.add(detections("b", 30.5, 0));
  EXPECT_NE(summary.failure().find("0 plots of a, b in 30.0 s; are the radars' messages empty"), std::string::npos);
  summary.add(detections("a", 31.5, 7));
  EXPECT_NE(summary.failure().find("7 plots of a, b in 31.0 s, of which no track began"), std::string::npos);
}

TEST(RunSummary, TracksOfWhichNoneIsConfirmedAreAFailureAfterAMinute) {
  RunSummary summary;
  summary.add(detections("a", 1.0, 10));
  summary.add(tracks({{1, Track::TENTATIVE}, {2, Track::DROPPED}}));
  EXPECT_EQ(summary.failure(), "");
  summary.add(detections("a", 61.0, 10));
  EXPECT_NE(summary.failure().find("2 tracks began, none confirmed"), std::string::npos);
  summary.add(tracks({{1, Track::FIRM}}));
  EXPECT_EQ(summary.failure(), "");
}

// If this fails, a run whose tracker stood from some time on ends as well as one that was tracked to its end.
TEST(RunSummary, ATrackerThatFallsSilentWhileItsRadarSpeaksIsAFailure) {
  const auto of = [](const std::string& radar, double time) {
    tws_msgs::Tracks message = tracks({{1, Track::FIRM}});
    message.radar = radar;
    message.header.stamp = ros::Time(time);
    return message;
  };
  RunSummary summary;
  for (const char* radar : {"a", "b"}) {
    summary.add(detections(radar, 1.0, 10));
    summary.add(of(radar, 21.0));
  }
  summary.add(detections("a", 80.0, 10));
  EXPECT_EQ(summary.failure(), "");  // Who lags is not silent, and b has nothing to say.
  summary.add(detections("a", 91.0, 10));
  EXPECT_NE(summary.failure().find("tracker adit fell silent at 20.0 s, while a spoke until 90.0 s"),
            std::string::npos);
  summary.add(of("a", 90.0));
  EXPECT_EQ(summary.failure(), "");
}

// If this fails, one mad stamp in a bag ends the run's summary, which then says nothing of all the rest.
TEST(RunSummary, AStampAtTheEndOfTimeIsBorne) {
  RunSummary summary;
  summary.add(detections("a", 1.0, 10));
  tws_msgs::Tracks mad = tracks({{1, Track::FIRM}});
  mad.radar = "a";
  mad.header.stamp = ros::TIME_MAX;
  summary.add(mad);
  EXPECT_GT(summary.trackedTime(), 4e9);
  EXPECT_EQ(summary.failure(), "");
}

TEST(RunSummary, CountsDwellsAndMeasurementsOfEachArray) {
  tws_msgs::DwellReports period;
  period.radar = "esa";
  period.dwells.resize(3);
  period.dwells[1].is_track_dwell = true;
  period.dwells[1].measurements.resize(5);
  RunSummary summary;
  for (const double time : {10.0, 12.0}) {
    period.header.stamp = ros::Time(time);
    summary.add(period);
  }
  EXPECT_EQ(summary.plots(), 10U);
  EXPECT_EQ(summary.simulatedTime(), 2.0);
  EXPECT_EQ(row(printed(summary), "esa"), (std::vector<double>{2, 6, 2, 10, 5.0}));
}

TEST(RunSummary, CountsSectorsAndPlotsOfEachRadarAndTheTimeBetweenFirstAndLast) {
  RunSummary summary;
  summary.add(detections("a", 10.0, 2));
  summary.add(detections("b", 12.0, 0));
  summary.add(detections("a", 14.0, 4));
  EXPECT_DOUBLE_EQ(summary.simulatedTime(), 4.0);
  EXPECT_EQ(summary.plots(), 6U);
  const std::string table = printed(summary);
  EXPECT_NE(table.find("simulated time 4.0 s, wall time 2.5 s"), std::string::npos) << table;
  EXPECT_EQ(row(table, "a"), (std::vector<double>{2, 6, 1.5})) << table;
  EXPECT_EQ(row(table, "b"), (std::vector<double>{1, 0, 0.0})) << table;
}

TEST(RunSummary, CountsEachTrackByItsLatestUpdate) {
  RunSummary summary;
  summary.add(tracks({{1, Track::TENTATIVE}, {2, Track::TENTATIVE}, {3, Track::TENTATIVE}}));
  summary.add(tracks({{1, Track::FIRM}, {2, Track::FIRM}, {4, Track::TENTATIVE}}));
  summary.add(tracks({{1, Track::COASTING}, {3, Track::DROPPED}}));
  tws_msgs::ClutterMap map;
  map.tracker = "adit";
  map.points.resize(7);
  summary.add(map);
  EXPECT_EQ(summary.livingTracks(), 3U);
  // Started 4, firmed 2, dropped 1; at the end one each firm, coasting and tentative, and 7 clutter points.
  EXPECT_EQ(row(printed(summary), "adit"), (std::vector<double>{4, 2, 1, 1, 1, 1, 7})) << printed(summary);
}

// If this fails, of a recording that repeats itself the tracks of one round are counted.
TEST(RunSummary, CountsTheTracksOfEachRun) {
  RunSummary summary;
  for (const double time : {100.0, 110.0, 20.0, 30.0}) {
    tws_msgs::Tracks message = tracks({{1, Track::FIRM}, {2, Track::FIRM}});
    message.header.stamp = ros::Time(time);
    summary.add(message);
  }
  EXPECT_EQ(row(printed(summary), "adit"), (std::vector<double>{4, 4, 2, 2, 0, 0, 0})) << printed(summary);
}

TEST(RunSummary, ShowsOnlyCountersThatCounted) {
  const std::string table = printed(RunSummary(), {{"adit", "late sectors", 3, true}, {"adit", "gaps", 0, false}});
  EXPECT_NE(table.find("late sectors"), std::string::npos) << table;
  EXPECT_EQ(table.find("gaps"), std::string::npos) << table;
}

TEST(RunSummary, TakesTheLatestValueOfTheDiagnostics) {
  diagnostic_msgs::DiagnosticArray message;
  message.status.resize(1);
  message.status[0].hardware_id = "adit";
  message.status[0].values.resize(1);
  message.status[0].values[0].key = "gaps";
  RunSummary summary;
  for (const char* value : {"2", "5"}) {
    message.status[0].values[0].value = value;
    summary.add(message);
  }
  ASSERT_EQ(summary.counters().size(), 1U);
  EXPECT_EQ(summary.counters()[0].node, "adit");
  EXPECT_EQ(summary.counters()[0].value, 5U);
}

TEST(RunSummary, ReadsABag) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.bag");
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.write("/a/detections", ros::Time(1.0), detections("a", 1.0, 2));
  bag.write("/adit/tracks", ros::Time(1.0), tracks({{1, Track::FIRM}}));
  bag.close();
  const RunSummary summary = RunSummary::ofBag(path);
  EXPECT_EQ(summary.plots(), 2U);
  EXPECT_EQ(summary.livingTracks(), 1U);
}

TEST(RunSummary, NamesTheFileThatIsNoBag) {
  try {
    RunSummary::ofBag("/dev/null");
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/null"), std::string::npos) << error.what();
  }
}

TEST(RunSummary, OfACorrelatorCountsIdentitiesAndWhatTheLivingOnesAre) {
  using tws_msgs::CorrelatedTrack;
  RunSummary summary;
  tws_msgs::CorrelatedTracks message;
  const auto say = [&](std::uint32_t identity, std::uint8_t kind, std::uint8_t state) {
    message.tracks.emplace_back();
    message.tracks.back().identity = identity;
    message.tracks.back().kind = kind;
    message.tracks.back().track.state = state;
  };
  say(1, CorrelatedTrack::PRIMARY_ONLY, Track::FIRM);
  say(2, CorrelatedTrack::SECONDARY_ONLY, Track::FIRM);
  say(3, CorrelatedTrack::SECONDARY_ONLY, Track::FIRM);
  summary.add(message);
  message.tracks.clear();
  say(2, CorrelatedTrack::SECONDARY_ONLY, Track::DROPPED);
  say(1, CorrelatedTrack::CORRELATED, Track::FIRM);
  summary.add(message);
  summary.add(tracks({{7, Track::FIRM}, {8, Track::FIRM}, {9, Track::FIRM}}));
  EXPECT_EQ(summary.livingTracks(), 2U);  // One aircraft is two tracks and one identity.
  EXPECT_EQ(row(printed(summary), "correlated"), (std::vector<double>{3, 1, 1, 0, 1}));
}

}  // namespace
}  // namespace tws_launch
