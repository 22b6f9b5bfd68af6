#include <CLI/CLI.hpp>
#include <iostream>

#include "evaluator.h"
#include "identity_csv.h"
#include "metrics_file.h"
#include "requirements_reader.h"
#include "result_file.h"
#include "series_file.h"
#include "state_csv.h"

#include <tws_runtime/command_line.h>
#include <tws_runtime/parameters.h>

namespace {

using namespace track_evaluation;

struct Options {
  std::string truth, plots, tracks, json, requirements, series, picture;
  std::vector<std::string> monitors;
  std::optional<double> resample;
  EvaluatorParams evaluator;
};

void againstTruth(const Options& options, SeriesFile& files, TrackerScore& score) {
  std::vector<RequirementProfile> profiles;
  if (!options.requirements.empty())
    profiles = readRequirements(tws_runtime::loadParameterFile(options.requirements), options.requirements);
  Evaluator evaluator(options.evaluator, profiles);
  for (const Epoch& epoch : epochsOf(readStateFile(options.truth), readStateFile(options.tracks), options.resample)) {
    evaluator.add(epoch);
    files.add(score.tracker, epoch, evaluator);
  }
  if (evaluator.epochs() == 0) throw std::runtime_error(options.truth + ": no epoch in the evaluated interval");
  score.metrics = evaluator.metrics();
  score.requirements = evaluator.requirements();
}

void byIdentity(const Options& options, SeriesFile& files, TrackerScore& score) {
  IdentityParams params;
  for (const std::string& code : options.monitors)
    params.monitors.insert(static_cast<std::uint32_t>(std::stoul(code, nullptr, 8)));
  IdentityMetrics metrics(params);
  readPlotFile(options.plots, metrics);
  for (const CsvState& row : readStateFile(options.tracks)) {
    if (!row.coasting) metrics.addUpdate(row.time, row.id, row.state.position);
    files.addTrack(score.tracker, row.time, row.id, row.state.position);
  }
  score.identity = metrics.report();
}

RunScore evaluate(const Options& options) {
  const std::vector<std::string> inputs{options.truth, options.plots, options.tracks};
  ResultFile series(options.series, inputs), picture(options.picture, inputs);
  SeriesFile files;
  if (series) files.openSeries(series.stream());
  if (picture) files.openPicture(picture.stream(), 0.0);
  TrackerScore score;
  score.tracker = "tracks";
  const EvaluatorParams& p = options.evaluator;
  MetricList settings{
      {"cutoff_m", p.cutoff}, {"order", p.order}, {"from_s", p.from}, {"initiation_limit_s", p.initiation_limit}};
  if (!options.truth.empty()) againstTruth(options, files, score);
  if (!options.plots.empty()) byIdentity(options, files, score);
  series.finish();
  picture.finish();
  return {options.tracks, options.truth.empty() ? MetricList{} : settings, {score}};
}

void addOptions(CLI::App& app, Options& options) {
  EvaluatorParams& p = options.evaluator;
  app.add_option("--truth", options.truth, "CSV t_s,truth_id,x_m,y_m[,vx_mps,vy_mps]; its times are the epochs");
  app.add_option("--plots", options.plots, "CSV with columns t_s,range_m,az_deg,mode3a: score by identity");
  app.add_option("--tracks", options.tracks,
                 "CSV t_s,track_id,x_m,y_m[,vx_mps,vy_mps][,status] at the times of the truth or of the plots")
      ->required();
  app.add_option("--monitor", options.monitors, "Mode 3/A code of a fixed device; several times for several")
      ->check([](const std::string& code) {
        const bool octal = !code.empty() && code.size() <= 4 && code.find_first_not_of("01234567") == std::string::npos;
        return octal ? std::string() : "'" + code + "' is no code of up to four octal digits";
      });
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
  app.add_option("--series", options.series, "write the metrics of each epoch into this CSV file");
  app.add_option("--picture", options.picture, "write where truths and tracks are into this CSV file");
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("evaluate_csv", [&] {
    Options options;
    CLI::App app("Scores a file of tracks against a file of truth.", "evaluate_csv");
    addOptions(app, options);
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    if (options.truth.empty() && options.plots.empty()) {
      std::cerr << "evaluate_csv: wants --truth or --plots (evaluate_csv --help says more)\n";
      return 2;
    }
    ResultFile json(options.json, {options.truth, options.plots, options.tracks});
    const RunScore score = evaluate(options);
    if (json) writeJson(json.stream(), score);
    json.finish();
    writeTable(std::cout, score);
    return 0;
  });
}
