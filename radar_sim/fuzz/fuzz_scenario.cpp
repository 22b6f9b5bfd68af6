// Scenario files: whatever they hold, a scenario comes of it whose targets can be made, or the line that is wrong.
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fuzzing.h"
#include "scenario.h"

namespace {

/// Those that are quickly made: a file may ask for millions.
bool areFew(const std::vector<radar_sim::RandomGroup>& groups) {
  const auto add = [](double sum, const auto& group) { return sum + static_cast<double>(group.count); };
  return std::accumulate(groups.begin(), groups.end(), 0.0, add) < 1000.0;
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  inputFile().write(input);
  attempt([] {
    const radar_sim::Scenario scenario = radar_sim::loadScenario(inputFile().path());
    if (!(scenario.duration > 0.0 && std::isfinite(scenario.endTime()))) found("a scenario without a duration");
    if (areFew(scenario.groups)) try {
        (void)radar_sim::allTargets(scenario);
      } catch (const std::invalid_argument&) {
        // A name that is used twice.
      }
  });
}
