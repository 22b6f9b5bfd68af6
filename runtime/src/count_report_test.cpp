#include <tws_runtime/count_report.h>

#include <gtest/gtest.h>
#include <tws_runtime/local_graph.h>

#include <sstream>

namespace tws_runtime {
namespace {

struct Totals {
  std::uint64_t plots = 0, late = 0;
};

// If this fails, the diagnostics show what a tracker has counted twice, or not at all, or bad news without its reason.
TEST(CountReport, ShowsTheNewsOfEachStepAndSaysWhyOfBadOnes) {
  std::ostringstream log;
  LocalGraph graph(log);
  Bus& bus = graph.addNode("tracker");
  CountReport<Totals> report(bus, {{"plots", &Totals::plots}, {"late plots", &Totals::late, "came too late"}});
  report.add({});
  ASSERT_EQ(graph.counters().size(), 2u) << "also what is still 0 is shown";
  report.add({5, 0});
  report.add({7, 2});
  EXPECT_EQ(bus.counter("plots").value(), 7u);
  EXPECT_EQ(bus.counter("late plots").value(), 2u);
  EXPECT_NE(log.str().find("came too late"), std::string::npos);
  report.reset();
  report.add({3, 0});
  EXPECT_EQ(bus.counter("plots").value(), 10u) << "of two runs";
}

}  // namespace
}  // namespace tws_runtime
