#pragma once

#include <istream>
#include <string>
#include <vector>

namespace track_evaluation {

/// Reads a CSV file row by row: a line of column names, then rows with as many values; blank lines are skipped.
class CsvTable {
 public:
  /// Throws std::runtime_error when there is no line of names.
  CsvTable(std::istream& input, std::string name);

  /// The next row is there to be asked. Throws std::runtime_error when it has too few or too many values.
  bool next();
  std::size_t columns() const { return header_.size(); }
  /// The place of a column; columns() when there is none.
  std::size_t find(const std::string& column) const;
  /// Throws std::runtime_error when there is none.
  std::size_t require(const std::string& column) const;

  /// Of the row. A number must be finite, a whole one in [0, 2^32) and written with this base. Throws
  /// std::runtime_error.
  const std::string& text(std::size_t column) const { return row_[column]; }
  double number(std::size_t column) const;
  std::uint32_t whole(std::size_t column, int base = 10) const;

  /// Throws std::runtime_error: name, line, reason.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  std::istream& input_;
  std::string name_;
  std::size_t line_ = 1;
  std::vector<std::string> header_, row_;
};

}  // namespace track_evaluation
