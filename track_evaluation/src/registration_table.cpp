#include "registration_table.h"

#include <rosbag/view.h>
#include <tws_msgs/Registration.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <ostream>

#include <tws_core/registration.h>

namespace track_evaluation {
namespace {

using tws_msgs::RadarRegistration;

struct Shown {
  const char* name;
  double error;
  std::size_t term;  // its place among sigmas and applied
};

std::array<Shown, 3> shownOf(const RadarRegistration& radar) {
  return {Shown{"range_m", radar.range_bias, tws::kRangeBias},
          Shown{"azimuth_rad", radar.azimuth_bias, tws::kAzimuthBias},
          Shown{"clock_s", radar.clock_offset, tws::kClockOffset}};
}

void writeHead(std::ostream& out) {
  out << "tracker,t_s,radar,state,relative_only";
  for (const Shown& shown : shownOf({}))
    out << ',' << shown.name << ',' << shown.name << "_sigma," << shown.name << "_applied";
  out << '\n';
}

/// A name from a bag ends no field and no line.
void writeName(std::ostream& out, std::string name) {
  const auto breaks = [](char c) { return c == '\n' || c == '\r'; };
  std::replace_if(name.begin(), name.end(), breaks, ' ');
  out << std::quoted(name, '"', '"');
}

void writeRow(std::ostream& out, const tws_msgs::Registration& message, const RadarRegistration& radar) {
  char text[80];
  std::snprintf(text, sizeof text, ",%.4f,", tws_runtime::toSeconds(message.header.stamp));
  writeName(out, message.tracker);
  out << text;
  writeName(out, radar.radar);
  std::snprintf(text, sizeof text, ",%u,%u", unsigned{radar.state}, unsigned{radar.relative_only});
  out << text;
  for (const Shown& shown : shownOf(radar)) {
    std::snprintf(text, sizeof text, ",%.7g,%.7g,%.7g", shown.error, radar.sigmas[shown.term],
                  radar.applied[shown.term]);
    out << text;
  }
  out << '\n';
}

}  // namespace

void writeRegistrationTable(const std::string& path, std::ostream& out) {
  rosbag::Bag bag;
  tws_runtime::openBag(bag, path);
  writeHead(out);
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::Registration>()));
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = tws_runtime::messageAs<tws_msgs::Registration>(instance);
    if (!message) continue;  // of another version of tws_msgs
    for (const RadarRegistration& radar : message->radars) writeRow(out, *message, radar);
  }
}

}  // namespace track_evaluation
