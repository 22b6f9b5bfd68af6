#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <tws_core/axis_filter.h>
#include <tws_core/csv_table.h>
#include <tws_core/output_file.h>

namespace {

struct FilterOptions {
  tws::AxisFilterParams filter;
  tws::AxisNoise noise;
  std::string in, out;
};

/// What is known of one series.
struct Series {
  double time = 0.0;  // of the newest measurement [s]
  tws::AxisFilter::State state;
};

/// A value as it must be written so that it is read again as one.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::ostringstream out;
  out << std::quoted(text, '"', '"');
  return out.str();
}

class Run {
 public:
  Run(const FilterOptions& options, std::istream& in, std::ostream& out)
      : filter_(options.filter), noise_(options.noise), table_(in, options.in), out_(out) {
    out_ << std::setprecision(12) << "series,t_s,position,velocity,acceleration,predicted\n";
  }

  void go() {
    const std::size_t series = table_.require("series"), time = table_.require("t_s"),
                      measured = table_.require("measured");
    while (table_.next()) {
      const std::string& name = table_.text(series);
      if (name.empty()) table_.fail("series is empty");
      const Estimate estimate = take(name, table_.time(time), table_.number(measured));
      const tws::AxisMotion& motion = estimate.motion;
      out_ << quoted(name) << ',' << quoted(table_.text(time)) << ',' << motion.position << ',' << motion.velocity
           << ',' << motion.acceleration << ',' << estimate.predicted << '\n';
    }
  }

 private:
  struct Estimate {
    tws::AxisMotion motion;
    double predicted;  // position
  };

  Estimate take(const std::string& name, double time, double measured) {
    const auto [entry, is_new] = series_.try_emplace(name);
    Series& series = entry->second;
    double predicted = measured;
    if (is_new)
      series.state = filter_.start(measured, noise_);
    else
      predicted = update(series, time - series.time, measured);
    series.time = time;
    return {tws::AxisFilter::motion(series.state), predicted};
  }

  /// The position that was predicted.
  double update(Series& series, double dt, double measured) {
    try {
      const double predicted = tws::moved(tws::AxisFilter::motion(series.state), dt).position;
      filter_.update(series.state, measured - predicted, dt, noise_);
      return predicted;
    } catch (const std::invalid_argument& error) {
      table_.fail(error.what());
    }
  }

  tws::AxisFilter filter_;
  tws::AxisNoise noise_;
  tws::CsvTable table_;
  std::ostream& out_;
  std::map<std::string, Series> series_;
};

void filterFile(const FilterOptions& options) {
  const std::unique_ptr<std::istream> in = tws::openText(options.in);
  tws::OutputFile out(options.out, {options.in});
  Run(options, *in, out.stream()).go();
  out.finish();
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("filter_csv", [&] {
    FilterOptions options;
    CLI::App app(
        "Filters series of measured positions (a CSV file with the columns series,t_s,measured) by one of the filters "
        "of tws_core, each series for itself. Out come series,t_s,position,velocity,acceleration,predicted.",
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
    filterFile(options);
    return 0;
  });
}
