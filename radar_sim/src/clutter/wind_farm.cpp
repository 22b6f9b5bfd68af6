#include "clutter/wind_farm.h"

#include <cmath>
#include <random>

#include <tws_core/units.h>

#include "clutter/point_clutter.h"

namespace radar_sim {
namespace {

constexpr double kBetweenFlashes = tws::kPi / 3.0;  // of the rotor: three blades, up and down [rad]

struct Turbine {
  Eigen::Vector2d place;
  double rate;   // [rad/s]
  double phase;  // [rad]
};

std::vector<Turbine> drawTurbines(const WindFarm& farm, std::uint64_t seed) {
  RandomStream random(seed, farm.name + "/turbines");
  std::uniform_real_distribution<> period(0.9 * farm.rotor_period, 1.1 * farm.rotor_period), phase(0.0, tws::kTwoPi);
  std::vector<Turbine> turbines;
  for (const Eigen::Vector2d& place : farm.outlineAt(farm.from)) {
    const double rate = tws::kTwoPi / period(random);
    turbines.push_back({place, rate, phase(random)});
  }
  return turbines;
}

class SeenFarm : public Clutter {
 public:
  SeenFarm(const WindFarm& farm, const ClutterView& view)
      : farm_(farm), turbines_(drawTurbines(farm, view.seed)), view_(view, farm.name) {}

  void raise(const Spoke& spoke, std::vector<Echo>& echoes) override {
    for (std::size_t i = 0; i < turbines_.size(); ++i) {
      const Turbine& turbine = turbines_[i];
      const bool flash = flashes(turbine, spoke);
      const double rcs = (farm_.rcs + (flash ? farm_.flash_rcs : 0.0)) / farm_.suppression;
      // A blade that flashes shows all rates up to its tip's, either way.
      const Motion motion{{0.0, 0.0, 0.0}, flash ? farm_.blade * turbine.rate / std::sqrt(3.0) : 0.0};
      const Eigen::Vector3d position(turbine.place.x(), turbine.place.y(), farm_.hub_height);
      view_.raise({position, rcs, farm_.blade / 2.0, motion}, i, spoke, echoes);
    }
  }

 private:
  /// While the beam is on it, a blade is within a quarter wavelength at its tip of the upright.
  bool flashes(const Turbine& turbine, const Spoke& spoke) const {
    const double width = view_.params().wavelength / (2.0 * farm_.blade);
    const double angle = turbine.phase + turbine.rate * spoke.time;
    const double since = angle - kBetweenFlashes * std::floor(angle / kBetweenFlashes);
    return since < width || since + turbine.rate * spoke.duration > kBetweenFlashes;
  }

  WindFarm farm_;
  std::vector<Turbine> turbines_;
  PointView view_;
};

}  // namespace

std::unique_ptr<Clutter> WindFarm::seenBy(const ClutterView& view) const {
  return std::make_unique<SeenFarm>(*this, view);
}

std::vector<Eigen::Vector2d> WindFarm::outlineAt(double) const {
  const Eigen::Vector2d along(std::sin(orientation), std::cos(orientation)), across(along.y(), -along.x());
  std::vector<Eigen::Vector2d> places;
  for (long row = 0; row < rows; ++row) {
    for (long column = 0; column < columns; ++column) {
      const double right = static_cast<double>(row) - 0.5 * static_cast<double>(rows - 1);
      const double ahead = static_cast<double>(column) - 0.5 * static_cast<double>(columns - 1);
      places.push_back(centre + spacing * (right * across + ahead * along));
    }
  }
  return places;
}

std::unique_ptr<ClutterSpec> readWindFarm(ParameterReader& reader, const ReadingContext& context) {
  auto farm = std::make_unique<WindFarm>();
  readCommon(reader, context, 10.0, *farm);
  farm->centre = readPlace(reader, context);
  reader.integer("rows", farm->rows, 1, 30);
  reader.integer("columns", farm->columns, 1, 30);
  reader.number("spacing_m", farm->spacing, 10.0, 10e3);
  scaledNumber(reader, "orientation_deg", farm->orientation, tws::kRadiansPerDegree, 0.0, 360.0);
  reader.number("hub_height_m", farm->hub_height, 1.0, 3000.0);
  reader.number("blade_m", farm->blade, 1.0, 200.0);
  reader.number("rcs_m2", farm->rcs, 1e-3, 1e6);
  reader.number("flash_rcs_m2", farm->flash_rcs, 0.0, 1e7);
  reader.number("rotor_period_s", farm->rotor_period, 0.5, 60.0);
  return farm;
}

}  // namespace radar_sim
