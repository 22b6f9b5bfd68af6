#include "io/plot_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/csv_table.h>
#include <tws_core/units.h>

#include "adit_params.h"
#include "io/csv_angle.h"

namespace adit_tracker {
namespace {

constexpr std::size_t kMostComplaints = 10;
constexpr double kLongestPause = 600.0;           // within a stretch of plots [s]
constexpr std::size_t kFewestPlots = 3;           // of a stretch: fewer make no track
constexpr double kFarthestAway = 30.0 * 86400.0;  // from the longest stretch [s]

/// Where the columns are; those that need not be there are columns() of the table when they are not.
struct Columns {
  explicit Columns(const tws::CsvTable& table)
      : time(table.require("t_s")),
        radar(table.require("radar")),
        range(table.require("range_m")),
        azimuth(table.require("az_deg")),
        elevation(table.find("el_deg")),
        elevation_sigma(table.find("el_sigma_deg")),
        range_rate(table.find("range_rate_mps")) {}
  std::size_t time, radar, range, azimuth, elevation, elevation_sigma, range_rate;
};

/// NaN when it is not there. Throws the reason.
double angleBetween(const tws::CsvTable& table, std::size_t column, const char* name, double least, double greatest) {
  return angleOf(table, column, name, table.numberOrUnknown(column), least, greatest);
}

/// [m/s]; NaN when it is not there. Throws the reason.
double rateOf(const tws::CsvTable& table, std::size_t column) {
  const double rate = table.numberOrUnknown(column);
  if (std::abs(rate) > kFastestRate) table.fail("range_rate_mps is not in [-100000, 100000]: " + table.text(column));
  return rate;
}

tws::Plot plotOf(const tws::CsvTable& table, const Columns& columns) {
  tws::Plot plot;
  plot.time = table.recordedTime(columns.time);
  plot.range = table.number(columns.range);
  if (plot.range <= 0.0) table.fail("range_m is not positive: " + table.text(columns.range));
  plot.azimuth = tws::wrapTwoPi(tws::radians(table.number(columns.azimuth)));
  if (table.text(columns.radar).empty()) table.fail("radar is empty");
  plot.elevation = angleBetween(table, columns.elevation, "el_deg", -90.0, 90.0);
  plot.elevation_sigma = angleBetween(table, columns.elevation_sigma, "el_sigma_deg", 0.0, 90.0);
  plot.range_rate = rateOf(table, columns.range_rate);
  return plot;
}

struct Line {
  std::size_t number;
  std::string radar;
  tws::Plot plot;
};

/// Lines in order of time, without a long pause between them: [first, last).
struct Stretch {
  std::size_t first, last;
  std::size_t size() const { return last - first; }
};

std::vector<Stretch> stretchesOf(const std::vector<Line>& lines) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].plot.time - lines[i - 1].plot.time > kLongestPause) stretches.push_back({i, i});
    stretches.back().last = i + 1;
  }
  return stretches;
}

class Reader {
 public:
  Reader(std::istream& input, std::string name) : name_(std::move(name)), csv_(input, name_), columns_(csv_) {
    table_.has_elevations = columns_.elevation < csv_.columns();
    table_.has_range_rates = columns_.range_rate < csv_.columns();
  }

  void read() {
    while (true) try {
        if (!csv_.next()) return;
        tws::Plot plot = plotOf(csv_, columns_);
        const std::string& radar = csv_.text(columns_.radar);
        plot.time = days_[radar].continued(plot.time);
        lines_.push_back({csv_.line(), radar, plot});
      } catch (const std::runtime_error& error) {
        refuse(error.what());
      }
  }

  PlotTable table() {
    std::stable_sort(lines_.begin(), lines_.end(),
                     [](const auto& a, const auto& b) { return a.plot.time < b.plot.time; });
    const std::vector<Stretch> stretches = stretchesOf(lines_);
    const auto longest = std::max_element(stretches.begin(), stretches.end(),
                                          [](const Stretch& a, const Stretch& b) { return a.size() < b.size(); });
    for (auto stretch = stretches.begin(); stretch != stretches.end(); ++stretch) {
      const double gap = stretch < longest ? time(longest->first) - time(stretch->last - 1)
                                           : time(stretch->first) - time(longest->last - 1);
      const bool mistaken = stretch != longest && (stretch->size() < kFewestPlots || gap > kFarthestAway);
      for (std::size_t i = stretch->first; i < stretch->last; ++i)
        mistaken ? refuseTime(lines_[i], gap) : take(lines_[i]);
    }
    for (const auto& [radar, days] : days_) table_.midnights = std::max(table_.midnights, days.midnights());
    return std::move(table_);
  }

 private:
  double time(std::size_t line) const { return lines_[line].plot.time; }

  void take(const Line& line) {
    table_.radars[line.radar].push_back(line.plot);
    ++table_.plots;
  }

  void refuse(const std::string& complaint) {
    ++table_.refused;
    if (table_.complaints.size() < kMostComplaints) table_.complaints.push_back(complaint);
  }

  void refuseTime(const Line& line, double gap) {
    char text[100];
    std::snprintf(text, sizeof text, "t_s lies %.0f s from most other plots: %.10g", gap, line.plot.time);
    refuse(name_ + ":" + std::to_string(line.number) + ": " + text);
  }

  std::string name_;
  tws::CsvTable csv_;
  Columns columns_;
  std::map<std::string, tws::DayCount> days_;  // by radar
  std::vector<Line> lines_;
  PlotTable table_;
};

}  // namespace

PlotTable readPlots(std::istream& input, const std::string& name) {
  Reader reader(input, name);
  reader.read();
  return reader.table();
}

}  // namespace adit_tracker
