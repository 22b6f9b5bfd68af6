#include "asterix_params.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <tws_core/units.h>

#include "report_csv.h"

namespace asterix_bridge {
namespace {

using tws_runtime::ParameterReader;

std::optional<tws::Geodetic> readPosition(ParameterReader& reader) {
  if (!reader.has("latitude_deg") && !reader.has("longitude_deg")) return std::nullopt;
  double latitude = 0.0, longitude = 0.0;
  tws::Geodetic position;
  reader.require("latitude_deg");
  reader.require("longitude_deg");
  reader.number("latitude_deg", latitude, -90.0, 90.0);
  reader.number("longitude_deg", longitude, -180.0, 180.0);
  reader.number("altitude_m", position.altitude, -1000.0, 10000.0);
  position.latitude = tws::radians(latitude);
  position.longitude = tws::radians(longitude);
  return position;
}

bool isName(const std::string& text) {
  constexpr const char* kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  return !text.empty() && text.find_first_not_of(kAllowed) == std::string::npos;
}

void readRadar(ParameterReader& reader, AsterixParams& params) {
  long sac = 0, sic = 0;
  reader.require("sac");
  reader.require("sic");
  reader.integer("sac", sac, 0, 255);
  reader.integer("sic", sic, 0, 255);
  const SourceId id{static_cast<std::uint8_t>(sac), static_cast<std::uint8_t>(sic)};
  RadarSetting radar{radarName(id), {}};
  reader.text("name", radar.name);
  if (!isName(radar.name)) reader.fail("name", "'" + radar.name + "' is not made of letters, digits and _");
  radar.position = readPosition(reader);
  reader.done();
  if (!params.radars.emplace(id, radar).second) reader.fail("sic", "this radar is in the list twice");
}

void readCommon(ParameterReader& reader, AsterixParams& params) {
  std::string detections = "all";
  SectorCutter::Options& sectors = params.feed.sectors;
  reader.text("frame", params.frame);
  reader.text("main_radar", params.main_radar);
  if (!params.main_radar.empty() && !isName(params.main_radar))
    reader.fail("main_radar", "'" + params.main_radar + "' is not made of letters, digits and _");
  reader.choice("detections", detections, {"all", "primary"});
  params.primary_only = detections == "primary";
  reader.flag("test_targets", params.feed.test_targets);
  reader.number("settle_s", sectors.settle, 0.0, 60.0);
  reader.number("latency_s", sectors.latency, 0.0, 60.0);
  reader.number("silence_s", sectors.silence, 1.0, 3600.0);
  if (sectors.latency < sectors.settle) reader.fail("latency_s", "must not be less than settle_s");
  ParameterReader origin = reader.map("origin");
  params.origin = readPosition(origin);
  origin.done();
  for (ParameterReader& radar : reader.list("radars")) readRadar(radar, params);
  for (const auto& [radar, setting] : params.radars) params.feed.listed.insert(radar);
  reader.flag("only_listed_radars", params.feed.only_listed);
  reader.integer("most_radars", params.feed.most_radars, 1, 1000);
  if (params.feed.only_listed && params.radars.empty()) reader.fail("only_listed_radars", "needs a list of radars");
}

// The words between spaces.
std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

}  // namespace

double parseDate(const std::string& text) {
  int year = 0, month = 0, day = 0;
  char more = 0;
  std::tm date{};
  if (std::sscanf(text.c_str(), "%4d-%2d-%2d%c", &year, &month, &day, &more) == 3 && year >= 1970 && year < 2100) {
    date.tm_year = year - 1900;
    date.tm_mon = month - 1;
    date.tm_mday = day;
    const std::time_t time = timegm(&date);
    if (date.tm_mday == day && date.tm_mon == month - 1) return static_cast<double>(time);
  }
  throw std::invalid_argument("'" + text + "' is no date; expected YYYY-MM-DD, 1970 to 2099");
}

UdpAddress parseUdpAddress(const std::string& text) {
  UdpAddress udp;
  const auto at = text.find('@');
  if (at != std::string::npos) udp.interface = text.substr(at + 1);
  std::string port = text.substr(0, at);
  const auto colon = port.rfind(':');
  if (colon != std::string::npos) {
    udp.address = port.substr(0, colon);
    port = port.substr(colon + 1);
  }
  const bool is_number = !port.empty() && port.size() <= 5 && port.find_first_not_of("0123456789") == std::string::npos;
  const int number = is_number ? std::stoi(port) : 0;
  if (number < 1 || number > 65535 || udp.address.empty() || (at != std::string::npos && udp.interface.empty()))
    throw std::invalid_argument("'" + text + "' is no UDP address; expected [ADDRESS:]PORT[@INTERFACE]");
  udp.port = static_cast<std::uint16_t>(number);
  return udp;
}

AsterixParams readFileParams(ParameterReader reader) {
  AsterixParams params;
  reader.require("file");
  reader.text("file", params.file);
  reader.number("duration", params.duration, 0.0, 1e9);
  reader.number("lookahead_s", params.lookahead, 0.0, 3600.0);
  std::string date;
  reader.text("date", date);
  readCommon(reader, params);
  reader.done();
  // A file can be read ahead: what comes late in it is cut by its time all the same, be it half of what is read ahead.
  params.feed.sectors.settle = std::max(params.feed.sectors.settle, params.lookahead / 2.0);
  if (params.file.empty()) reader.fail("file", "is empty; name a recording (of a live feed: udp)");
  try {
    if (!date.empty()) params.date = parseDate(date);
  } catch (const std::invalid_argument& error) {
    reader.fail("date", error.what());
  }
  return params;
}

AsterixParams readUdpParams(ParameterReader reader) {
  AsterixParams params;
  std::string addresses, senders;
  reader.require("udp");
  reader.text("udp", addresses);
  reader.text("senders", senders);
  reader.number("most_latency_s", params.most_latency, 0.0, 60.0);
  readCommon(reader, params);
  reader.done();
  params.feed.sectors.steady = true;  // What comes in bursts reaches its listeners topic by topic, out of step.
  for (const std::string& sender : wordsOf(senders)) params.senders.insert(sender);
  try {
    for (const std::string& word : wordsOf(addresses)) params.udp.push_back(parseUdpAddress(word));
  } catch (const std::invalid_argument& error) {
    reader.fail("udp", error.what());
  }
  if (params.udp.empty()) reader.fail("udp", "is empty");
  return params;
}

}  // namespace asterix_bridge
