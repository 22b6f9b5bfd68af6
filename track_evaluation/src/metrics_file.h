#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "metric_list.h"
#include "requirements.h"

namespace track_evaluation {

/// What is known of one tracker in a run.
struct TrackerScore {
  std::string tracker;
  MetricList metrics;   ///< Against truth; empty without truth.
  MetricList identity;  ///< By identity; empty without.
  MetricList timing;    ///< Empty: not measured.
  std::vector<RequirementRow> requirements;
  MetricList correlation = {};  ///< Of a correlator; empty for any other tracker.
};

/// What a run is scored by, and the scores.
struct RunScore {
  std::string input;    ///< File or topic it was read from.
  MetricList settings;  ///< Cut-off and so on, which the values depend on.
  std::vector<TrackerScore> trackers;
};

/// As JSON with the keys that doc/metrics.md lists; NaN and infinities are null. The same score gives the same bytes.
void writeJson(std::ostream& out, const RunScore& score);
/// As a table for people, one column a tracker.
void writeTable(std::ostream& out, const RunScore& score);
/// A number with as many digits as people read: 1234, 0.973, 12.3; "-" for NaN.
std::string inShort(double value);

}  // namespace track_evaluation
