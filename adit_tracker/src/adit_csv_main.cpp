// Plots in a CSV file → tracks in a CSV file, without ROS. See README.md.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>

#include <tws_core/units.h>

#include "adit_params_reader.h"
#include "plot_csv.h"
#include "sector_feed.h"
#include "track_csv.h"

namespace adit_tracker {
namespace {

struct Options {
  std::string detections, tracks, params = "default";
  std::vector<std::string> radars;
  std::uint32_t capacity = 0;  // 0: the parameter file's
  double epochs = 0.0;
};

/// ID[:PERIOD_S[:PHASE_DEG]]
struct RadarSpec {
  std::string id;
  double period = 0.0;                                      // 0: to be found
  double phase = std::numeric_limits<double>::quiet_NaN();  // NaN: to be found
};

RadarSpec parseRadar(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  const auto refuse = [&] { throw std::runtime_error("--radar " + text + ": expected ID[:PERIOD_S[:PHASE_DEG]]"); };
  const auto number = [&](const std::string& part) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    if (part.empty() || *end != '\0' || !std::isfinite(value)) refuse();
    return value;
  };
  if (parts.empty() || parts.size() > 3 || parts[0].empty()) refuse();
  RadarSpec spec;
  spec.id = parts[0];
  if (parts.size() > 1) spec.period = number(parts[1]);
  if (parts.size() > 1 && (spec.period < 0.5 || spec.period > 120.0)) {
    throw std::runtime_error("--radar " + text + ": the period is not in [0.5, 120] s");
  }
  if (parts.size() > 2) spec.phase = tws::radians(number(parts[2]));
  return spec;
}

tws::Rotation rotationOf(const RadarSpec& spec, const std::vector<tws::Plot>& plots) {
  if (!std::isnan(spec.phase)) return tws::Rotation::uniform(spec.period, spec.phase);
  std::vector<tws::TimedAzimuth> points;
  points.reserve(plots.size());
  for (const tws::Plot& plot : plots) points.push_back({plot.time, plot.azimuth});
  try {
    return spec.period > 0.0 ? tws::Rotation::fromPlots(points, spec.period) : tws::Rotation::fromPlots(points);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("radar " + spec.id + ": " + error.what() + "; give --radar " + spec.id +
                             ":PERIOD_S:PHASE_DEG");
  }
}

/// The radars that were named, else all of the file.
std::vector<RadarSpec> radarsOf(const Options& options, PlotTable& table) {
  std::vector<RadarSpec> specs;
  for (const std::string& text : options.radars) specs.push_back(parseRadar(text));
  if (specs.empty()) {
    for (const auto& entry : table.radars) specs.push_back(parseRadar(entry.first));
  }
  for (const auto& [radar, plots] : table.radars) {
    const bool known =
        std::any_of(specs.begin(), specs.end(), [&, id = radar](const RadarSpec& s) { return s.id == id; });
    if (known) continue;
    std::cerr << options.detections << ": " << plots.size() << " plots of radar " << radar
              << ", which no --radar names, are left out\n";
    table.refused += plots.size();
  }
  return specs;
}

class Run {
 public:
  Run(const Options& options, PlotTable& table, std::ostream& output)
      : options_(options),
        csv_(output),
        adit_(paramsOf(options, table), [this](const SectorReport& r) { onSector(r); }) {}

  void go() {
    if (options_.epochs > 0.0) epoch_ = std::ceil(first_time_ / options_.epochs);
    while (SectorFeed* feed = earliest()) {
      pictures(*feed->nextTime());
      const auto radar = static_cast<std::size_t>(feed - feeds_.data());
      adit_.add(radar, feed->take());
    }
    adit_.finish();
    if (options_.epochs > 0.0) pictures(last_time_ + 1e-6);
  }

  void summary(const PlotTable& table) const {
    const AditCounts& n = adit_.counts();
    std::cerr << "plots used          " << n.plots << "\nlines refused       " << table.refused
              << "\ntracks started      " << n.tracks_started << "\ntracks become firm  " << n.tracks_firm
              << "\ntracks dropped      " << n.tracks_dropped << "\ntracks refused      " << n.refused_tracks
              << " (capacity " << adit_.params().capacity << ")\nplots into clutter  " << absorbed() << '\n';
    for (std::size_t i = 0; i < feeds_.size(); ++i) {
      std::fprintf(
          stderr, "radar %-13s period %.4f s, range sigma %.0f m, azimuth sigma %.3f deg, %.1f false plots a scan\n",
          adit_.params().radars[i].name.c_str(), adit_.params().radars[i].period, adit_.quality(i).rangeSigma(),
          tws::degrees(adit_.quality(i).azimuthSigma()), adit_.quality(i).falsePlots());
    }
  }

 private:
  AditParams paramsOf(const Options& options, PlotTable& table) {
    AditParams params = loadAditParams(options.params);
    if (options.capacity > 0) params.capacity = options.capacity;
    const std::map<std::string, RadarParams> given = byName(params.radars);
    params.radars.clear();
    for (const RadarSpec& spec : radarsOf(options, table)) {
      auto& plots = table.radars[spec.id];
      if (plots.empty()) throw std::runtime_error(options.detections + ": there is no plot of radar " + spec.id);
      first_time_ = std::min(first_time_, plots.front().time);
      last_time_ = std::max(last_time_, plots.back().time);
      feeds_.emplace_back(plots, rotationOf(spec, plots));
      RadarParams radar = given.count(spec.id) > 0 ? given.at(spec.id) : RadarParams{};
      radar.name = spec.id;
      radar.period = rotationOf(spec, plots).period();
      params.radars.push_back(radar);
    }
    return params;
  }

  static std::map<std::string, RadarParams> byName(const std::vector<RadarParams>& radars) {
    std::map<std::string, RadarParams> result;
    for (const RadarParams& radar : radars) result[radar.name] = radar;
    return result;
  }

  std::uint64_t absorbed() const {
    std::uint64_t sum = 0;
    for (const ClutterMap& map : adit_.clutter()) sum += map.absorbed();
    return sum;
  }

  SectorFeed* earliest() {
    SectorFeed* best = nullptr;
    for (SectorFeed& feed : feeds_) {
      if (feed.nextTime() && (best == nullptr || *feed.nextTime() < *best->nextTime())) best = &feed;
    }
    return best;
  }

  /// The pictures of all epochs before `time`: what closes at or after an epoch may hold plots from after it.
  void pictures(double time) {
    if (options_.epochs <= 0.0) return;
    for (; options_.epochs * epoch_ < time; ++epoch_) {
      if (options_.epochs * epoch_ <= last_time_) csv_.picture(adit_, options_.epochs * epoch_);
    }
  }

  void onSector(const SectorReport& report) {
    if (options_.epochs <= 0.0) csv_.report(adit_, report);
  }

  Options options_;
  std::vector<SectorFeed> feeds_;
  double first_time_ = std::numeric_limits<double>::infinity();
  double last_time_ = -std::numeric_limits<double>::infinity();
  double epoch_ = 0.0;  // of the next picture, in units of the distance between them
  TrackCsv csv_;
  Adit adit_;
};

void run(const Options& options) {
  std::ifstream input(options.detections);
  if (!input) throw std::runtime_error(options.detections + ": cannot be read");
  PlotTable table = readPlots(input, options.detections);
  for (const std::string& complaint : table.complaints) std::cerr << complaint << '\n';
  if (table.plots == 0) throw std::runtime_error(options.detections + ": holds no usable plot");
  if (std::filesystem::exists(options.tracks) && std::filesystem::equivalent(options.tracks, options.detections)) {
    throw std::runtime_error(options.tracks + ": is the file of plots itself");
  }
  std::ofstream output(options.tracks);
  if (!output) throw std::runtime_error(options.tracks + ": cannot be written");
  Run tracker(options, table, output);
  tracker.go();
  output.flush();
  if (!output) throw std::runtime_error(options.tracks + ": writing failed");
  tracker.summary(table);
}

}  // namespace
}  // namespace adit_tracker

int main(int argc, char** argv) {
  adit_tracker::Options options;
  CLI::App app{"Tracks the plots of a CSV file (t_s,radar,scan,range_m,az_deg) by the ADIT tracker."};
  app.add_option("--detections", options.detections, "CSV file of plots")->required();
  app.add_option("--tracks", options.tracks, "CSV file to be written")->required();
  app.add_option("--radar", options.radars,
                 "ID[:PERIOD_S[:PHASE_DEG]], for each radar; what is left out is found from the plots");
  app.add_option("--params", options.params, "parameter set (default, nrl7952) or YAML file");
  app.add_option("--capacity", options.capacity, "track numbers; 100000 unless said here or in a parameter file")
      ->check(CLI::Range(2U, 1000001U));
  app.add_option("--epochs", options.epochs, "write the picture at each multiple of so many seconds")
      ->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const bool named = options.params == "default" || options.params == "nrl7952";
    if (options.capacity == 0 && named) options.capacity = 100000;
    adit_tracker::run(options);
  } catch (const std::exception& error) {
    std::cerr << "adit_csv: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
