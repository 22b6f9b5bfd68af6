// Tables of text: whatever the bytes, each row is read or complained of, and the table goes on behind it.
#include <tws_core/csv_table.h>

#include <sstream>

#include "fuzzing.h"

namespace {

const std::string kName = "input";

void ask(const tws::CsvTable& table, std::size_t column) {
  fuzzing::readOrComplain(kName, [&] { (void)table.text(column); });
  fuzzing::readOrComplain(kName, [&] { (void)table.numberOrUnknown(column); });
  if (column == table.columns()) return;  // There is none of that name.
  fuzzing::readOrComplain(kName, [&] { (void)table.number(column); });
  fuzzing::readOrComplain(kName, [&] { (void)table.time(column); });
  fuzzing::readOrComplain(kName, [&] { (void)table.whole(column, 8); });
}

/// True: there may be more.
bool readRow(tws::CsvTable& table) {
  bool more = true;
  fuzzing::readOrComplain(kName, [&] {
    more = table.next();
    if (more) ask(table, table.line() % (table.columns() + 1));
  });
  return more;
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  inputFile().write(input);
  readOrComplain("", [&] {
    const auto text = tws::openText(inputFile().path());
    tws::CsvTable table(*text, kName);
    readOrComplain(kName, [&] { (void)table.require("t_s"); });
    for (std::size_t rows = 0; readRow(table); ++rows)
      if (rows > (std::size_t{1} << 23U)) found("no end of rows");
  });
}
