#include "clutter/cell_clutter.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "detection_probability.h"
#include "radar_equation.h"

namespace radar_sim {

CellModel fieldWithin(const Area& area, const Texture& field, double steady_share) {
  CellModel model;
  model.greatest_factor = field.greatest();
  model.steady_share = steady_share;
  model.factor = [area, field](const Cell& cell) {
    return area.contains(cell.place) ? field.at(cell.place, cell.time) : 0.0;
  };
  return model;
}

double rangeCells(const RadarParams& radar) { return std::ceil(radar.max_range / rangeCell(radar)); }

double surfaceCell(const RadarParams& radar, double range) {
  return range * radar.azimuth_beamwidth * rangeCell(radar);
}

double sineOfGrazing(const RadarParams& radar, double range) { return std::min(radar.antenna_height / range, 1.0); }

RadarParams withoutMirror(RadarParams radar) {
  radar.sea_reflection = 0.0;
  return radar;
}

CellClutter::CellClutter(const ClutterView& view, const std::string& stream, CellModel model)
    : radar_(view.params),
      stream_(view.params.name + "/" + stream),
      seed_(view.seed),
      map_to_site_(view.map_to_site),
      site_to_map_(map_to_site_.inverse()),
      model_(std::move(model)),
      range_cell_(rangeCell(view.params)),
      threshold_(-std::log(view.params.false_alarm_probability)) {
  const auto bins = static_cast<std::size_t>(rangeCells(view.params));
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double range = (static_cast<double>(bin) + 0.5) * range_cell_;
    const double cnr = model_.profile(range) / view.params.clutter_suppression;
    if (cnr * model_.greatest_factor < kLeastCnr) {
      if (profile_.empty()) continue;
      profile_.push_back(0.0);
    } else {
      if (profile_.empty()) first_bin_ = bin;
      profile_.push_back(cnr);
    }
  }
  while (!profile_.empty() && profile_.back() <= 0.0) profile_.pop_back();
}

Cell CellClutter::cellOf(const Spoke& spoke, std::size_t bin) const {
  Cell cell;
  cell.range = (static_cast<double>(first_bin_ + bin) + 0.5) * range_cell_;
  cell.azimuth = spoke.azimuthAt(0.5);
  const Eigen::Vector3d at_site(cell.range * std::sin(cell.azimuth), cell.range * std::cos(cell.azimuth), 0.0);
  cell.place = (site_to_map_ * at_site).head<2>();
  cell.time = spoke.timeAt(0.5);
  return cell;
}

double CellClutter::meanCnr(const Cell& cell, std::size_t bin) const {
  const double cnr = profile_[bin] > 0.0 ? profile_[bin] * model_.factor(cell) : 0.0;
  return cnr < kLeastCnr ? 0.0 : cnr;
}

double CellClutter::rangeRateOf(const Echo& echo, RandomStream& random) const {
  if (!model_.motion) return drawFalseRangeRate(radar_, random);
  const Eigen::Vector3d direction(std::sin(echo.azimuth), std::cos(echo.azimuth), 0.0);
  const double rate = radialVelocity(map_to_site_, *model_.motion, direction);
  return drawRangeRate(radar_, rate, model_.motion->spread, random);
}

void CellClutter::raise(const Spoke& spoke, std::vector<Echo>& echoes) {
  RandomStream random(seed_, stream_, static_cast<std::uint64_t>(spoke.running));
  RandomStream rates(seed_, stream_ + "/range rate", static_cast<std::uint64_t>(spoke.running));
  for (std::size_t bin = 0; bin < profile_.size(); ++bin) {
    const double cnr = meanCnr(cellOf(spoke, bin), bin);
    if (cnr <= 0.0) continue;
    // What fluctuates acts as noise of the mean power `noisy`, in which the steady part lies.
    const double steady = cnr * model_.steady_share;
    const double noisy = cnr - steady + 1.0;
    const double power = noisy * addNoise(steady / noisy, random);
    if (power < threshold_) continue;
    echoes.push_back(echoIn(spoke, bin, power, random));
    if (radar_.measuresRangeRates()) echoes.back().range_rate = rangeRateOf(echoes.back(), rates);
  }
}

double CellClutter::expectedCrossings(const Spoke& spoke) const {
  double sum = 0.0;
  for (std::size_t bin = 0; bin < profile_.size(); ++bin) {
    const double cnr = meanCnr(cellOf(spoke, bin), bin);
    if (cnr <= 0.0) continue;
    const double noisy = cnr * (1.0 - model_.steady_share) + 1.0;
    sum += marcumQ(std::sqrt(2.0 * cnr * model_.steady_share / noisy), std::sqrt(2.0 * threshold_ / noisy));
  }
  return sum;
}

Echo CellClutter::echoIn(const Spoke& spoke, std::size_t bin, double power, RandomStream& random) const {
  const std::uint64_t cell = (first_bin_ + bin) * 100000 + static_cast<std::uint64_t>(spoke.number);
  RandomStream own(seed_, stream_ + "/place", cell);
  std::uniform_real_distribution<> uniform(0.0, 1.0);
  const double share = model_.steady_share;
  const auto part = [&] { return share * uniform(own) + (1.0 - share) * uniform(random); };
  const double along = part();
  const double across = part();
  return {spoke.timeAt(across), (static_cast<double>(first_bin_ + bin) + along) * range_cell_, spoke.azimuthAt(across),
          power};
}

}  // namespace radar_sim
