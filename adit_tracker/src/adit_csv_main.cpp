// Plots in a CSV file → tracks in a CSV file, without ROS. See README.md.
#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <tws_core/csv_table.h>
#include <tws_core/output_file.h>
#include <tws_core/units.h>

#include "adit_params_reader.h"
#include "clutter/clutter_csv.h"
#include "io/beam_times.h"
#include "io/fate_csv.h"
#include "io/moving_feed.h"
#include "io/own_ship_csv.h"
#include "io/plot_csv.h"
#include "io/radar_spec.h"
#include "io/registration_csv.h"
#include "io/registration_text.h"
#include "io/sector_feed.h"
#include "io/snapshot_feed.h"
#include "io/track_csv.h"

namespace adit_tracker {
namespace {

struct Options {
  std::string detections, tracks, params = "default";
  std::vector<RadarSpec> radars;
  std::uint32_t capacity = 0;  // 0: the parameter file's
  double epochs = 0.0;
  bool covariance = false;
  std::string clutter_map, save_clutter_map, plots, own_ship, registration, save_registration;  // files; empty: none
};

/// The radars that were named, else all of the file.
std::vector<RadarSpec> radarsOf(const Options& options, PlotTable& table) {
  std::vector<RadarSpec> specs = options.radars;
  if (specs.empty()) {
    for (const auto& entry : table.radars) specs.emplace_back().id = entry.first;
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

AditParams baseParams(const Options& options) {
  const bool named = isNamedSet(options.params);
  if (!named && !std::filesystem::exists(options.params)) {
    throw std::runtime_error("--params " + options.params + ": no file of that name, nor a set (" +
                             AditParams::setNames() + ")");
  }
  AditParams params = loadAditParams(options.params);
  if (named) params.capacity = 100000;
  if (options.capacity > 0) params.capacity = options.capacity;
  return params;
}

/// All that the tracker gets, found and checked before anything is written.
struct Input {
  AditParams params;
  SavedMaps maps;
  std::vector<std::unique_ptr<PlotFeed>> feeds;
  std::unique_ptr<OwnShipTable> own_ship;  // none: the radars stand
  std::vector<MovingFeed> moving;          // as many as feeds, on own ship
  bool has_elevations = false;
  bool wants_covariance = false;
  double first_time = std::numeric_limits<double>::infinity();
  double last_time = -std::numeric_limits<double>::infinity();
};

RadarParams paramsOf(const std::string& id, const std::vector<RadarParams>& given) {
  for (const RadarParams& radar : given) {
    if (radar.name == id) return radar;
  }
  RadarParams radar;
  radar.name = id;
  return radar;
}

/// Own ship's track; its findings are said.
std::unique_ptr<OwnShipTable> ownShipOf(const std::string& file) {
  if (file.empty()) return nullptr;
  auto table = std::make_unique<OwnShipTable>(readOwnShip(*tws::openText(file), file));
  for (const std::string& complaint : table->complaints) std::cerr << complaint << '\n';
  if (table->has_headings) std::cerr << file << ": has headings: azimuths are taken to be told from the bow\n";
  if (table->origin) {
    std::fprintf(stderr, "%s: positions are east and north of latitude %.7f deg, longitude %.7f deg\n", file.c_str(),
                 tws::degrees(table->origin->latitude), tws::degrees(table->origin->longitude));
  }
  return table;
}

/// Azimuths told from the bow become those against north, where own ship's heading is known.
std::vector<tws::Plot> againstNorth(std::vector<tws::Plot> plots, const OwnShip& ship) {
  for (tws::Plot& plot : plots)
    if (const auto pose = ship.at(plot.time)) plot.azimuth = tws::wrapTwoPi(plot.azimuth + pose->heading);
  return plots;
}

/// The radar's sectors; mends its plots' times where the beam shows how. Sets the period of its scans [s].
std::unique_ptr<PlotFeed> feedOf(const RadarSpec& spec, std::vector<tws::Plot>& plots, double& period) {
  if (const auto between = snapshotPeriod(plots)) {
    std::fprintf(stderr, "radar %s: all plots of a scan have one time, each %g s: they are taken for snapshots\n",
                 spec.id.c_str(), *between);
    period = *between;
    return std::make_unique<SnapshotFeed>(plots, period);
  }
  const tws::Rotation rotation = learnBeam(
      spec, plots, [&](const std::string& finding) { std::cerr << "radar " << spec.id << ": " << finding << '\n'; });
  period = rotation.period();
  return std::make_unique<SectorFeed>(plots, rotation);
}

/// The same of a radar on own ship. A ship that turns hides that plots are snapshots.
void addMovingFeed(Input& input, const RadarSpec& spec, std::vector<tws::Plot>& plots, double& period) {
  const OwnShipTable& own = *input.own_ship;
  std::vector<tws::Plot> north = own.has_headings ? againstNorth(plots, own.ship) : std::vector<tws::Plot>();
  const bool snapshots = own.has_headings && snapshotPeriod(north);
  input.feeds.push_back(feedOf(spec, snapshots ? north : plots, period));
  const AzimuthsFrom from = !own.has_headings ? AzimuthsFrom::kNorth
                            : snapshots       ? AzimuthsFrom::kHeadings
                                              : AzimuthsFrom::kBow;
  input.moving.emplace_back(*input.feeds.back(), own.ship, from);
}

Input inputOf(const Options& options, PlotTable& table) {
  Input input;
  input.params = baseParams(options);
  input.own_ship = ownShipOf(options.own_ship);
  input.has_elevations = table.has_elevations;
  input.wants_covariance = options.covariance;
  const std::vector<RadarParams> given = std::exchange(input.params.radars, {});
  for (const RadarSpec& spec : radarsOf(options, table)) {
    auto& plots = table.radars[spec.id];
    if (plots.empty()) throw std::runtime_error(options.detections + ": there is no plot of radar " + spec.id);
    input.params.radars.push_back(paramsOf(spec.id, given));
    double& period = input.params.radars.back().period;
    if (input.own_ship)
      addMovingFeed(input, spec, plots, period);
    else
      input.feeds.push_back(feedOf(spec, plots, period));
    input.first_time = std::min(input.first_time, plots.front().time);
    input.last_time = std::max(input.last_time, plots.back().time);
  }
  check(input.params);
  const auto usesRates = [](const RadarParams& radar) { return radar.range_rate_sigma > 0.0; };
  const auto& radars = input.params.radars;
  if (table.has_range_rates && std::none_of(radars.begin(), radars.end(), usesRates)) {
    std::cerr << options.detections
              << ": range_rate_mps is not used: no radar has range_rate_sigma_mps (--params with a file)\n";
  }
  if (input.own_ship && !joinsSites(input.params))
    throw std::runtime_error("--own-ship needs the turning filter, statistical gates and a clutter map for each radar");
  if (!options.clutter_map.empty()) input.maps = loadClutterFile(options.clutter_map, ClutterLimits(input.params));
  return input;
}

class Run {
 public:
  Run(double epochs, Input input, std::ostream& output)
      : epochs_(epochs),
        input_(std::move(input)),
        csv_(output, input_.has_elevations, input_.wants_covariance),
        adit_(input_.params, [this](const SectorReport& r) { onSector(r); }) {}

  void go() {
    adit_.manual().load(input_.maps);
    if (epochs_ > 0.0) epoch_ = std::ceil(input_.first_time / epochs_);
    while (const auto radar = earliest()) {
      pictures(*input_.feeds[*radar]->nextTime());
      take(*radar);
    }
    adit_.finish();
    if (epochs_ > 0.0) pictures(std::numeric_limits<double>::infinity());
  }

  /// Writes what becomes of each plot. `output` is to outlive it.
  void tellPlots(std::ostream& output) {
    fates_.emplace(output);
    adit_.tellPlots([this](const SectorFates& sector) { fates_->add(adit_, sector); });
  }

  /// Throws std::runtime_error when no plot comes while own ship's place is known.
  void checkOwnShip(const Options& options) const {
    if (!input_.own_ship || adit_.counts().plots > 0) return;
    char text[160];
    std::snprintf(text, sizeof text, ": own ship's place is known from %.3f s to %.3f s, and no plot of ",
                  input_.own_ship->ship.first(), input_.own_ship->ship.latest());
    throw std::runtime_error(options.own_ship + text + options.detections +
                             " comes within that; the times of both files must be of one clock");
  }

  bool hasFirmTracks() const { return adit_.counts().tracks_firm > 0; }
  std::uint64_t absorbed() const { return adit_.clutter().absorbed(); }
  SavedMaps maps() const { return adit_.maps(); }
  Adit& adit() { return adit_; }

  void summary(const PlotTable& table) const {
    const AditCounts& n = adit_.counts();
    std::cerr << "plots used          " << n.plots << "\nlines refused       " << table.refused
              << "\ntracks started      " << n.tracks_started << "\ntracks become firm  " << n.tracks_firm
              << "\ntracks stitched     " << n.stitched << "\ntracks dropped      " << n.tracks_dropped
              << "\ntracks refused      " << n.refused_tracks << " (capacity " << adit_.params().capacity
              << ")\nplots into clutter  " << absorbed() << '\n';
    if (input_.own_ship) sumUpOwnShip();
    for (std::size_t i = 0; i < input_.feeds.size(); ++i) {
      std::fprintf(stderr,
                   "radar %-13s period %.4f s, range sigma %.0f m, azimuth sigma %.3f deg, %.1f false plots a scan\n",
                   adit_.params().radars[i].name.c_str(), adit_.params().radars[i].period,
                   adit_.radars().quality(i).rangeSigma(), tws::degrees(adit_.radars().quality(i).azimuthSigma()),
                   adit_.radars().quality(i).falsePlotMap().perScan());
      const tws::RegistrationReport& registration = adit_.registration().reports()[i];
      if (registration.pairings > 0) std::fprintf(stderr, "  registration      %s\n", inWords(registration).c_str());
    }
  }

 private:
  void take(std::size_t radar) {
    if (input_.moving.empty()) return addAndProcess(adit_, radar, input_.feeds[radar]->take());
    for (MovingFeed::Sector& next : input_.moving[radar].take())
      addAndProcess(adit_, radar, std::move(next.sector), next.ship);
  }

  void sumUpOwnShip() const {
    std::size_t sectors = 0, plots = 0;
    for (const MovingFeed& feed : input_.moving) sectors += feed.lostSectors(), plots += feed.lostPlots();
    std::cerr << "own ship refused    " << input_.own_ship->refused << " lines\nown ship unknown    in " << sectors
              << " sectors, with " << plots << " plots\n";
  }

  /// The radar whose sector closes first; nothing: there are no more.
  std::optional<std::size_t> earliest() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < input_.feeds.size(); ++i) {
      const auto time = input_.feeds[i]->nextTime();
      if (time && (!best || *time < *input_.feeds[*best]->nextTime())) best = i;
    }
    return best;
  }

  /// The one that ends what the plots tell: the first at or after the last plot, if it comes within a scan of it.
  double lastEpoch() const {
    double period = 0.0;
    for (const RadarParams& radar : input_.params.radars) period = std::max(period, radar.period);
    const double after = std::ceil(input_.last_time / epochs_);
    return epochs_ * after - input_.last_time <= period ? after : after - 1.0;
  }

  /// The pictures of all epochs before `time`: what closes at or after an epoch may hold plots from after it.
  void pictures(double time) {
    if (epochs_ <= 0.0) return;
    const double last = lastEpoch();
    for (; epochs_ * epoch_ < time; ++epoch_) {
      if (epoch_ > last) return;
      csv_.picture(adit_, epochs_ * epoch_);
    }
  }

  void onSector(const SectorReport& report) {
    if (epochs_ <= 0.0) csv_.report(adit_, report);
  }

  double epochs_;  // 0: none
  Input input_;
  double epoch_ = 0.0;  // of the next picture, in units of the distance between them
  TrackCsv csv_;
  std::optional<FateCsv> fates_;
  Adit adit_;
};

void run(const Options& options) {
  PlotTable table = readPlots(*tws::openText(options.detections), options.detections);
  for (const std::string& complaint : table.complaints) std::cerr << complaint << '\n';
  if (table.midnights > 0)
    std::cerr << options.detections << ": times of day pass midnight " << table.midnights
              << (table.midnights == 1 ? " time" : " times") << " and are continued\n";
  if (table.plots == 0) throw std::runtime_error(options.detections + ": holds no usable plot");
  Input found = inputOf(options, table);
  const std::vector<std::string> inputs{options.detections, options.clutter_map, options.params, options.own_ship,
                                        options.registration};
  if (!options.save_clutter_map.empty()) tws::checkOutputPath(options.save_clutter_map, inputs);
  if (!options.save_registration.empty()) tws::checkOutputPath(options.save_registration, inputs);
  tws::OutputFile output(options.tracks, inputs);
  std::optional<tws::OutputFile> plots;
  if (!options.plots.empty()) plots.emplace(options.plots, inputs);
  Run tracker(options.epochs, std::move(found), output.stream());
  if (plots) tracker.tellPlots(plots->stream());
  if (!options.registration.empty())
    readRegistration(*tws::openText(options.registration), options.registration, tracker.adit());
  tracker.go();
  tracker.checkOwnShip(options);
  output.finish();
  if (plots) plots->finish();
  if (!options.save_clutter_map.empty()) saveClutterFile(options.save_clutter_map, tracker.maps());
  if (!options.save_registration.empty()) saveRegistrationFile(options.save_registration, tracker.adit());
  tracker.summary(table);
  // Who asks for clutter may have nothing else.
  const bool clutter = !(options.clutter_map + options.save_clutter_map).empty() && tracker.absorbed() > 0;
  if (!tracker.hasFirmTracks() && !clutter)
    throw std::runtime_error(options.detections + ": nothing was tracked: no track of " + std::to_string(table.plots) +
                             " plots became firm; check the periods above (--radar ID:PERIOD_S:PHASE_DEG), or give "
                             "more scans");
}

/// Empty: seconds between two pictures.
std::string epochsProblem(const std::string& text) {
  double value = 0.0;
  const bool good = CLI::detail::lexical_cast(text, value) && value >= 0.001 && value <= 1e6;
  return good ? "" : "wants a number from 0.001 to 1000000, not " + text;
}

/// Throws std::invalid_argument when two options name one file.
void checkOutputs(const std::vector<std::pair<std::string, std::string>>& outputs) {
  std::map<std::string, std::string> named;  // by whole path
  for (const auto& [option, path] : outputs) {
    if (path.empty()) continue;
    const auto [other, is_new] = named.try_emplace(std::filesystem::weakly_canonical(path).string(), option);
    if (!is_new) throw std::invalid_argument(other->second + " and " + option + " name the same file");
  }
}

/// Exit status when there is nothing to run: 0 after --help, 2 after bad usage, said in one line.
std::optional<int> parse(Options& options, int argc, char** argv) {
  CLI::App app("Tracks the plots of a CSV file (columns t_s,radar,range_m,az_deg) by the ADIT tracker.", "adit_csv");
  std::vector<std::string> radars;
  app.add_option("--detections", options.detections, "CSV file of plots")->required();
  app.add_option("--tracks", options.tracks, "CSV file to be written")->required();
  app.add_option("--radar", radars,
                 "ID[:PERIOD_S[:PHASE_DEG]], for each radar; what is left out is found from the plots");
  app.add_option("--params", options.params, "parameter set (" + AditParams::setNames() + ") or YAML file");
  app.add_option("--capacity", options.capacity, "track numbers; 100000 unless said here or in a parameter file")
      ->check(CLI::Range(2U, 1000001U));
  app.add_option("--epochs", options.epochs, "write the picture at each multiple of so many seconds")
      ->check(epochsProblem);
  app.add_flag("--covariance", options.covariance, "write the covariance of position and velocity, too");
  app.add_option("--plots", options.plots,
                 "write what became of each plot, and which tracks wanted it, into this file");
  app.add_option(
      "--own-ship", options.own_ship,
      "CSV file of where the radars' ship was: t_s, x_m and y_m or lat_deg and lon_deg, and heading_deg where "
      "azimuths are told from the bow");
  app.add_option("--clutter-map", options.clutter_map,
                 "clutter, false plots and cover that are known from the start: a file as saved");
  app.add_option("--save-clutter-map", options.save_clutter_map,
                 "write what is known of them at the end into this file");
  app.add_option("--registration", options.registration,
                 "radars' errors of registration that are known from the start: a file as saved");
  app.add_option("--save-registration", options.save_registration,
                 "write what is known of them at the end into this file");
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return std::string("adit_csv: ") + error.what() + " (adit_csv --help says more)\n";
  });
  try {
    app.parse(argc, argv);
    options.radars = parseRadars(radars);
    if (!options.own_ship.empty() && !(options.clutter_map + options.save_clutter_map).empty())
      throw std::invalid_argument("a clutter map is of one place: not with --own-ship");
    checkOutputs({{"--tracks", options.tracks},
                  {"--plots", options.plots},
                  {"--save-clutter-map", options.save_clutter_map},
                  {"--save-registration", options.save_registration}});
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "adit_csv: " << error.what() << '\n';
    return 2;
  }
  return std::nullopt;
}

}  // namespace
}  // namespace adit_tracker

int main(int argc, char** argv) {
  adit_tracker::Options options;
  if (const auto status = adit_tracker::parse(options, argc, argv)) return *status;
  return tws_runtime::guarded("adit_csv", [&] {
    adit_tracker::run(options);
    return 0;
  });
}
