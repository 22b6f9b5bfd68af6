#include "io/registration_csv.h"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <tws_core/csv_table.h>
#include <tws_core/output_file.h>

namespace adit_tracker {
namespace {

constexpr std::array<const char*, tws::kRegistrationTerms> kNames{"range_m",  "gain",       "azimuth_rad",
                                                                  "sine_rad", "cosine_rad", "clock_s"};

std::string columnOf(const std::string& radar, std::size_t term) { return radar + ":" + kNames[term]; }

void write(std::ostream& output, double value) {
  char text[40];
  std::snprintf(text, sizeof text, ",%.17g", value);
  output << text;
}

}  // namespace

void writeRegistration(std::ostream& output, const Adit& adit) {
  const tws::RegistrationFilter& filter = adit.registration().filter();
  output << "radar,term,value";
  for (std::size_t i = 0; i < filter.radars(); ++i)
    for (std::size_t term = 0; term < kNames.size(); ++term)
      output << ',' << columnOf(adit.params().radars[i].name, term);
  output << '\n';
  for (Eigen::Index row = 0; row < filter.mean().size(); ++row) {
    const auto index = static_cast<std::size_t>(row);
    output << adit.params().radars[index / kNames.size()].name << ',' << kNames[index % kNames.size()];
    write(output, filter.mean()[row]);
    for (Eigen::Index column = 0; column < filter.mean().size(); ++column)
      write(output, filter.covariance()(row, column));
    output << '\n';
  }
}

void readRegistration(std::istream& input, const std::string& name, Adit& adit) {
  tws::CsvTable table(input, name);
  const std::size_t radar = table.require("radar"), term = table.require("term"), value = table.require("value");
  std::vector<std::size_t> columns;
  for (const RadarParams& each : adit.params().radars)
    for (std::size_t i = 0; i < kNames.size(); ++i) columns.push_back(table.require(columnOf(each.name, i)));
  const std::size_t rows = columns.size();
  const auto size = static_cast<Eigen::Index>(rows);
  Eigen::VectorXd mean(size);
  Eigen::MatrixXd covariance(size, size);
  std::size_t row = 0;
  for (; table.next(); ++row) {
    if (row >= rows) table.fail("there are more rows than the tracker's radars have errors");
    const std::string& expected = adit.params().radars[row / kNames.size()].name;
    if (table.text(radar) != expected || table.text(term) != kNames[row % kNames.size()])
      table.fail("wants " + std::string(kNames[row % kNames.size()]) + " of radar " + expected);
    mean[static_cast<Eigen::Index>(row)] = table.number(value);
    for (std::size_t i = 0; i < rows; ++i)
      covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) = table.number(columns[i]);
  }
  if (row < rows)
    throw std::runtime_error(name + ": has " + std::to_string(row) + " rows, not " + std::to_string(rows));
  try {
    adit.registration().load(mean, covariance);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

void saveRegistrationFile(const std::string& path, const Adit& adit) {
  tws::OutputFile output(path);
  writeRegistration(output.stream(), adit);
  output.finish();
}

}  // namespace adit_tracker
