#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace tws_launch {

/// Who speaks all the time, and for how long somebody has not.
class Heartbeats {
 public:
  /// `name` is to speak from `now` on [s of wall time, as all here].
  void expect(const std::string& name, double now) { speakers_[name].last = now; }
  /// It did.
  void heard(const std::string& name, double now);

  /// "adit for 12 s, sps39 for 31 s": who has said nothing for kShortest and for five times as long as it usually
  /// takes; empty: nobody.
  std::string silent(double now) const;

  static constexpr double kShortest = 10.0;

 private:
  struct Speaker {
    double last = 0.0;   ///< Of the last word, or the time from which one is expected.
    double first = 0.0;  ///< Of the first one.
    std::uint64_t words = 0;
    double usualGap() const { return words > 1 ? (last - first) / static_cast<double>(words - 1) : 0.0; }
  };
  std::map<std::string, Speaker> speakers_;
};

}  // namespace tws_launch
