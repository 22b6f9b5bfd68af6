#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/counters.h>

#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tws_runtime {

/// The counters of one node.
class CounterSet {
 public:
  using Say = std::function<void(const std::string& line)>;
  using WallClock = std::function<std::chrono::steady_clock::time_point()>;

  /// `say` gets the log lines: a counter's first reason, then at most one every five seconds by `clock`.
  CounterSet(std::string node, Say say, WallClock clock = std::chrono::steady_clock::now);

  /// The counter of that name, made at the first call. The reference stays valid.
  Counter& get(const std::string& name);

  /// In the order in which the counters were made.
  std::vector<CounterReading> readings() const;
  /// How often anything was counted with a reason.
  std::uint64_t badNews() const;

 private:
  class LoggedCounter : public Counter {
   public:
    LoggedCounter(const CounterSet& set, std::string name) : set_(set), name_(std::move(name)) {}
    void add(std::uint64_t n) override { value_ += n; }
    void add(const std::string& reason) override;
    std::uint64_t value() const override { return value_; }
    std::uint64_t reasons() const { return reasons_; }
    const std::string& name() const { return name_; }

   private:
    const CounterSet& set_;
    std::string name_;
    std::uint64_t value_ = 0;
    std::uint64_t reasons_ = 0;
    std::optional<std::chrono::steady_clock::time_point> last_said_;
  };

  std::string node_;
  Say say_;
  WallClock clock_;
  std::deque<LoggedCounter> counters_;
};

}  // namespace tws_runtime
