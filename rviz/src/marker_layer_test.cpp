#include "marker_layer.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace tws_rviz {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Drawing labelled(const std::vector<std::uint32_t>& ids) {
  Drawing drawing;
  for (const std::uint32_t id : ids) drawing.labels.push_back({id, {10.0, 20.0}, 5.0, "17", {}});
  return drawing;
}

// What is on RViz's screen after these arrays: markers by name space and id.
using Shown = std::map<std::pair<std::string, int>, Marker>;

void render(const MarkerArray& array, Shown& shown) {
  for (const Marker& marker : array.markers) {
    if (marker.action == Marker::DELETEALL) shown.clear();
    if (marker.action == Marker::DELETE) shown.erase({marker.ns, marker.id});
    if (marker.action == Marker::ADD) shown[{marker.ns, marker.id}] = marker;
  }
}

// A label that is not deleted stays on the screen for ever.
TEST(MarkerLayer, TheScreenShowsTheLatestPictureOnly) {
  MarkerLayer layer("map", "tracks", 5.0);
  Shown shown;
  shown[{"left by an earlier run", 3}] = Marker();
  render(layer.show(labelled({1, 2, 3}), ros::Time(1.0)), shown);
  EXPECT_EQ(shown.size(), 3u);
  render(layer.show(labelled({2, 9}), ros::Time(2.0)), shown);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown.count({"tracks labels", 2}), 1u);
  EXPECT_EQ(shown.count({"tracks labels", 9}), 1u);
  render(layer.show({}, ros::Time(3.0)), shown);
  EXPECT_TRUE(shown.empty());
}

// Hundreds of tracks are one marker; RViz would not bear hundreds.
TEST(MarkerLayer, AllTrianglesAreOneMarkerWithAColourEach) {
  Drawing drawing;
  for (int i = 0; i < 1000; ++i) addDot(drawing, {1.0 * i, 0.0}, 1.0, {0.1f, 0.2f, 0.3f, 0.4f});
  Shown shown;
  render(MarkerLayer("map", "tracks", 5.0).show(drawing, ros::Time(7.0)), shown);
  ASSERT_EQ(shown.size(), 1u);
  const Marker& marker = shown.begin()->second;
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(marker.points.size(), 6000u);
  ASSERT_EQ(marker.colors.size(), 6000u);
  EXPECT_FLOAT_EQ(marker.colors[5].b, 0.3f);
  EXPECT_FLOAT_EQ(marker.colors[5].a, 0.4f);
  EXPECT_EQ(marker.header.frame_id, "map");
  EXPECT_EQ(marker.header.stamp, ros::Time(7.0));
  EXPECT_DOUBLE_EQ(marker.pose.position.z, 5.0);
}

// If this fails, aircraft stand on the screen long after the node that draws them has died, or flicker at high rates.
TEST(MarkerLayer, APictureThatNoOtherFollowsVanishes) {
  MarkerLayer layer("map", "tracks", 5.0);
  const auto lifetimes = [&](double time) {
    std::set<double> seen;
    for (const Marker& marker : layer.show(labelled({4, 5}), ros::Time(time)).markers)
      if (marker.action == Marker::ADD) seen.insert(marker.lifetime.toSec());
    return seen;
  };
  EXPECT_EQ(lifetimes(1000.0), std::set<double>{10.0});
  EXPECT_EQ(lifetimes(1000.2), std::set<double>{10.0});
  EXPECT_EQ(lifetimes(1020.2), std::set<double>{200.0});  // A hundred times as fast.
  EXPECT_EQ(lifetimes(1020.2), std::set<double>{180.0});
  EXPECT_EQ(lifetimes(500.0), std::set<double>{10.0});  // A new run.
}

// If this fails, the first /clock after another one's, or a bad stamp, ends the node: what it drew is all that is
// drawn.
TEST(MarkerLayer, TimeMayJumpByAsMuchAsThereIs) {
  for (const ros::Time& time : {ros::Time(1.8e9), ros::TIME_MAX}) {
    MarkerLayer layer("map", "tracks", 5.0);
    layer.show(labelled({4}), ros::Time(0.01));
    for (const Marker& marker : layer.show(labelled({4}), time).markers) {
      if (marker.action == Marker::ADD) {
        EXPECT_EQ(marker.lifetime.toSec(), 3600.0);
      }
    }
  }
}

TEST(MarkerLayer, APictureWithoutATimeStays) {
  MarkerLayer layer("map", "background", 0.0);
  for (const Marker& marker : layer.show(labelled({4}), ros::Time()).markers) EXPECT_TRUE(marker.lifetime.isZero());
}

TEST(MarkerLayer, ALabelIsATextOfItsHeightAtItsPlace) {
  Shown shown;
  render(MarkerLayer("map", "tracks", 5.0).show(labelled({4}), ros::Time(7.0)), shown);
  const Marker& marker = shown.begin()->second;
  EXPECT_EQ(marker.type, Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(marker.text, "17");
  EXPECT_DOUBLE_EQ(marker.scale.z, 5.0);
  EXPECT_DOUBLE_EQ(marker.pose.position.x, 10.0);
  EXPECT_DOUBLE_EQ(marker.pose.position.y, 20.0);
}

}  // namespace
}  // namespace tws_rviz
