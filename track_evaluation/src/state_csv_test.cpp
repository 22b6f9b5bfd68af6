#include "state_csv.h"

#include <gtest/gtest.h>

#include <cmath>
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

// If this fails, a file whose columns stand in another order scores as if every track were somewhere else.
TEST(StateCsv, FindsColumnsByTheirNames) {
  const auto states = read("7,10,20,1,2,5\n", "track_id,y_m,x_m,vy_mps,vx_mps,t_s");
  ASSERT_EQ(states.size(), 1U);
  EXPECT_EQ(states[0].time, 5.0);
  EXPECT_EQ(states[0].id, 7U);
  EXPECT_EQ(states[0].state.position, Eigen::Vector2d(20, 10));
  EXPECT_EQ(states[0].state.velocity, Eigen::Vector2d(2, 1));
}

// If this fails, tracks of a system that names them by texts cannot be scored.
TEST(StateCsv, AnyTextIsAnId) {
  const auto states = read("1,2,0,0\n1,b-7,0,0\n1,A1,0,0\n2,b-7,0,0\n2,1,0,0\n", "t_s,id,x_m,y_m");
  std::vector<std::uint32_t> ids;
  for (const CsvState& state : states) ids.push_back(state.id);
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{2, 3, 4, 3, 1}));
}

TEST(StateCsv, AVelocityMayBeUnknown) {
  for (const char* row : {"1,1,0,0,,\n", "1,1,0,0,nan,NaN\n", "1,1,0,0\n"})
    EXPECT_TRUE(std::isnan(read(row).at(0).state.velocity.x())) << row;
}

TEST(StateCsv, NamesFileLineAndReason) {
  EXPECT_EQ(reason("1,1,0,0,0,0\n1,,0,0,0,0\n"), "f.csv:3: the id is empty");
  EXPECT_EQ(reason("1e308,1,0,0,0,0\n"), "f.csv:2: t_s is beyond 1e10 s: 1e308 (it counts seconds, not milliseconds)");
  EXPECT_EQ(reason("1,1,0,nan,0,0\n"), "f.csv:2: y_m 'nan' is not finite");
  EXPECT_EQ(reason("1,1,0\n"), "f.csv:2: y_m is empty");
  EXPECT_EQ(reason("", "t_s,id"), "f.csv:1: has no column x_m (its columns are t_s,id)");
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
