#include "asterix_params.h"

#include <gtest/gtest.h>

namespace asterix_bridge {
namespace {

using tws_runtime::ParameterError;
using tws_runtime::ParameterReader;

AsterixParams readFile(const std::string& yaml) { return readFileParams(ParameterReader(YAML::Load(yaml), "asterix")); }
AsterixParams readUdp(const std::string& yaml) { return readUdpParams(ParameterReader(YAML::Load(yaml), "asterix")); }

TEST(AsterixParams, HaveTheDefaultsOfTheShippedFile) {
  YAML::Node tree = tws_runtime::loadParameterFile(ASTERIX_CONFIG);
  tree["file"] = "x";
  const AsterixParams shipped = readFileParams(ParameterReader(tree, "asterix"));
  const AsterixParams defaults = readFile("{file: x}");
  EXPECT_EQ(shipped.frame, defaults.frame);
  EXPECT_EQ(shipped.primary_only, defaults.primary_only);
  EXPECT_EQ(shipped.feed.test_targets, defaults.feed.test_targets);
  EXPECT_EQ(shipped.feed.sectors.settle, defaults.feed.sectors.settle);
  EXPECT_EQ(shipped.feed.sectors.latency, defaults.feed.sectors.latency);
  EXPECT_EQ(shipped.feed.sectors.silence, defaults.feed.sectors.silence);
}

TEST(AsterixParams, NameRadarsAndTheirSites) {
  const AsterixParams params = readFile(
      "{file: x, date: '2020-02-29', detections: primary, origin: {latitude_deg: 45, longitude_deg: -3.5},"
      " radars: [{sac: 20, sic: 130, name: tower, latitude_deg: 40, longitude_deg: 5, altitude_m: 600}, {sac: 1, sic: "
      "2}]}");
  EXPECT_DOUBLE_EQ(*params.date, 18321.0 * 86400.0);  // days from 1970 on: 50 years, 12 leap days, 31 and 28 days
  EXPECT_TRUE(params.primary_only);
  EXPECT_DOUBLE_EQ(params.origin->latitude, 0.25 * 3.14159265358979323846);
  const RadarSetting& tower = params.radars.at({20, 130});
  EXPECT_EQ(tower.name, "tower");
  EXPECT_DOUBLE_EQ(tower.position->altitude, 600.0);
  EXPECT_EQ(params.radars.at({1, 2}).name, "radar_1_2");
  EXPECT_FALSE(params.radars.at({1, 2}).position);
}

// A wrong parameter must stop the node with a line that names it.
TEST(AsterixParams, AreRefusedWhenWrong) {
  for (const char* wrong :
       {"{}", "{file: x, speed: 3}", "{file: x, date: 2020-02-30}", "{file: x, date: tomorrow}",
        "{file: x, detections: none}", "{file: x, settle_s: 3}", "{file: x, main_radar: /a}", "{file: x, settle_s: -1}",
        "{file: x, radars: [{sac: 1}]}", "{file: x, radars: [{sac: 1, sic: 300}]}",
        "{file: x, radars: [{sac: 1, sic: 2}, {sac: 1, sic: 2}]}", "{file: x, radars: [{sac: 1, sic: 2, name: 'a b'}]}",
        "{file: x, radars: [{sac: 1, sic: 2, latitude_deg: 40}]}",
        "{file: x, origin: {latitude_deg: 91, longitude_deg: 0}}", "{file: x, udp: '8600'}"})
    EXPECT_THROW(readFile(wrong), ParameterError) << wrong;
  for (const char* wrong :
       {"{}", "{udp: ''}", "{udp: '0'}", "{udp: '70000'}", "{udp: 'x:'}", "{udp: ':8600'}", "{udp: '8600@'}"})
    EXPECT_THROW(readUdp(wrong), ParameterError) << wrong;
}

TEST(AsterixParams, TakeSeveralUdpAddresses) {
  const AsterixParams params = readUdp("{udp: '8600 239.1.1.1:8601@192.168.1.2'}");
  ASSERT_EQ(params.udp.size(), 2u);
  EXPECT_EQ(params.udp[0].address, "0.0.0.0");
  EXPECT_EQ(params.udp[0].port, 8600);
  EXPECT_EQ(params.udp[1].address, "239.1.1.1");
  EXPECT_EQ(params.udp[1].port, 8601);
  EXPECT_EQ(params.udp[1].interface, "192.168.1.2");
}

}  // namespace
}  // namespace asterix_bridge
