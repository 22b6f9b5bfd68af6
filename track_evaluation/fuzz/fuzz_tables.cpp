// The tables that are evaluated: truth, tracks, and plots with identities.
#include <cmath>
#include <sstream>

#include "fuzzing.h"
#include "identity_csv.h"
#include "state_csv.h"

namespace {

const std::string kName = "input";

std::vector<track_evaluation::CsvState> readStates(const std::string& text) {
  std::istringstream input(text);
  std::vector<track_evaluation::CsvState> states = track_evaluation::readStates(input, kName);
  for (const auto& state : states)
    if (!std::isfinite(state.time) || !state.state.position.allFinite()) fuzzing::found("a state at no time or place");
  return states;
}

void readPlots(const std::string& text) {
  std::istringstream input(text);
  track_evaluation::IdentityMetrics metrics;
  track_evaluation::readPlots(input, kName, metrics);
  metrics.settle(1e9);
  (void)metrics.report();
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  const std::string text(input);
  std::vector<track_evaluation::CsvState> states;
  readOrComplain(kName, [&] { states = readStates(text); });
  readOrComplain("", [&] { (void)track_evaluation::epochsOf(states, states, std::nullopt); });
  readOrComplain("", [&] { (void)track_evaluation::epochsOf(states, states, 10.0); });
  readOrComplain(kName, [&] { readPlots(text); });
}
