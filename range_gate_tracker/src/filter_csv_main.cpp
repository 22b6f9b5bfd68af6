#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <tws_core/axis_filter.h>

namespace {

struct Options {
  tws::AxisFilterParams filter;
  tws::AxisNoise noise;
  std::string in, out;
};

/// One measurement: its series, time [s] and measured position.
struct Row {
  std::string series;
  double time, measured;
};

Row rowOf(const std::string& line, const std::string& where) {
  std::istringstream words(line);
  Row row{};
  char comma = ' ';
  if (!std::getline(words, row.series, ',') || !(words >> row.time >> comma >> row.measured) || comma != ',')
    throw std::runtime_error(where + ": expected series,t_s,measured, not '" + line + "'");
  return row;
}

void print(std::ostream& out, const Row& row, const tws::AxisMotion& motion, double predicted) {
  out << row.series << ',' << row.time << ',' << motion.position << ',' << motion.velocity << ',' << motion.acceleration
      << ',' << predicted << '\n';
}

void run(const Options& options) {
  const tws::AxisFilter filter(options.filter);
  std::ifstream in(options.in);
  std::ofstream out(options.out);
  if (!in) throw std::runtime_error(options.in + ": cannot be read");
  if (!out) throw std::runtime_error(options.out + ": cannot be written");
  out << std::setprecision(12) << "series,t_s,position,velocity,acceleration,predicted\n";
  std::string line;
  Row last{};
  tws::AxisFilter::State state;
  std::getline(in, line);  // column names
  for (int number = 2; std::getline(in, line); ++number) {
    const std::string where = options.in + ":" + std::to_string(number);
    const Row row = rowOf(line, where);
    double predicted = row.measured;
    if (number == 2 || row.series != last.series) {
      state = filter.start(row.measured, options.noise);
    } else
      try {
        const double dt = row.time - last.time;
        predicted = tws::moved(tws::AxisFilter::motion(state), dt).position;
        filter.update(state, row.measured - predicted, dt, options.noise);
      } catch (const std::invalid_argument& error) {
        throw std::runtime_error(where + ": " + error.what());
      }
    print(out, row, tws::AxisFilter::motion(state), predicted);
    last = row;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("filter_csv", [&] {
    Options options;
    CLI::App app(
        "Filters series of measured positions, series,t_s,measured, by one of the filters of tws_core; a new name in "
        "the "
        "first column starts a new series. Out come series,t_s,position,velocity,acceleration,predicted.",
        "filter_csv");
    app.add_option("--in", options.in, "measurements, in order of time")->required()->check(CLI::ExistingFile);
    app.add_option("--out", options.out, "estimates, one line a measurement")->required();
    app.add_option("--kind", options.filter.kind, "the filter")->check(CLI::IsMember(tws::axisFilterKinds()));
    app.add_option("--alpha", options.filter.alpha);
    app.add_option("--beta", options.filter.beta);
    app.add_option("--gamma", options.filter.gamma);
    app.add_option("--degree", options.filter.degree, "of the memories' polynomial");
    app.add_option("--length", options.filter.length, "of fixed memory [measurements]");
    app.add_option("--theta", options.filter.theta, "of fading memory");
    app.add_option("--omega-min", options.filter.adaptive.omega_min, "of the adaptive filter [rad/s]");
    app.add_option("--omega-max", options.filter.adaptive.omega_max, "of the adaptive filter [rad/s]");
    app.add_option("--sigma", options.noise.measurement, "of a measurement")->check(CLI::PositiveNumber);
    app.add_option("--manoeuvre", options.noise.acceleration, "of the acceleration")->check(CLI::PositiveNumber);
    app.add_option("--speed", options.noise.velocity, "of the velocity at the start")->check(CLI::PositiveNumber);
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    run(options);
    return 0;
  });
}
