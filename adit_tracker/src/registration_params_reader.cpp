#include "registration_params_reader.h"

#include <string>

#include <tws_core/units.h>

namespace adit_tracker {
namespace {

using tws_runtime::ParameterReader;

void readReferences(ParameterReader& reader, std::vector<RegistrationReference>& all) {
  std::vector<ParameterReader> entries = reader.list("references");
  if (!reader.has("references")) return;
  all.clear();
  for (ParameterReader& entry : entries) {
    RegistrationReference& reference = all.emplace_back();
    entry.require("name");
    entry.text("name", reference.name);
    entry.number("x_m", reference.x, -kFarthest, kFarthest);
    entry.number("y_m", reference.y, -kFarthest, kFarthest);
    entry.number("height_m", reference.height, -1e4, 1e5);
    entry.number("sigma_m", reference.sigma, 0.1, 1e4);
    entry.done();
  }
}

/// The same for each term; `suffix` stands before the unit.
void readTerms(ParameterReader& reader, const std::string& suffix, tws::RegistrationTerms& terms) {
  using tws::kRadiansPerDegree;
  reader.number("range" + suffix + "_m", terms[tws::kRangeBias], 0.0, 1e5);
  reader.number("gain" + suffix, terms[tws::kRangeGain], 0.0, 0.1);
  scaledNumber(reader, "azimuth" + suffix + "_deg", terms[tws::kAzimuthBias], kRadiansPerDegree, 0.0, 5.0);
  double eccentricity = terms[tws::kAzimuthSine];
  scaledNumber(reader, "eccentricity" + suffix + "_deg", eccentricity, kRadiansPerDegree, 0.0, 5.0);
  terms[tws::kAzimuthSine] = terms[tws::kAzimuthCosine] = eccentricity;
  reader.number("clock" + suffix + "_s", terms[tws::kClockOffset], 0.0, 10.0);
}

}  // namespace

void readRegistrationParams(ParameterReader reader, tws::RegistrationParams& p,
                            std::vector<RegistrationReference>& references) {
  using tws::RegistrationMode;
  choice(reader, "mode", p.mode,
         {{"apply", RegistrationMode::kOn}, {"freeze", RegistrationMode::kFreeze}, {"none", RegistrationMode::kOff}});
  readTerms(reader, "_sigma", p.sigma);
  readTerms(reader, "_drift", p.drift);
  readTerms(reader, "_greatest", p.greatest);
  readTerms(reader, "_rate", p.rate);
  reader.number("significance", p.significance, 1.0, 100.0);
  reader.number("unobservable", p.unobservable, 0.001, 1.0);
  reader.number("gate_sigmas", p.gate, 1.0, 100.0);
  reader.number("pairings_per_s", p.pairings_per_second, 0.01, 1000.0);
  reader.number("settling_time_s", p.settling_time, 0.1, 1e4);
  reader.number("learning_time_s", p.learning_time, 0.0, 1e5);
  readReferences(reader, references);
  reader.done();
}

}  // namespace adit_tracker
