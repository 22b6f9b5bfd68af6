#include "registration_table.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_msgs/Registration.h>

#include <sstream>

namespace track_evaluation {
namespace {

tws_msgs::RadarRegistration radarNamed(const std::string& name) {
  tws_msgs::RadarRegistration radar;
  radar.radar = name;
  radar.state = tws_msgs::RadarRegistration::APPLIED;
  radar.relative_only = 1;
  radar.range_bias = 100.0;
  radar.azimuth_bias = 0.01;
  radar.clock_offset = -0.3;
  for (std::size_t i = 0; i < radar.sigmas.size(); ++i) {
    radar.sigmas[i] = static_cast<double>(i + 1);
    radar.applied[i] = static_cast<double>(10 * (i + 1));
  }
  return radar;
}

// If this fails, the page of a run shows errors of registration under wrong names or radars. Terms stand in the order
// of the message: range bias and gain, azimuth bias, sine and cosine, clock.
TEST(RegistrationTable, HasOneRowForEachMessageAndRadar) {
  const tws::TemporaryFolder folder;
  const std::string path = folder.file("run.bag");
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  tws_msgs::Registration message;
  message.tracker = "adit";
  message.radars = {radarNamed("a"), radarNamed("b\",\n")};
  message.header.stamp = ros::Time(12.5);
  bag.write("/adit/registration", ros::Time(13.0), message);
  bag.close();
  std::ostringstream out;
  writeRegistrationTable(path, out);
  EXPECT_EQ(out.str(),
            "tracker,t_s,radar,state,relative_only,range_m,range_m_sigma,range_m_applied,azimuth_rad,azimuth_rad_sigma,"
            "azimuth_rad_applied,clock_s,clock_s_sigma,clock_s_applied\n"
            "\"adit\",12.5000,\"a\",2,1,100,1,10,0.01,3,30,-0.3,6,60\n"
            "\"adit\",12.5000,\"b\"\", \",2,1,100,1,10,0.01,3,30,-0.3,6,60\n");
}

}  // namespace
}  // namespace track_evaluation
