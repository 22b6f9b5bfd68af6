#include <tws_core/csv_table.h>

#include <gtest/gtest.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <tws_core/temporary_folder_test_helpers.h>

namespace tws {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The columns a and b of all rows.
Rows rowsOf(const std::string& text) {
  std::istringstream input(text);
  CsvTable table(input, "f.csv");
  const std::size_t a = table.require("a"), b = table.require("b");
  Rows rows;
  while (table.next()) rows.push_back({table.text(a), table.text(b)});
  return rows;
}

std::string complaint(const std::string& text) {
  try {
    rowsOf(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class AnyForm : public testing::TestWithParam<const char*> {};

// If one of these fails, a file as spreadsheets, databases and other systems write it is refused or read wrongly.
TEST_P(AnyForm, IsTheSameTable) { EXPECT_EQ(rowsOf(GetParam()), (Rows{{"1", "x y"}, {"2", ""}})); }

constexpr const char* kForms[] = {
    "a,b\n1,x y\n2,\n",
    "a,b\r\n1,x y\r\n2,\r\n",
    "a,b\r1,x y\r2,",
    "\357\273\277a,b\n1,x y\n2,\n",
    "b,a\nx y,1\n,2\n",
    "A,B\n1,x y\n2,\n",
    " a , b \n 1 , x y \n 2 , \n",
    "\"a\",\"b\"\n\"1\",\"x y\"\n\"2\",\"\"\n",
    "a;b\n1;x y\n2;\n",
    "a\tb\n1\tx y\n2\t\n",
    "# of \"1976\na,b\n\n1,x y\n   \n # half\n2,\n\n",
    "a,c,b,,\n1,9,x y,,\n2,9,,,,,\n",
    "a,b\n1,x y\n2\n",
};
INSTANTIATE_TEST_SUITE_P(Each, AnyForm, testing::ValuesIn(kForms));

TEST(CsvTable, QuotedValuesMayHoldDelimitersAndQuotes) {
  EXPECT_EQ(rowsOf("a,b\n\"1,5\",\"the \"\"north\"\" one\"\n"), (Rows{{"1,5", "the \"north\" one"}}));
}

TEST(CsvTable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint(""), "f.csv:1: is empty: the first line must name the columns");
  EXPECT_EQ(complaint("0.5,3\n"), "f.csv:1: the first line must name the columns, and begins with the number 0.5");
  EXPECT_EQ(complaint("a,c\n"), "f.csv:1: has no column b (its columns are a,c)");
  EXPECT_EQ(complaint("a,b\n1,2\n\n0,5,0,7\n"), "f.csv:4: 4 values under 2 column names");
  EXPECT_EQ(complaint("a,b\n1,\"2\n3,4\n"), "f.csv:2: a quote is opened and not closed");
  EXPECT_EQ(complaint(std::string("a\0,\0b\0\n", 7)), "f.csv:1: is no text: it has bytes of zero in its first line");
}

// If this fails, /dev/zero or a film given by mistake fills the memory.
TEST(CsvTable, ALineWithoutEndIsGivenUp) {
  EXPECT_EQ(complaint("a,b\n" + std::string(1 << 20, '1')),
            "f.csv:2: the line is longer than 65536 characters: is this a table of text?");
}

// If this fails, all that stands behind a bad line is lost.
TEST(CsvTable, GoesOnBehindABadRow) {
  std::istringstream input("a,b\n1,2,3\n1,\"2\n3,4\n");
  CsvTable table(input, "f.csv");
  EXPECT_THROW(table.next(), std::runtime_error);
  EXPECT_THROW(table.next(), std::runtime_error);
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.text(1), "4");
  EXPECT_EQ(table.line(), 4U);
  EXPECT_FALSE(table.next());
}

double numberOf(const std::string& text, const std::string& names = "a,b") {
  std::istringstream input(names + "\n" + text + "\n");
  CsvTable table(input, "f.csv");
  table.next();
  return table.number(0);
}

TEST(CsvTable, ReadsNumbersAsPeopleWriteThem) {
  EXPECT_EQ(numberOf("+1.5,"), 1.5);
  EXPECT_EQ(numberOf("-1e3,"), -1000.0);
  EXPECT_EQ(numberOf("1,5;", "a;b"), 1.5);
  EXPECT_EQ(numberOf("1.5;", "a;b"), 1.5);
  for (const char* bad : {"1x,", "1 2,", ",", "nan,", "inf,", "1e999,", "0x10,", "--1,"})
    EXPECT_THROW(numberOf(bad), std::runtime_error) << bad;
  EXPECT_THROW(numberOf("1,5,0;", "a;b"), std::runtime_error);
}

TEST(CsvTable, UnknownIsEmptyOrNan) {
  std::istringstream input("a,b\n,NaN\n1,x\n");
  CsvTable table(input, "f.csv");
  table.next();
  EXPECT_TRUE(std::isnan(table.numberOrUnknown(0)));
  EXPECT_TRUE(std::isnan(table.numberOrUnknown(1)));
  EXPECT_TRUE(std::isnan(table.numberOrUnknown(table.find("c"))));  // No such column.
  table.next();
  EXPECT_EQ(table.numberOrUnknown(0), 1.0);
  EXPECT_THROW(table.numberOrUnknown(1), std::runtime_error);
}

TEST(CsvTable, ReadsTimesAndWholeNumbers) {
  std::istringstream input(
      "t,id\n2024-04-23T14:53:00.102Z,7\n2024-04-23 14:53:00,1.5\n5.5,-1\n2024-04-23,4294967296\n");
  CsvTable table(input, "f.csv");
  table.next();
  EXPECT_NEAR(table.time(0), 1713883980.102, 1e-6);
  EXPECT_EQ(table.whole(1), 7U);
  table.next();
  EXPECT_EQ(table.time(0), 1713883980.0);
  EXPECT_THROW(table.whole(1), std::runtime_error);
  table.next();
  EXPECT_EQ(table.time(0), 5.5);
  EXPECT_EQ(table.recordedTime(0), 5.5);
  EXPECT_THROW(table.whole(1), std::runtime_error);
  table.next();
  EXPECT_THROW(table.time(0), std::runtime_error);
  EXPECT_THROW(table.whole(1), std::runtime_error);
}

class OpenText : public testing::Test {
 protected:
  static std::string complaintOf(const std::string& path) {
    try {
      const auto file = openText(path);
      CsvTable table(*file, path);
      while (table.next()) {
      }
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(path.size());
    }
    return "";
  }
  static std::string packed(const std::string& text) {
    namespace io = boost::iostreams;
    std::ostringstream bytes;
    io::filtering_ostream out;
    out.push(io::gzip_compressor());
    out.push(bytes);
    out << text;
    out.reset();
    return bytes.str();
  }

  const TemporaryFolder folder_;
};

// If this fails, a recording must be unpacked by hand, or half of a damaged one is taken for all of it.
TEST_F(OpenText, UnpacksGzipAndSaysWhenItIsCut) {
  std::string text = "a,b\n";
  for (int i = 0; i < 10000; ++i) text += std::to_string(i * i) + ",x\n";
  const std::string bytes = packed(text);
  const std::string path = folder_.write("whole.csv.gz", bytes);
  const auto file = openText(path);
  CsvTable table(*file, path);
  int rows = 0;
  while (table.next()) ++rows;
  EXPECT_EQ(rows, 10000);
  const std::string cut = complaintOf(folder_.write("cut.csv.gz", bytes.substr(0, bytes.size() / 2)));
  EXPECT_NE(cut.find("cannot be read any further"), std::string::npos) << cut;
}

// If this fails, whoever goes on behind a bad row never comes to an end of a damaged file.
TEST_F(OpenText, ADamagedFileIsComplainedOfOnceAndThenItsEnd) {
  std::string bytes = packed("a,b\n1,2\n");
  bytes[bytes.size() - 8] ^= 1;  // of the checksum
  const std::string path = folder_.write("damaged.csv.gz", bytes);
  const auto file = openText(path);
  int complaints = 0;
  std::unique_ptr<CsvTable> table;
  for (bool more = true; more && complaints < 10;) try {
      if (!table) table = std::make_unique<CsvTable>(*file, path);
      more = table->next();
    } catch (const std::runtime_error&) {
      ++complaints;
    }
  EXPECT_EQ(complaints, 1);
}

TEST_F(OpenText, SaysWhatAFileIs) {
  EXPECT_EQ(complaintOf("/nowhere/f.csv"), ": cannot be read: No such file or directory");
  EXPECT_EQ(complaintOf("/tmp"), ": is a folder");
  EXPECT_EQ(complaintOf(folder_.write("utf16.csv", std::string("\xFF\xFE"
                                                               "a\0",
                                                               4))),
            ": is UTF-16, wanted is UTF-8 (iconv -f UTF-16 -t UTF-8 does it)");
  EXPECT_NE(complaintOf("/dev/zero").find("longer than"), std::string::npos);
  EXPECT_EQ(complaintOf("/dev/null"), ":1: is empty: the first line must name the columns");
}

TEST(DayCount, GoesOnOverMidnightAndTakesStragglers) {
  DayCount days;
  EXPECT_EQ(days.continued(86399.0), 86399.0);
  EXPECT_EQ(days.continued(1.0), 86401.0);
  EXPECT_EQ(days.continued(86399.5), 86399.5);
  EXPECT_EQ(days.continued(2.0), 86402.0);
  EXPECT_EQ(days.midnights(), 1);
}

// If this fails, seconds since 1970, or a pause within a day, are taken for midnights.
TEST(DayCount, LeavesOtherTimesAlone) {
  DayCount days;
  for (const double time : {0.0, 86000.0, 85990.0, 86500.0, 1.7e9, -5.0}) EXPECT_EQ(days.continued(time), time);
  EXPECT_EQ(days.midnights(), 0);
}

}  // namespace
}  // namespace tws
