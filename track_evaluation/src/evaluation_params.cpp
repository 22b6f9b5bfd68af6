#include "evaluation_params.h"

#include <tws_runtime/parameters.h>
#include <tws_runtime/track_writer.h>

#include <algorithm>
#include <iterator>

#include "requirements_reader.h"

namespace track_evaluation {
namespace {

using tws_runtime::ParameterReader;

std::vector<std::uint8_t> readKinds(ParameterReader& reader, const std::string& key,
                                    const std::vector<std::uint8_t>& usual) {
  static const std::vector<std::string> kNames{"aircraft", "ship", "clutter", "slow_mover"};  // as in TruthTarget
  std::vector<std::string> words;
  std::transform(usual.begin(), usual.end(), std::back_inserter(words), [](auto kind) { return kNames.at(kind); });
  reader.texts(key, words);
  std::vector<std::uint8_t> kinds;
  for (const std::string& word : words) {
    const auto found = std::find(kNames.begin(), kNames.end(), word);
    if (found == kNames.end()) reader.fail(key, "'" + word + "' is none of aircraft, ship, clutter, slow_mover");
    kinds.push_back(static_cast<std::uint8_t>(found - kNames.begin()));
  }
  return kinds;
}

void readMonitors(ParameterReader& reader, IdentityParams& identity) {
  std::vector<std::string> codes;
  reader.texts("monitor_codes", codes);
  for (const std::string& code : codes) {
    if (code.empty() || code.size() > 4 || code.find_first_not_of("01234567") != std::string::npos)
      reader.fail("monitor_codes", "'" + code + "' is no code of up to four octal digits");
    identity.monitors.insert(static_cast<std::uint32_t>(std::stoul(code, nullptr, 8)));
  }
}

}  // namespace

EvaluationParams readEvaluationParams(const tws_runtime::Bus& bus) {
  ParameterReader reader(bus.parameters(), bus.name());
  EvaluationParams params;
  params.evaluator.cutoff = 3000.0;
  params.evaluator.from = 30.0;
  reader.texts("trackers", params.trackers);
  reader.texts("correlators", params.correlators);
  for (const std::string& name : params.correlators)
    if (std::count(params.trackers.begin(), params.trackers.end(), name) > 0)
      reader.fail("correlators", "'" + name + "' is one of the trackers");
  reader.texts("radars", params.radars);
  reader.texts("secondary_radars", params.secondary_radars);
  reader.texts("array_radars", params.array_radars);
  reader.number("cutoff_m", params.evaluator.cutoff, 1e-3, 1e7);
  reader.number("order", params.evaluator.order, 1.0, 100.0);
  reader.number("from_s", params.evaluator.from, 0.0, 1e6);
  reader.number("initiation_limit_s", params.evaluator.initiation_limit, 0.0, 1e6);
  reader.number("nees_age_s", params.evaluator.nees_age, 0.0, 1e3);
  reader.number("least_detection_probability", params.filter.least_detection_probability, 0.0, 1.0);
  params.filter.required_kinds = readKinds(reader, "required_kinds", params.filter.required_kinds);
  params.filter.tolerated_kinds = readKinds(reader, "tolerated_kinds", params.filter.tolerated_kinds);
  reader.number("longest_silence_s", params.longest_silence, 0.1, 1e5);
  reader.number("skew_limit_s", params.skew_limit, 0.0, 1e3);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.number("period_s", params.period, 0.1, 3600.0);
  reader.number("long_gap_s", params.identity.long_gap, 0.1, 1e5);
  readMonitors(reader, params.identity);
  if (reader.has("profiles")) params.profiles = readProfiles(reader);
  params.filter.sea = tws_runtime::readOrigin(reader);
  reader.done();
  return params;
}

MetricList settingsOf(const EvaluationParams& params) {
  return {{"cutoff_m", params.evaluator.cutoff},
          {"order", params.evaluator.order},
          {"from_s", params.evaluator.from},
          {"initiation_limit_s", params.evaluator.initiation_limit},
          {"least_detection_probability", params.filter.least_detection_probability},
          {"longest_silence_s", params.longest_silence}};
}

}  // namespace track_evaluation
