#include "state_csv.h"

#include <gtest/gtest.h>

#include <sstream>

namespace track_evaluation {
namespace {

// A user's file that is wrong must be named with its line, not scored.

std::vector<CsvState> read(const std::string& rows, const std::string& header = "t_s,id,x_m,y_m,vx_mps,vy_mps") {
  std::istringstream input(header + "\n" + rows);
  return readStates(input, "f.csv");
}

std::string reason(const std::string& rows, const std::string& header = "t_s,id,x_m,y_m,vx_mps,vy_mps") {
  try {
    read(rows, header);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(StateCsv, ReadsRowsInOrderOfTime) {
  const auto states = read("5,1,10,20,1,2\r\n\n2.5, 7 ,-1e3,0,0,0\n");
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].time, 2.5);
  EXPECT_EQ(states[0].id, 7U);
  EXPECT_EQ(states[1].state.position, Eigen::Vector2d(10, 20));
  EXPECT_EQ(states[1].state.velocity, Eigen::Vector2d(1, 2));
}

TEST(StateCsv, LeavesOutTentativeTracks) {
  EXPECT_EQ(read("1,1,0,0,0,0,tentative\n1,2,0,0,0,0,firm\n", "t_s,id,x_m,y_m,vx_mps,vy_mps,status").size(), 1U);
}

TEST(StateCsv, NamesFileLineAndReason) {
  EXPECT_EQ(reason("1,1,0,0,0,0\n1,x,0,0,0,0\n"), "f.csv:3: id 'x' is no whole number from 0");
  EXPECT_EQ(reason("1,1,0,nan,0,0\n"), "f.csv:2: y_m 'nan' is no number");
  EXPECT_EQ(reason("1,1.5,0,0,0,0\n"), "f.csv:2: id '1.5' is no whole number from 0");
  EXPECT_EQ(reason("1,1,0\n"), "f.csv:2: 3 values under 6 column names");
  EXPECT_EQ(reason("", "t_s,id"), "f.csv:1: wants columns t_s,id,x_m,y_m[,vx_mps,vy_mps]");
}

TEST(StateCsv, TracksMustStandAtTheTimesOfTheTruth) {
  const auto truth = read("0,1,0,0,0,0\n5,1,0,0,0,0\n");
  EXPECT_THROW(epochsOf(truth, read("4,7,0,0,0,0\n"), std::nullopt), std::runtime_error);
  EXPECT_THROW(epochsOf({}, truth, std::nullopt), std::runtime_error);
  const auto epochs = epochsOf(truth, read("5,7,0,0,0,0\n"), std::nullopt);
  ASSERT_EQ(epochs.size(), 2U);
  EXPECT_TRUE(epochs[0].tracks.empty());
  EXPECT_EQ(epochs[1].tracks.at(0).id, 7U);
}

TEST(StateCsv, ResamplingExtrapolatesTheNewestRowThatIsNotTooOld) {
  const auto truth = read("0,1,0,0,0,0\n5,1,0,0,0,0\n10,1,0,0,0,0\n");
  const auto epochs = epochsOf(truth, read("1,7,0,0,10,0\n3,7,100,0,10,0\n"), 4.0);
  EXPECT_TRUE(epochs[0].tracks.empty());
  ASSERT_EQ(epochs[1].tracks.size(), 1U);
  EXPECT_EQ(epochs[1].tracks[0].state.position.x(), 120.0);
  EXPECT_TRUE(epochs[2].tracks.empty());  // 7 s old
}

}  // namespace
}  // namespace track_evaluation
