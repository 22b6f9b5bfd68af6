#include "plot_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <stdexcept>
#include <string_view>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace adit_tracker {
namespace {

constexpr std::size_t kColumns = 5;
constexpr std::size_t kMostComplaints = 10;
constexpr const char* kHeader[kColumns] = {"t_s", "radar", "scan", "range_m", "az_deg"};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The first columns of a line; false: there are fewer.
bool split(std::string_view line, std::string_view (&columns)[kColumns]) {
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (line.data() == nullptr) return false;
    const auto comma = line.find(',');
    columns[i] = trimmed(line.substr(0, comma));
    line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  }
  return true;
}

/// Throws the reason.
double number(std::string_view text, const char* column) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error(std::string(column) + " is no number: '" + std::string(text) + "'");
  }
  if (!std::isfinite(value)) throw std::runtime_error(std::string(column) + " is not finite");
  return value;
}

tws::Plot plotOf(const std::string_view (&columns)[kColumns]) {
  tws::Plot plot;
  plot.time = number(columns[0], kHeader[0]);
  plot.range = number(columns[3], kHeader[3]);
  plot.azimuth = tws::wrapTwoPi(tws::radians(number(columns[4], kHeader[4])));
  if (plot.range <= 0.0) throw std::runtime_error("range_m is not positive: " + std::string(columns[3]));
  if (columns[1].empty()) throw std::runtime_error("radar is empty");
  return plot;
}

void checkHeader(const std::string& line, const std::string& name) {
  std::string_view columns[kColumns];
  const bool good = split(line, columns) && std::equal(columns, columns + kColumns, kHeader);
  if (!good) throw std::runtime_error(name + ":1: the header must begin with t_s,radar,scan,range_m,az_deg");
}

}  // namespace

PlotTable readPlots(std::istream& input, const std::string& name) {
  PlotTable table;
  std::string line;
  std::getline(input, line);
  checkHeader(line, name);
  for (std::size_t number_of_line = 2; std::getline(input, line); ++number_of_line) {
    if (trimmed(line).empty()) continue;
    try {
      std::string_view columns[kColumns];
      if (!split(line, columns)) throw std::runtime_error("has fewer than five columns");
      const tws::Plot plot = plotOf(columns);
      table.radars[std::string(columns[1])].push_back(plot);
      ++table.plots;
    } catch (const std::runtime_error& error) {
      ++table.refused;
      if (table.complaints.size() < kMostComplaints) {
        table.complaints.push_back(name + ":" + std::to_string(number_of_line) + ": " + error.what());
      }
    }
  }
  for (auto& [radar, plots] : table.radars) {
    std::stable_sort(plots.begin(), plots.end(),
                     [](const tws::Plot& a, const tws::Plot& b) { return a.time < b.time; });
  }
  return table;
}

}  // namespace adit_tracker
