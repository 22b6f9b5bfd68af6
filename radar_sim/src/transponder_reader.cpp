#include "transponder_reader.h"

#include <algorithm>

namespace radar_sim {
namespace {

/// As many octal digits; nothing: it is none.
std::optional<int> octal(const std::string& text, std::size_t digits) {
  const auto isOctal = [](char c) { return c >= '0' && c <= '7'; };
  if (text.size() != digits || !std::all_of(text.begin(), text.end(), isOctal)) return std::nullopt;
  return std::stoi(text, nullptr, 8);
}

void readCodeOf(ParameterReader& reader, Mode mode, int& code) {
  const std::string key = mode == Mode::k1 ? "mode_1" : mode == Mode::k2 ? "mode_2" : "mode_3a";
  std::string text;
  reader.text(key, text);
  if (!reader.has(key)) return;
  if (text == "none" || text == "drawn") {
    code = text == "none" ? Transponder::kNone : Transponder::kDrawn;
    return;
  }
  const std::size_t digits = mode == Mode::k1 ? 2 : 4;
  const auto read = octal(text, digits);
  if (!read) {
    reader.fail(key, "'" + text + "' is neither " + std::to_string(digits) + " octal digits nor 'drawn' nor 'none'");
  }
  if (mode == Mode::k1 && *read % 8 > 3) reader.fail(key, "the second digit of '" + text + "' is not in 0 .. 3");
  code = mode == Mode::k1 ? *read << 6 : *read;
}

TimeSpan readSilence(ParameterReader& reader, const ReadingContext& context) {
  TimeSpan silence{0.0, 0.0};
  reader.require("from_s");
  reader.require("to_s");
  reader.number("from_s", silence.start, 0.0, kLongest);
  reader.number("to_s", silence.end, 0.0, kLongest);
  if (silence.end <= silence.start) reader.fail("to_s", "is not later than from_s");
  reader.done();
  return {context.start_time + silence.start, context.start_time + silence.end};
}

}  // namespace

void readTransponder(ParameterReader& reader, const ReadingContext& context, Transponder& transponder) {
  ParameterReader own = reader.map("transponder");
  for (const Mode mode : {Mode::k1, Mode::k2, Mode::k3A}) readCodeOf(own, mode, transponder.codes[index(mode)]);
  own.flag("mode_c", transponder.altitude);
  for (ParameterReader& silence : own.list("silent")) transponder.silences.push_back(readSilence(silence, context));
  own.done();
}

void readTransponderShares(ParameterReader& reader, TransponderShares& shares) {
  ParameterReader own = reader.map("transponder");
  own.number("fraction", shares.fraction, 0.0, 1.0);
  own.number("military_fraction", shares.military_fraction, 0.0, 1.0);
  own.done();
}

}  // namespace radar_sim
