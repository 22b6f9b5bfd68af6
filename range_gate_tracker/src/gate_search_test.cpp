#include "gate_search.h"

#include <gtest/gtest.h>

#include <vector>

namespace range_gate_tracker {
namespace {

RangeGateParams searchParams() {
  RangeGateParams params;
  params.window = 100.0;
  params.velocity_limit = 200.0;
  params.gate_length = 1000.0;
  params.widest_gate = 3000.0;
  params.min_range = 1000.0;
  params.max_range = 11000.0;
  params.widening_time = 5.0;
  params.sweep_dwell = 0.5;
  return params;
}

// A target that flies off at the velocity limit must stay inside while the gate widens.
TEST(GateSearch, OpensAsFastAsTheTargetMayGoUpToTheWidestGate) {
  GateSearch search(searchParams());
  search.begin(6000.0, 100.0);
  EXPECT_DOUBLE_EQ(search.gate(100.0).min, 5500.0);
  EXPECT_DOUBLE_EQ(search.gate(100.0).max, 6500.0);
  EXPECT_DOUBLE_EQ(search.gate(102.0).min, 5500.0 - 400.0);
  EXPECT_DOUBLE_EQ(search.gate(102.0).max, 6500.0 + 400.0);
  EXPECT_DOUBLE_EQ(search.gate(104.99).min, 6000.0 - 0.5 * (1000.0 + 2 * 200.0 * 4.99));
  search.begin(6000.0, 0.0);
  RangeGateParams patient = searchParams();
  patient.widening_time = 60.0;
  GateSearch wide(patient);
  wide.begin(6000.0, 0.0);
  EXPECT_DOUBLE_EQ(wide.gate(50.0).min, 4500.0);
  EXPECT_DOUBLE_EQ(wide.gate(50.0).max, 7500.0);
}

TEST(GateSearch, NeverLooksWhereTheRadarCannot) {
  GateSearch search(searchParams());
  for (const double range : {-5000.0, 1000.0, 1200.0, 10900.0, 99999.0}) {
    search.begin(range, 0.0);
    for (double time = 0.0; time < 30.0; time += 0.1) {
      EXPECT_GE(search.gate(time).min, 1000.0);
      EXPECT_LE(search.gate(time).max, 11000.0);
    }
  }
}

// Wherever the target has moved, one sweep must meet it, whole in one gate.
TEST(GateSearch, SweepsOverEveryWindowOfAllRangesNearestFirst) {
  GateSearch search(searchParams());
  search.begin(6200.0, 0.0);
  std::vector<RangeInterval> gates;
  for (double time = 5.25; time < 5.25 + 0.5 * 20; time += 0.5) gates.push_back(search.gate(time));
  for (double from = 1000.0; from + 100.0 <= 11000.0; from += 10.0) {
    bool seen = false;
    for (const RangeInterval& gate : gates) seen = seen || (gate.min <= from + 1e-9 && gate.max >= from + 100.0 - 1e-9);
    EXPECT_TRUE(seen) << "nobody looks at " << from;
  }
  EXPECT_DOUBLE_EQ(gates[0].centre(), 6200.0);
  EXPECT_DOUBLE_EQ(gates[1].centre(), 7100.0);
  EXPECT_DOUBLE_EQ(gates[2].centre(), 5300.0);
}

TEST(GateSearch, BeginsAnewAfterASweep) {
  GateSearch search(searchParams());
  search.begin(6000.0, 0.0);
  int returns = 0;
  for (double time = 5.25; time < 30.0; time += 0.5) returns += search.gate(time).centre() == 6000.0;
  EXPECT_GE(returns, 3);
}

TEST(GateSearch, CutsAGateThatIsLongerThanAllRanges) {
  RangeGateParams narrow = searchParams();
  narrow.max_range = 1500.0;
  const RangeInterval gate = gateAbout(1400.0, 4000.0, narrow);
  EXPECT_DOUBLE_EQ(gate.min, 1000.0);
  EXPECT_DOUBLE_EQ(gate.max, 1500.0);
}

}  // namespace
}  // namespace range_gate_tracker
