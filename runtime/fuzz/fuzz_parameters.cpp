// Files of parameters: whatever they hold, a reader of any kind of value has it, or says where it is wrong.
#include <tws_runtime/parameters.h>

#include "fuzzing.h"

namespace {

using fuzzing::attempt;
using fuzzing::inputFile;
using tws_runtime::ParameterReader;

void readNumbers(ParameterReader& reader) {
  double number = 1.0;
  long whole = 1;
  std::vector<double> numbers;
  attempt([&] { reader.number("number", number, -10.0, 1e6); });
  attempt([&] { tws_runtime::scaledNumber(reader, "angle_deg", number, 0.01745, 0.0, 360.0); });
  attempt([&] { reader.integer("whole", whole, -5, 1000000); });
  attempt([&] { reader.numbers("numbers", numbers, 0.0, 100.0); });
  if (!(number >= -10.0 && number <= 1e6) || whole < -5 || whole > 1000000) fuzzing::found("a number out of its range");
}

void readWords(ParameterReader& reader) {
  bool flag = false;
  std::string text = "no";
  std::vector<std::string> texts;
  attempt([&] { reader.flag("flag", flag); });
  attempt([&] { reader.text("text", text); });
  attempt([&] { reader.texts("texts", texts); });
  attempt([&] { reader.choice("choice", text, {"one", "two"}); });
}

void readAll(ParameterReader& reader, int depth) {
  readNumbers(reader);
  readWords(reader);
  if (depth == 0) return;
  attempt([&] {
    ParameterReader inner = reader.map("map");
    readAll(inner, depth - 1);
  });
  attempt([&] {
    for (ParameterReader& inner : reader.list("list")) readAll(inner, depth - 1);
  });
  attempt([&] { reader.done(); });
  for (const std::string& key : reader.keys()) attempt([&] { reader.require(key); });
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  inputFile().write(input);
  attempt([] {
    const YAML::Node tree = tws_runtime::loadParameterFile(inputFile().path());
    ParameterReader reader(tree, inputFile().path());
    readAll(reader, 2);
    (void)tws_runtime::mergeParameters(tree, tws_runtime::withoutRuntimeKeys(tree));
  });
}
