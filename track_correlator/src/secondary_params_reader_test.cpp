#include "secondary_params_reader.h"

#include <gtest/gtest.h>

namespace track_correlator {
namespace {

std::string complaint(const std::string& yaml) {
  try {
    tws_runtime::ParameterReader reader(YAML::Load(yaml), "ssr_tracker");
    readSecondaryParams(reader);
    reader.done();
  } catch (const tws_runtime::ParameterError& error) {
    return error.what();
  }
  return "";
}

std::vector<double> valuesOf(const SecondaryParams& p) {
  return {static_cast<double>(p.delay_sectors),
          p.range_sigma,
          p.azimuth_sigma,
          p.acceleration_density,
          p.speed_sigma,
          p.gate,
          p.code_gate,
          p.unknown_code_cost,
          p.different_code_cost,
          p.garble_range,
          p.garble_azimuth,
          static_cast<double>(p.code_change_replies),
          p.climb_limit,
          p.split_distance,
          static_cast<double>(p.confirm_plots),
          static_cast<double>(p.tentative_misses),
          static_cast<double>(p.drop_misses)};
}

// If this fails, the file that users copy says something else than what holds without it.
TEST(SecondaryParamsReader, FindsTheDefaultsInTheShippedFile) {
  const YAML::Node tree = tws_runtime::loadParameterFile(TRACK_CORRELATOR_CONFIG "/ssr_tracker.yaml");
  tws_runtime::ParameterReader reader(tree, "ssr_tracker.yaml");
  EXPECT_EQ(valuesOf(readSecondaryParams(reader)), valuesOf(SecondaryParams{}));
  EXPECT_EQ(tree.size(), 20U) << "17 of the tracker and three of the node";
}

TEST(SecondaryParamsReader, TakesTheUnitsOfTheNames) {
  tws_runtime::ParameterReader reader(YAML::Load("{azimuth_sigma_deg: 0.5, garble_azimuth_deg: 2}"), "t");
  const SecondaryParams params = readSecondaryParams(reader);
  EXPECT_NEAR(params.azimuth_sigma, 0.0087266462599716, 1e-15);
  EXPECT_NEAR(params.garble_azimuth, 0.0349065850398866, 1e-15);
}

TEST(SecondaryParamsReader, NamesWhatItRefuses) {
  EXPECT_NE(complaint("{delay_sectors: 1}").find("delay_sectors"), std::string::npos);
  EXPECT_NE(complaint("{gate: .nan}").find("gate"), std::string::npos);
  EXPECT_NE(complaint("{gates: 3}").find("gates"), std::string::npos);
  EXPECT_NE(complaint("{drop_misses: 0}").find("drop_misses"), std::string::npos);
}

}  // namespace
}  // namespace track_correlator
