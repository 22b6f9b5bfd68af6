#include <tws_core/csv_table.h>

#include <csv.h>

#include <algorithm>
#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace tws {
namespace {

constexpr std::size_t kLongestLine = 65536;  // longer ones are no rows of a table, and would fill the memory
constexpr double kDay = 86400.0;

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Nothing, or a remark.
bool saysNothing(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string::npos || line[first] == '#';
}

/// Which of the characters that may part values the line of names has most of.
char delimiterOf(const std::string& line) {
  const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
  const char other = count('\t') > count(';') ? '\t' : ';';
  return count(other) > count(',') ? other : ',';
}

bool parse(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Seconds since 1970 of 2024-04-23T14:53:00.102Z; false: is none.
bool parseDate(const std::string& text, double& time) {
  std::tm date{};
  double seconds = 0.0;
  int length = 0;
  const int read = std::sscanf(text.c_str(), "%4d-%2d-%2d%*1[T ]%2d:%2d:%n", &date.tm_year, &date.tm_mon, &date.tm_mday,
                               &date.tm_hour, &date.tm_min, &length);
  if (read != 5 || length == 0) return false;
  std::string_view rest(text);
  rest.remove_prefix(static_cast<std::size_t>(length));
  if (!rest.empty() && rest.back() == 'Z') rest.remove_suffix(1);
  if (!parse(rest, seconds) || !(seconds >= 0.0 && seconds < 61.0)) return false;
  date.tm_year -= 1900;
  date.tm_mon -= 1;
  time = static_cast<double>(timegm(&date)) + seconds;
  return true;
}

}  // namespace

/// libcsv, one line at a time.
struct CsvTable::Splitter {
  Splitter() { csv_init(&parser, 0); }
  ~Splitter() { csv_free(&parser); }
  Splitter(const Splitter&) = delete;
  Splitter& operator=(const Splitter&) = delete;

  void delimiter(char character) { csv_set_delim(&parser, static_cast<unsigned char>(character)); }
  char delimiter() { return static_cast<char>(csv_get_delim(&parser)); }

  /// False: a quote is opened and not closed.
  bool split(const std::string& line, std::vector<std::string>& fields) {
    values.clear();
    complete = false;
    const auto take = [](void* text, std::size_t length, void* self) {
      static_cast<Splitter*>(self)->values.emplace_back(static_cast<char*>(text), length);
    };
    const auto end = [](int, void* self) { static_cast<Splitter*>(self)->complete = true; };
    csv_parse(&parser, line.data(), line.size(), take, end, this);
    csv_parse(&parser, "\n", 1, take, end, this);
    const bool closed = complete;
    if (!closed) csv_fini(&parser, take, end, this);
    fields.swap(values);
    return closed;
  }

  csv_parser parser{};
  std::vector<std::string> values;
  bool complete = false;
};

CsvTable::CsvTable(std::istream& input, std::string name)
    : input_(input), name_(std::move(name)), splitter_(std::make_unique<Splitter>()) {
  std::string line;
  if (!nextLine(line)) fail("is empty: the first line must name the columns");
  checkNames(line);
  splitter_->delimiter(delimiterOf(line));
  if (!splitter_->split(line, header_)) fail("a quote is opened and not closed");
  std::transform(header_.begin(), header_.end(), header_.begin(), lowered);
}

CsvTable::~CsvTable() = default;

void CsvTable::checkNames(const std::string& line) const {
  if (line.find('\0') != std::string::npos) fail("is no text: it has bytes of zero in its first line");
  double value = 0.0;
  const std::string first = line.substr(0, line.find_first_of(",;\t"));
  if (parse(first, value)) fail("the first line must name the columns, and begins with the number " + first);
}

/// A line without its end, which is \n, \r\n or \r.
bool CsvTable::readLine(std::string& line) {
  line.clear();
  std::streambuf& bytes = *input_.rdbuf();
  constexpr int kEnd = std::char_traits<char>::eof();
  int byte = bytes.sgetc();
  if (byte == kEnd) return false;
  ++line_;
  for (; byte != kEnd && byte != '\n' && byte != '\r'; byte = bytes.snextc()) {
    if (line.size() == kLongestLine) fail("the line is longer than 65536 characters: is this a table of text?");
    line.push_back(static_cast<char>(byte));
  }
  if (byte == '\r' && bytes.snextc() != '\n') return true;
  bytes.sbumpc();
  return true;
}

/// The next line with something on it.
bool CsvTable::nextLine(std::string& line) {
  if (input_.bad()) return false;  // It was complained of.
  try {
    while (readLine(line)) {
      if (line_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
      if (!saysNothing(line)) return true;
    }
  } catch (const std::ios_base::failure& error) {
    input_.setstate(std::ios_base::badbit);
    fail(std::string("cannot be read any further (") + error.what() + ")");
  }
  return false;
}

bool CsvTable::next() {
  std::string line;
  if (!nextLine(line)) return false;
  if (!splitter_->split(line, row_)) fail("a quote is opened and not closed");
  while (row_.size() > header_.size() && row_.back().empty()) row_.pop_back();
  if (row_.size() > header_.size())
    fail(std::to_string(row_.size()) + " values under " + std::to_string(header_.size()) + " column names");
  row_.resize(header_.size());
  return true;
}

std::size_t CsvTable::find(const std::string& column) const {
  return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) - header_.begin());
}

std::size_t CsvTable::require(const std::string& column) const {
  const std::size_t place = find(column);
  if (place < columns()) return place;
  std::string names;
  for (const std::string& name : header_) names += (names.empty() ? "" : ",") + name;
  fail("has no column " + column + " (its columns are " + names + ")");
}

const std::string& CsvTable::text(std::size_t column) const {
  static const std::string kEmpty;
  return column < row_.size() ? row_[column] : kEmpty;
}

double CsvTable::number(std::size_t column) const {
  const std::string& text = this->text(column);
  if (text.empty()) fail(header_.at(column) + " is empty");
  double value = 0.0;
  bool good = parse(text, value);
  if (const auto comma = text.find(','); !good && comma != std::string::npos && splitter_->delimiter() != ',') {
    std::string pointed = text;
    pointed[comma] = '.';
    good = parse(pointed, value);
  }
  if (!good) fail(header_.at(column) + " '" + text + "' is no number");
  if (!std::isfinite(value)) fail(header_.at(column) + " '" + text + "' is not finite");
  return value;
}

double CsvTable::numberOrUnknown(std::size_t column) const {
  const std::string& text = this->text(column);
  return text.empty() || lowered(text) == "nan" ? std::nan("") : number(column);
}

double CsvTable::time(std::size_t column) const {
  double time = 0.0;
  return parseDate(text(column), time) ? time : number(column);
}

double CsvTable::recordedTime(std::size_t column) const {
  constexpr double kGreatest = 1e10;
  const double time = this->time(column);
  if (std::abs(time) > kGreatest)
    fail(header_.at(column) + " is beyond 1e10 s: " + text(column) + " (it counts seconds, not milliseconds)");
  return time;
}

std::uint32_t CsvTable::whole(std::size_t column, int base) const {
  const std::string& text = this->text(column);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size())
    fail(header_.at(column) + " '" + text + "' is no whole number from 0");
  return value;
}

void CsvTable::fail(const std::string& reason) const {
  throw std::runtime_error(name_ + ":" + std::to_string(std::max<std::size_t>(line_, 1)) + ": " + reason);
}

std::unique_ptr<std::istream> openText(const std::string& path) {
  namespace io = boost::iostreams;
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw std::runtime_error(path + ": is a folder");
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  if (!std::filesystem::is_regular_file(path, unknown)) return file;  // A pipe cannot be looked into and wound back.
  char begin[2] = {};
  file->read(begin, 2);
  file->clear();
  file->seekg(0);
  const std::string mark(begin, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF")
    throw std::runtime_error(path + ": is UTF-16, wanted is UTF-8 (iconv -f UTF-16 -t UTF-8 does it)");
  if (mark != "\x1F\x8B") return file;
  auto unpacked = std::make_unique<io::filtering_istream>();
  unpacked->push(io::gzip_decompressor());
  unpacked->push(io::file_source(path, std::ios::binary));
  return unpacked;
}

double DayCount::continued(double time) {
  if (time < 0.0 || time > kDay) return time + kDay * days_;
  if (time < last_ - kDay / 2.0) {
    ++days_;
    ++midnights_;
  } else if (days_ > 0 && time > last_ + kDay / 2.0) {
    --days_;  // A straggler from before midnight.
    --midnights_;
  }
  last_ = time;
  return time + kDay * days_;
}

}  // namespace tws
