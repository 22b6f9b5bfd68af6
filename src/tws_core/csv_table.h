#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace tws {

/// Reads a table of text row by row: a line of column names, then rows. Columns are found by their names, in upper or
/// lower case. Understood are commas, semicolons or tabs between the values (whichever the line of names has most of),
/// values in double quotes, blanks around them, a byte order mark, ends of line of any system; blank lines and lines
/// that begin with # are skipped. Between semicolons or tabs a number may be written with a decimal comma.
///
/// What cannot be read throws std::runtime_error that begins with "NAME:LINE: "; after one from next() the row that
/// follows can still be asked for.
class CsvTable {
 public:
  /// Throws when there is no line of names, or it is none. The input must outlive the table.
  CsvTable(std::istream& input, std::string name);
  ~CsvTable();
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// The next row is there to be asked. Throws when it has more values than there are names; those that it lacks are
  /// empty.
  bool next();
  std::size_t columns() const { return header_.size(); }
  /// The place of a column; columns() when there is none.
  std::size_t find(const std::string& column) const;
  /// Throws when there is none.
  std::size_t require(const std::string& column) const;

  /// Of the row. Empty for the place columns().
  const std::string& text(std::size_t column) const;
  /// Finite. Throws what is wrong with it, as do all below.
  double number(std::size_t column) const;
  /// NaN where the value is empty or nan.
  double numberOrUnknown(std::size_t column) const;
  /// [s]: a number, or a date and time of UTC such as 2024-04-23T14:53:00.102Z, which gives seconds since 1970.
  double time(std::size_t column) const;
  /// The same of a recording: within ±1e10 s, the year 2286.
  double recordedTime(std::size_t column) const;
  /// In [0, 2^32), written with this base.
  std::uint32_t whole(std::size_t column, int base = 10) const;

  /// Of the row, counted from 1.
  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  struct Splitter;

  bool readLine(std::string& line);
  bool nextLine(std::string& line);
  void checkNames(const std::string& line) const;

  std::istream& input_;
  std::string name_;
  std::size_t line_ = 0;
  std::unique_ptr<Splitter> splitter_;
  std::vector<std::string> header_, row_;
};

/// Opens a file of text for reading; one that is packed by gzip is unpacked. Throws std::runtime_error that names the
/// file when it cannot be read, is no regular file (nor a pipe), or is UTF-16.
std::unique_ptr<std::istream> openText(const std::string& path);

/// Times of day that pass midnight, made to go on.
class DayCount {
 public:
  /// [s]: `time`, and a day more for each midnight passed: a time of day that lies more than half a day before the
  /// last.
  double continued(double time);
  int midnights() const { return midnights_; }

 private:
  double last_ = 0.0;  // time of day [s]
  int days_ = 0, midnights_ = 0;
};

}  // namespace tws
