#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "command_line.h"
#include "evaluator.h"
#include "metrics_file.h"
#include "requirements_reader.h"
#include "state_csv.h"

#include <tws_runtime/parameters.h>

namespace {

using namespace track_evaluation;

struct Options {
  std::string truth, tracks, json, requirements;
  std::optional<double> resample;
  EvaluatorParams evaluator;
};

RunScore evaluate(const Options& options) {
  std::vector<RequirementProfile> profiles;
  if (!options.requirements.empty())
    profiles = readRequirements(tws_runtime::loadParameterFile(options.requirements), options.requirements);
  Evaluator evaluator(options.evaluator, profiles);
  for (const Epoch& epoch : epochsOf(readStateFile(options.truth), readStateFile(options.tracks), options.resample))
    evaluator.add(epoch);
  if (evaluator.epochs() == 0) throw std::runtime_error(options.truth + ": no epoch in the evaluated interval");
  const EvaluatorParams& p = options.evaluator;
  return {options.tracks,
          {{"cutoff_m", p.cutoff}, {"order", p.order}, {"from_s", p.from}, {"initiation_limit_s", p.initiation_limit}},
          {{"tracks", evaluator.metrics(), {}, {}, evaluator.requirements()}}};
}

void addOptions(CLI::App& app, Options& options) {
  EvaluatorParams& p = options.evaluator;
  app.add_option("--truth", options.truth, "CSV t_s,truth_id,x_m,y_m[,vx_mps,vy_mps]; its times are the epochs")
      ->required();
  app.add_option("--tracks", options.tracks, "CSV t_s,track_id,x_m,y_m[,vx_mps,vy_mps] at these times")->required();
  app.add_option("--resample", options.resample, "take tracks at any time, at most so old [s], and extrapolate them")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--cutoff", p.cutoff, "a track further from a truth does not follow it [m]; 1000")
      ->check(CLI::Range(1e-3, 1e7));
  app.add_option("--order", p.order, "of OSPA and GOSPA; 2")->check(CLI::Range(1.0, 100.0));
  app.add_option("--from", p.from, "evaluate from this time on [s]; 60")->check(CLI::Range(-1e10, 1e10));
  app.add_option("--to", p.to, "and up to this one [s]; the end")->check(CLI::Range(-1e10, 1e10));
  app.add_option("--initiation-limit", p.initiation_limit, "for initiated_in_time [s]; 40")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--requirements", options.requirements, "YAML file with limits; none");
  app.add_option("--json", options.json, "write the metrics into this file, too");
}

}  // namespace

int main(int argc, char** argv) {
  return guarded("evaluate_csv", [&] {
    Options options;
    CLI::App app("Scores a file of tracks against a file of truth.", "evaluate_csv");
    addOptions(app, options);
    if (const auto status = parse(app, argc, argv)) return *status;
    const RunScore score = evaluate(options);
    if (!options.json.empty()) {
      std::ofstream file(options.json);
      writeJson(file, score);
      if (!file.flush()) throw std::runtime_error(options.json + ": cannot be written");
    }
    writeTable(std::cout, score);
    return 0;
  });
}
