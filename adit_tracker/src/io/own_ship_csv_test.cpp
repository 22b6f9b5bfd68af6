#include "io/own_ship_csv.h"

#include <gtest/gtest.h>

#include <sstream>

#include <tws_core/units.h>

namespace adit_tracker {
namespace {

OwnShipTable read(const std::string& text) {
  std::istringstream input(text);
  return readOwnShip(input, "own.csv");
}

/// What it is refused with.
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(OwnShipCsv, PlacesInMetresAndHeadings) {
  const OwnShipTable table = read("t_s,x_m,y_m,heading_deg\n0,0,0,350\n2,20,10,10\n");
  EXPECT_TRUE(table.has_headings);
  EXPECT_FALSE(table.origin.has_value());
  EXPECT_NEAR(table.ship.at(1.0)->x, 10.0, 1e-9);
  EXPECT_NEAR(tws::wrapPi(table.ship.at(1.5)->heading), tws::radians(5.0), 1e-9);
}

// If this fails, a log of latitudes and longitudes puts all plots beside the chart.
TEST(OwnShipCsv, LatitudeAndLongitudeCountFromTheFirstPlace) {
  const OwnShipTable table = read("t_s,lat_deg,lon_deg\n0,63.0,10.0\n60,63.001,10.002\n");
  EXPECT_FALSE(table.has_headings);
  ASSERT_TRUE(table.origin.has_value());
  EXPECT_NEAR(tws::degrees(table.origin->latitude), 63.0, 1e-12);
  EXPECT_NEAR(table.ship.at(60.0)->y, 111.5, 0.2);
  EXPECT_NEAR(table.ship.at(60.0)->x, 101.4, 0.3);
}

// If this fails, a bad line of a receiver is used, or goes without a word.
TEST(OwnShipCsv, BadLinesAreNamedCountedAndLeftOut) {
  const OwnShipTable table = read("t_s,x_m,y_m\n0,0,0\n1,nan,0\n1,ten,0\n1,10,0\n1,11,0\n2,9000,0\n2.5,,\n3,30,0\n");
  EXPECT_EQ(table.ship.size(), 3U);
  EXPECT_EQ(table.refused, 5U);
  ASSERT_EQ(table.complaints.size(), 5U);
  EXPECT_EQ(table.complaints[1], "own.csv:4: x_m 'ten' is no number");
  EXPECT_EQ(table.complaints[2], "own.csv:6: own ship's place does not come after the one before");
  EXPECT_EQ(table.complaints[3], "own.csv:7: own ship's place lies 8990 m and 0 deg from the one before, 1.00 s later");
}

TEST(OwnShipCsv, FilesWithoutAShipAreRefused) {
  EXPECT_NE(refusal("").find("own.csv"), std::string::npos);
  EXPECT_NE(refusal("time,x_m,y_m\n0,0,0\n").find("t_s"), std::string::npos);
  EXPECT_NE(refusal("t_s,y_m\n0,0\n").find("x_m"), std::string::npos);
  EXPECT_NE(refusal("t_s,lat_deg\n0,0\n").find("lon_deg"), std::string::npos);
  EXPECT_EQ(refusal("t_s,x_m,y_m\n0,0,0\n"), "own.csv: needs two or more usable places of own ship, and has fewer");
  EXPECT_EQ(refusal("t_s,lat_deg,lon_deg\n0,90,0\n1,95,0\n"),
            "own.csv: needs two or more usable places of own ship; own.csv:2: lat_deg is out of range: 90");
}

}  // namespace
}  // namespace adit_tracker
