#include "truth_messages.h"

#include <algorithm>
#include <cmath>

namespace track_evaluation {
namespace {

bool among(const std::vector<std::uint8_t>& kinds, std::uint8_t kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Which of the truth's radars make the cover.
std::vector<bool> coverOf(const tws_msgs::Truth& message, const TruthFilter& filter) {
  std::vector<bool> cover;
  for (const std::string& radar : message.radars)
    cover.push_back(std::find(filter.radars.begin(), filter.radars.end(), radar) != filter.radars.end());
  if (std::find(cover.begin(), cover.end(), true) == cover.end()) cover.assign(cover.size(), true);
  return cover;
}

/// Also where nobody says how well a radar sees it.
bool inCover(const tws_msgs::TruthTarget& target, const std::vector<bool>& cover, double least) {
  const auto& chances = target.detection_probability;
  for (std::size_t i = 0; i < chances.size(); ++i)
    if ((i >= cover.size() || cover[i]) && chances[i] >= least) return true;
  return chances.empty();
}

TruthState stateOf(const tws_msgs::TruthTarget& target, const Eigen::Vector3d& site, const tws::SeaLevel& sea) {
  const Eigen::Vector3d position(target.position.x, target.position.y, target.position.z);
  const Eigen::Vector3d velocity(target.velocity.x, target.velocity.y, target.velocity.z);
  TruthState truth;
  truth.id = target.id;
  truth.ground = {position.head<2>(), velocity.head<2>()};
  truth.slant = onSlantPlane(position, velocity, site);
  truth.mode_3a = target.mode_3a;
  truth.height = sea.heightOf(position);
  return truth;
}

}  // namespace

std::string faultOf(const tws_msgs::TruthTarget& target) {
  const auto& p = target.position;
  const auto& v = target.velocity;
  const std::pair<const char*, double> numbers[] = {{"position.x", p.x}, {"position.y", p.y}, {"position.z", p.z},
                                                    {"velocity.x", v.x}, {"velocity.y", v.y}, {"velocity.z", v.z}};
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value)) return std::string(name) + " is " + std::to_string(value);
  return "";
}

std::vector<TruthState> truthsOf(const tws_msgs::Truth& message, const Eigen::Vector3d& site,
                                 const TruthFilter& filter) {
  std::vector<TruthState> truths;
  const std::vector<bool> cover = coverOf(message, filter);
  for (const tws_msgs::TruthTarget& target : message.targets) {
    const bool required = among(filter.required_kinds, target.kind);
    if ((!required && !among(filter.tolerated_kinds, target.kind)) || !faultOf(target).empty()) continue;
    truths.push_back(stateOf(target, site, filter.sea));
    truths.back().required = required && inCover(target, cover, filter.least_detection_probability);
  }
  return truths;
}

}  // namespace track_evaluation
