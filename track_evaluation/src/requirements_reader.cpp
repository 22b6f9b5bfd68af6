#include "requirements_reader.h"

namespace track_evaluation {

std::vector<RequirementProfile> readProfiles(tws_runtime::ParameterReader& reader) {
  std::vector<RequirementProfile> profiles;
  for (tws_runtime::ParameterReader& entry : reader.list("profiles")) {
    RequirementProfile profile;
    std::string source;  // For people.
    entry.require("name");
    entry.text("name", profile.name);
    entry.text("source", source);
    entry.number("update_interval_s", profile.update_interval, 0.1, 3600.0);
    entry.number("update_probability", profile.update_probability, 0.0, 1.0);
    entry.number("long_gap_s", profile.long_gap, 0.1, 3600.0);
    entry.number("long_gap_share", profile.long_gap_share, 0.0, 1.0);
    entry.number("horizontal_rms_m", profile.horizontal_rms, 0.0, 1e6);
    entry.number("false_share", profile.false_share, 0.0, 1.0);
    entry.number("mode_3a_probability", profile.mode_3a_probability, 0.0, 1.0);
    entry.number("mode_c_probability", profile.mode_c_probability, 0.0, 1.0);
    entry.number("height_error_m", profile.height_error, 0.1, 1e5);
    entry.done();
    profiles.push_back(profile);
  }
  return profiles;
}

std::vector<RequirementProfile> readRequirements(const YAML::Node& tree, const std::string& where) {
  tws_runtime::ParameterReader reader(tree, where);
  std::vector<RequirementProfile> profiles = readProfiles(reader);
  reader.done();
  return profiles;
}

}  // namespace track_evaluation
