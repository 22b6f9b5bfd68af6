#pragma once

#include <tws_runtime/bus.h>

#include <string>
#include <vector>

#include "evaluator.h"
#include "identity.h"
#include "truth_messages.h"

namespace track_evaluation {

/// Of the evaluation node; config/evaluation.yaml explains each.
struct EvaluationParams {
  std::vector<std::string> trackers, correlators, radars, secondary_radars, array_radars;
  EvaluatorParams evaluator;  ///< `from` counts from the first epoch.
  TruthFilter filter;
  IdentityParams identity;
  std::vector<RequirementProfile> profiles;
  double longest_silence = 30.0;  ///< [s]
  double skew_limit = 5.0;        ///< [s]
  double restart_limit = 5.0;     ///< [s]
  double period = 5.0;            ///< Of the summary [s].
};

/// Throws tws_runtime::ParameterError.
EvaluationParams readEvaluationParams(const tws_runtime::Bus& bus);

/// What a score depends on, for the file of metrics.
MetricList settingsOf(const EvaluationParams& params);

}  // namespace track_evaluation
