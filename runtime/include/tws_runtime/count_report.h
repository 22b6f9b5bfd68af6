#pragma once

#include <tws_runtime/bus.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tws_runtime {

/// Shows what a library counts in a plain struct of totals as counters of the Bus.
///
///   CountReport<Counts> report(bus, {{"plots", &Counts::plots},                               // statistics
///                                    {"late plots", &Counts::late, "came after its sector"}}); // bad: with the reason
///   report.add(library.counts());   // after each step
///   report.reset();                 // the library counts anew
template <class Counts>
class CountReport {
 public:
  struct Row {
    std::string name;
    std::uint64_t Counts::*total;
    std::string reason = {};  ///< Empty: statistics, no bad news.
  };

  CountReport(Bus& bus, std::vector<Row> rows) : bus_(bus), rows_(std::move(rows)) {}

  /// `now`: totals since the start or the last reset(); they never go back.
  void add(const Counts& now) {
    for (const Row& row : rows_) {
      const std::uint64_t news = now.*row.total - before_.*row.total;
      if (news == 0 && shown_) continue;
      Counter& counter = bus_.counter(row.name);
      if (row.reason.empty()) counter.add(news);
      for (std::uint64_t n = row.reason.empty() ? 0 : news; n > 0; --n) counter.add(row.reason);
    }
    shown_ = true;
    before_ = now;
  }

  void reset() { before_ = Counts{}; }

 private:
  Bus& bus_;
  std::vector<Row> rows_;
  Counts before_{};
  bool shown_ = false;  // all counters are there, also those at 0
};

}  // namespace tws_runtime
