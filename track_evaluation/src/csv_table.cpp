#include "csv_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace track_evaluation {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const auto first = line.find_first_not_of(" \t\r", begin);
    const auto last = line.find_last_not_of(" \t\r", end == 0 ? 0 : end - 1);
    cells.push_back(first >= end ? "" : line.substr(first, last - first + 1));
    if (end == line.size()) return cells;
    begin = end + 1;
  }
}

}  // namespace

CsvTable::CsvTable(std::istream& input, std::string name) : input_(input), name_(std::move(name)) {
  std::string line;
  if (!std::getline(input_, line)) fail("is empty");
  header_ = cells(line);
}

bool CsvTable::next() {
  std::string line;
  while (std::getline(input_, line)) {
    ++line_;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    row_ = cells(line);
    if (row_.size() != header_.size())
      fail(std::to_string(row_.size()) + " values under " + std::to_string(header_.size()) + " column names");
    return true;
  }
  return false;
}

std::size_t CsvTable::find(const std::string& column) const {
  return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) - header_.begin());
}

std::size_t CsvTable::require(const std::string& column) const {
  const std::size_t place = find(column);
  if (place == columns()) fail("has no column " + column);
  return place;
}

double CsvTable::number(std::size_t column) const {
  char* end = nullptr;
  const double value = std::strtod(row_[column].c_str(), &end);
  if (row_[column].empty() || *end != '\0' || !std::isfinite(value))
    fail(header_[column] + " '" + row_[column] + "' is no number");
  return value;
}

std::uint32_t CsvTable::whole(std::size_t column, int base) const {
  char* end = nullptr;
  const std::string& word = row_[column];
  const unsigned long long value = std::strtoull(word.c_str(), &end, base);
  if (word.empty() || word[0] < '0' || word[0] > '9' || *end != '\0' || value > 0xffffffffULL)
    fail(header_[column] + " '" + word + "' is no whole number from 0");
  return static_cast<std::uint32_t>(value);
}

void CsvTable::fail(const std::string& reason) const {
  throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + reason);
}

}  // namespace track_evaluation
