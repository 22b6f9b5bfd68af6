#include "window_params_reader.h"

#include <gtest/gtest.h>

#include <vector>

namespace range_gate_tracker {
namespace {

std::string complaint(const std::string& yaml) {
  try {
    tws_runtime::ParameterReader reader(YAML::Load(yaml), "window_tracker");
    readWindowParams(reader);
    reader.done();
  } catch (const tws_runtime::ParameterError& error) {
    return error.what();
  }
  return "";
}

std::vector<double> valuesOf(const WindowParams& p) {
  const tws::AdaptiveAlphaBetaParams& a = p.filter.adaptive;
  return {p.filter.alpha,
          p.filter.beta,
          p.filter.gamma,
          static_cast<double>(p.filter.degree),
          static_cast<double>(p.filter.length),
          p.filter.theta,
          a.damping,
          a.omega_a,
          a.omega_b,
          a.omega_min,
          a.omega_max,
          static_cast<double>(p.cartesian),
          p.greatest_speed,
          p.greatest_acceleration,
          p.manoeuvre,
          p.range_sigma,
          p.azimuth_sigma,
          p.window_sigmas,
          p.error_weight,
          p.widest,
          static_cast<double>(p.ambiguity),
          static_cast<double>(p.overlap),
          static_cast<double>(p.automatic),
          static_cast<double>(p.firm_hits),
          static_cast<double>(p.acquisition_scans),
          static_cast<double>(p.missed_scans),
          static_cast<double>(p.capacity),
          p.least_speed,
          p.air_speed,
          p.urgent_time,
          p.period};
}

// If this fails, the file that users copy says something else than what holds without it.
TEST(WindowParamsReader, FindsTheDefaultsInTheShippedFile) {
  const YAML::Node tree = tws_runtime::loadParameterFile(RANGE_GATE_TRACKER_CONFIG "/window_tracker.yaml");
  tws_runtime::ParameterReader reader(tree, "window_tracker.yaml");
  const WindowParams shipped = readWindowParams(reader);
  EXPECT_EQ(valuesOf(shipped), valuesOf(WindowParams{}));
  EXPECT_EQ(shipped.filter.kind, WindowParams{}.filter.kind);
  EXPECT_EQ(tree.size(), 24U) << "21 of the tracker and three of the node";
  EXPECT_EQ(tree["filter"].size(), 12U);
}

TEST(WindowParamsReader, TakesTheWordsAndUnitsOfTheNames) {
  tws_runtime::ParameterReader reader(
      YAML::Load("{coordinates: polar, ambiguity: nearest, overlap: share, azimuth_sigma_deg: 0.5, widest_deg: 90}"),
      "t");
  const WindowParams params = readWindowParams(reader);
  EXPECT_FALSE(params.cartesian);
  EXPECT_EQ(params.ambiguity, Ambiguity::kNearest);
  EXPECT_EQ(params.overlap, Overlap::kShare);
  EXPECT_NEAR(params.azimuth_sigma, 0.0087266462599716, 1e-15);
  EXPECT_NO_THROW(check(params));
}

TEST(WindowParamsReader, NamesWhatItRefuses) {
  EXPECT_EQ(complaint("{}"), "");
  for (const char* key : {"greatest_speed_mps", "missed_scans", "window_sigmas", "widest_deg", "capacity"})
    EXPECT_NE(complaint(std::string("{") + key + ": -1}").find(key), std::string::npos) << key;
  EXPECT_NE(complaint("{filter: {kind: beta}}").find("kind"), std::string::npos);
  EXPECT_NE(complaint("{coordinates: round}").find("coordinates"), std::string::npos);
  EXPECT_NE(complaint("{windows: 3}").find("windows"), std::string::npos);
}

}  // namespace
}  // namespace range_gate_tracker
