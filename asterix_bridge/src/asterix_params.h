#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tws_core/geodesy.h>
#include <tws_runtime/parameters.h>

#include "radar_feed.h"

namespace asterix_bridge {

/// Where a UDP feed comes in: the group's or this machine's address, port, and the address of the network interface
/// (empty: any).
struct UdpAddress {
  std::string address = "0.0.0.0";
  std::uint16_t port = 0;
  std::string interface;
};
/// Reads "[ADDRESS:]PORT[@INTERFACE]". Throws std::invalid_argument.
UdpAddress parseUdpAddress(const std::string& text);

/// What the user says of a radar.
struct RadarSetting {
  std::string name;
  std::optional<tws::Geodetic> position;
};

/// Parameters of both nodes; config/asterix.yaml is the reference.
struct AsterixParams {
  std::string file;             // of the file node
  std::vector<UdpAddress> udp;  // of the UDP node
  std::optional<double> date;   // midnight of the first record's day since 1970 [s]
  double duration = 0.0;        // of the file that is played [s]; 0: all
  std::string frame = "map";
  std::optional<tws::Geodetic> origin;  // of the map
  std::map<SourceId, RadarSetting> radars;
  std::string main_radar;         // how a file's busiest radar, or the first one heard, is called; empty: as any other
  std::set<std::string> senders;  // addresses whose datagrams count; empty: all
  double most_latency = 10.0;     // what the latency of a live feed grows to, where data come later [s]
  bool primary_only = false;
  double lookahead = 60.0;  // how far the file is read ahead [s]
  RadarFeed::Options feed;
};

/// Throw tws_runtime::ParameterError.
AsterixParams readFileParams(tws_runtime::ParameterReader reader);
AsterixParams readUdpParams(tws_runtime::ParameterReader reader);

/// Midnight of "2020-02-29" since 1970 [s]. Throws std::invalid_argument.
double parseDate(const std::string& text);

}  // namespace asterix_bridge
