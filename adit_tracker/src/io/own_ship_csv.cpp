#include "io/own_ship_csv.h"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include <tws_core/csv_table.h>

#include "io/csv_angle.h"

namespace adit_tracker {
namespace {

constexpr std::size_t kMostComplaints = 10;
constexpr double kFarthestNorth = 89.0;  // beyond, east and north turn with every step [deg]

class Reader {
 public:
  Reader(std::istream& input, std::string name) : name_(std::move(name)), csv_(input, name_) {
    time_ = csv_.require("t_s");
    heading_ = csv_.find("heading_deg");
    table_.has_headings = heading_ < csv_.columns();
    geodetic_ = csv_.find("x_m") == csv_.columns() && csv_.find("lat_deg") < csv_.columns();
    first_ = csv_.require(geodetic_ ? "lat_deg" : "x_m");
    second_ = csv_.require(geodetic_ ? "lon_deg" : "y_m");
  }

  OwnShipTable read() {
    while (true) try {
        if (!csv_.next()) break;
        take();
      } catch (const std::runtime_error& error) {
        ++table_.refused;
        if (table_.complaints.size() < kMostComplaints) table_.complaints.emplace_back(error.what());
      }
    if (table_.ship.size() < 2) {
      throw std::runtime_error(name_ + ": needs two or more usable places of own ship" +
                               (table_.complaints.empty() ? ", and has fewer" : "; " + table_.complaints.front()));
    }
    return std::move(table_);
  }

 private:
  void take() {
    const double time = day_.continued(csv_.recordedTime(time_));
    Pose pose = geodetic_ ? fromGeodetic() : Pose{csv_.number(first_), csv_.number(second_), 0.0};
    if (table_.has_headings) pose.heading = angle(heading_, "heading_deg", -360.0, 720.0);
    const std::string problem = table_.ship.add(time, pose);
    if (!problem.empty()) csv_.fail("own ship's place " + problem);
  }

  double angle(std::size_t column, const char* name, double least, double greatest) const {
    return angleOf(csv_, column, name, csv_.number(column), least, greatest);
  }

  Pose fromGeodetic() {
    tws::Geodetic place;
    place.latitude = angle(first_, "lat_deg", -kFarthestNorth, kFarthestNorth);
    place.longitude = angle(second_, "lon_deg", -180.0, 360.0);
    if (!frame_) frame_.emplace(table_.origin.emplace(place));
    const Eigen::Vector3d enu = frame_->toEnu(place);
    return {enu.x(), enu.y(), 0.0};
  }

  std::string name_;
  tws::CsvTable csv_;
  std::size_t time_ = 0, first_ = 0, second_ = 0, heading_ = 0;
  bool geodetic_ = false;
  std::optional<tws::LocalFrame> frame_;  // of latitudes and longitudes
  tws::DayCount day_;
  OwnShipTable table_;
};

}  // namespace

OwnShipTable readOwnShip(std::istream& input, const std::string& name) { return Reader(input, name).read(); }

}  // namespace adit_tracker
