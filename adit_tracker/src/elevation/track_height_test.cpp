#include "elevation/track_height.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/refraction.h>
#include <Eigen/Core>

namespace adit_tracker {
namespace {

const Site kSite{1000.0, 2000.0, 35.0, 0.0};

/// An aircraft that flies at constant velocity through space, as a tracker without height tells it.
struct Aircraft {
  Eigen::Vector3d position, velocity;  // from the antenna [m], [m/s]

  tws_msgs::Track onSlantPlane() const {
    tws_msgs::Track message;
    const double R = position.norm(), rate = position.dot(velocity) / R;
    const Eigen::Vector2d ground = position.head<2>(), u = ground.normalized();
    const Eigen::Vector2d across(-u.y(), u.x());
    const double turn = across.dot(velocity.head<2>()) / ground.norm();
    message.range = R;
    message.range_rate = rate;
    message.position.x = kSite.x + R * u.x();
    message.position.y = kSite.y + R * u.y();
    message.velocity.x = rate * u.x() + R * turn * across.x();
    message.velocity.y = rate * u.y() + R * turn * across.y();
    return message;
  }
  Height height() const {
    const Eigen::Vector3d from_centre = position + Eigen::Vector3d(0.0, 0.0, tws::kMeanEarthRadius);
    return {from_centre.norm() - tws::kMeanEarthRadius, 100.0, from_centre.normalized().dot(velocity), 2.0};
  }
};

// A PPI or a correlator that uses the position would be kilometres off close to the site.
TEST(SetHeight, PutsPositionAndVelocityWhereTheAircraftIs) {
  for (const Aircraft& aircraft :
       {Aircraft{{6e3, 8e3, 9e3}, {200.0, -50.0, 10.0}}, Aircraft{{-120e3, 50e3, 7e3}, {-150.0, 220.0, -5.0}}}) {
    tws_msgs::Track message = aircraft.onSlantPlane();
    setHeight(message, aircraft.height(), kSite);
    EXPECT_NEAR(message.position.x - kSite.x, aircraft.position.x(), 0.01);
    EXPECT_NEAR(message.position.y - kSite.y, aircraft.position.y(), 0.01);
    EXPECT_NEAR(message.position.z - kSite.z, aircraft.position.z(), 0.01);
    EXPECT_NEAR(message.velocity.x, aircraft.velocity.x(), 0.01);
    EXPECT_NEAR(message.velocity.y, aircraft.velocity.y(), 0.01);
    EXPECT_NEAR(message.velocity.z, aircraft.velocity.z(), 0.01);
    EXPECT_NEAR(message.speed, aircraft.velocity.head<2>().norm(), 0.01);
    EXPECT_NEAR(message.height, aircraft.height().height + 35.0, 0.5);
    EXPECT_DOUBLE_EQ(message.height_sigma, 100.0);
  }
}

// By hand for a target at x = 0, y = 8 km, z = 6 km, R = 10 km: along the line of sight 100 m of range become
// 125 m of ground range and 40 m of height 30 m; across, 50 m become 40 m.
TEST(SetHeight, CarriesTheCovarianceOver) {
  tws_msgs::Track message = Aircraft{{0.0, 8e3, 6e3}, {0.0, 0.0, 0.0}}.onSlantPlane();
  message.covariance = {2500.0, 0.0, 0.0, 0.0, 0.0, 1e4, 0.0, 0.0, 0.0, 0.0, 100.0, 0.0, 0.0, 0.0, 0.0, 400.0};
  Height height = Aircraft{{0.0, 8e3, 6e3}, {0.0, 0.0, 0.0}}.height();
  height.height_sigma = 40.0;
  height.climb_sigma = 4.0;
  setHeight(message, height, kSite);
  EXPECT_NEAR(message.covariance[0], 40.0 * 40.0, 0.01);
  EXPECT_NEAR(message.covariance[5], 125.0 * 125.0 + 30.0 * 30.0, 40.0);
  EXPECT_NEAR(message.covariance[10], 8.0 * 8.0, 0.01);
  EXPECT_NEAR(message.covariance[15], 25.0 * 25.0 + 3.0 * 3.0, 2.0);
  EXPECT_NEAR(message.covariance[1], 0.0, 1e-6);
}

TEST(SetHeight, LeavesATrackRightOverTheSiteAsItIs) {
  tws_msgs::Track message = Aircraft{{0.0, 300.0, 6e3}, {0.0, 0.0, 0.0}}.onSlantPlane();
  message.height = message.position.z = std::nan("");
  const double y = message.position.y;
  setHeight(message, {6000.0, 100.0, 0.0, 1.0}, kSite);
  EXPECT_DOUBLE_EQ(message.position.y, y);
  EXPECT_TRUE(std::isnan(message.height));
}

}  // namespace
}  // namespace adit_tracker
