#include "io/plot_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <istream>
#include <stdexcept>
#include <string_view>

#include <tws_core/angles.h>
#include <tws_core/units.h>

#include "io/csv_fields.h"

namespace adit_tracker {
namespace {

constexpr std::size_t kColumns = 5;
constexpr std::size_t kMostComplaints = 10;
constexpr double kGreatestTime = 1e10;        // [s]: the year 2286
constexpr double kLongestPause = 600.0;       // within a stretch of plots [s]
constexpr std::size_t kFewestPlots = 3;       // of a stretch: fewer make no track
constexpr double kFarthest = 30.0 * 86400.0;  // from the longest stretch [s]
constexpr const char* kHeader[kColumns] = {"t_s", "radar", "scan", "range_m", "az_deg"};

/// The n-th column of a line; empty when it has fewer.
std::string_view columnOf(std::string_view line, std::size_t n) {
  for (; n > 0 && line.data() != nullptr; --n) {
    const auto comma = line.find(',');
    line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  }
  return line.data() == nullptr ? line : trimmed(line.substr(0, line.find(',')));
}

tws::Plot plotOf(const std::string_view (&columns)[kColumns]) {
  tws::Plot plot;
  plot.time = numberIn(columns[0], kHeader[0]);
  plot.range = numberIn(columns[3], kHeader[3]);
  plot.azimuth = tws::wrapTwoPi(tws::radians(numberIn(columns[4], kHeader[4])));
  if (std::abs(plot.time) > kGreatestTime) {
    throw std::runtime_error("t_s is beyond 1e10 s: " + std::string(columns[0]));
  }
  if (plot.range <= 0.0) throw std::runtime_error("range_m is not positive: " + std::string(columns[3]));
  if (columns[1].empty()) throw std::runtime_error("radar is empty");
  return plot;
}

/// Where the header has columns that need not be there; 0: nowhere.
struct FurtherColumns {
  std::size_t elevation = 0, elevation_sigma = 0;
};

FurtherColumns furtherColumns(const std::string& header) {
  FurtherColumns columns;
  const auto count = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1;
  for (std::size_t i = kColumns; i < count; ++i) {
    if (columnOf(header, i) == "el_deg") columns.elevation = i;
    if (columnOf(header, i) == "el_sigma_deg") columns.elevation_sigma = i;
  }
  return columns;
}

/// Throws the reason.
void readFurther(std::string_view line, const FurtherColumns& columns, tws::Plot& plot) {
  const auto read = [&](std::size_t column, const char* name, double least, double greatest, double& value) {
    const std::string_view text = column == 0 ? std::string_view{} : columnOf(line, column);
    if (text.empty()) return;
    const double degrees = numberIn(text, name);
    if (degrees < least || degrees > greatest)
      throw std::runtime_error(std::string(name) + " is out of range: " + std::string(text));
    value = tws::radians(degrees);
  };
  read(columns.elevation, "el_deg", -90.0, 90.0, plot.elevation);
  read(columns.elevation_sigma, "el_sigma_deg", 0.0, 90.0, plot.elevation_sigma);
}

void checkHeader(const std::string& line, const std::string& name) {
  std::string_view columns[kColumns];
  const bool good = splitFields(line, columns) && std::equal(columns, columns + kColumns, kHeader);
  if (!good) throw std::runtime_error(name + ":1: the header must begin with t_s,radar,scan,range_m,az_deg");
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
  Reader(std::string name, const FurtherColumns& further) : name_(std::move(name)), further_(further) {
    table_.has_elevations = further.elevation > 0;
  }

  void read(std::size_t number, std::string_view text) {
    try {
      std::string_view columns[kColumns];
      if (!splitFields(text, columns)) throw std::runtime_error("has fewer than five columns");
      tws::Plot plot = plotOf(columns);
      readFurther(text, further_, plot);
      lines_.push_back({number, std::string(columns[1]), plot});
    } catch (const std::runtime_error& error) {
      refuse(number, error.what());
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
      const bool mistaken = stretch != longest && (stretch->size() < kFewestPlots || gap > kFarthest);
      for (std::size_t i = stretch->first; i < stretch->last; ++i)
        mistaken ? refuseTime(lines_[i], gap) : take(lines_[i]);
    }
    return std::move(table_);
  }

 private:
  double time(std::size_t line) const { return lines_[line].plot.time; }

  void take(const Line& line) {
    table_.radars[line.radar].push_back(line.plot);
    ++table_.plots;
  }

  void refuse(std::size_t number, const std::string& reason) {
    ++table_.refused;
    if (table_.complaints.size() >= kMostComplaints) return;
    table_.complaints.push_back(name_ + ":" + std::to_string(number) + ": " + reason);
  }

  void refuseTime(const Line& line, double gap) {
    char text[100];
    std::snprintf(text, sizeof text, "t_s lies %.0f s from most other plots: %.10g", gap, line.plot.time);
    refuse(line.number, text);
  }

  std::string name_;
  FurtherColumns further_;
  std::vector<Line> lines_;
  PlotTable table_;
};

}  // namespace

PlotTable readPlots(std::istream& input, const std::string& name) {
  std::string line;
  std::getline(input, line);
  checkHeader(line, name);
  Reader reader(name, furtherColumns(line));
  for (std::size_t number = 2; std::getline(input, line); ++number) {
    if (!trimmed(line).empty()) reader.read(number, line);
  }
  return reader.table();
}

}  // namespace adit_tracker
