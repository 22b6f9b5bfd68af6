#include "frame_rules.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace esa_frame_builder {
namespace {

std::string name(const Frame& frame) { return "frame " + std::to_string(frame.number) + ": "; }

struct Place {
  std::size_t dwell, index;
  const Measurement* measurement;
};

std::vector<Place> byRange(const Frame& frame) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < frame.dwells.size(); ++k)
    for (std::size_t i = 0; i < frame.dwells[k].measurements.size(); ++i)
      places.push_back({k, i, &frame.dwells[k].measurements[i]});
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.measurement->range < b.measurement->range; });
  return places;
}

bool areAlike(const Measurement& a, const Measurement& b, double chi2) {
  const Eigen::Vector3d difference(a.range - b.range, a.u - b.u, a.v - b.v);
  return difference.dot((a.covariance + b.covariance).inverse() * difference) <= chi2;
}

double greatestSigma(const std::vector<Place>& places) {
  double variance = 0.0;
  for (const Place& place : places) variance = std::max(variance, place.measurement->covariance(0, 0));
  return std::sqrt(variance);
}

}  // namespace

std::vector<std::string> brokenRules(const Frame& frame, const Frame* previous) {
  std::vector<std::string> broken;
  if (frame.dwells.empty()) broken.push_back(name(frame) + "it has no field of view");
  const auto earlier = [](const Dwell& a, const Dwell& b) { return a.time < b.time; };
  if (!std::is_sorted(frame.dwells.begin(), frame.dwells.end(), earlier))
    broken.push_back(name(frame) + "its dwells are not in order of time");
  if (previous == nullptr) return broken;
  if (!frame.dwells.empty() && !previous->dwells.empty() && frame.dwells[0].time < previous->dwells[0].time)
    broken.push_back(name(frame) + "it begins before the one before it");
  if (frame.number != previous->number + 1)
    broken.push_back(name(frame) + "it follows frame " + std::to_string(previous->number));
  return broken;
}

std::size_t removeDuplicates(Frame& frame, double chi2) {
  const std::vector<Place> places = byRange(frame);
  const double reach = std::sqrt(2.0 * chi2) * greatestSigma(places);
  std::vector<bool> out(places.size(), false);
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size() && !out[a]; ++b) {
      const Measurement &first = *places[a].measurement, &second = *places[b].measurement;
      if (second.range - first.range > reach) break;
      if (out[b] || places[a].dwell == places[b].dwell || !areAlike(first, second, chi2)) continue;
      out[first.snr < second.snr ? a : b] = true;
    }
  std::vector<Place> removed;
  for (std::size_t a = 0; a < places.size(); ++a)
    if (out[a]) removed.push_back(places[a]);
  // From the back, so that the other indices stay.
  std::sort(removed.begin(), removed.end(), [](const Place& a, const Place& b) { return a.index > b.index; });
  for (const Place& place : removed) {
    auto& measurements = frame.dwells[place.dwell].measurements;
    measurements.erase(measurements.begin() + static_cast<std::ptrdiff_t>(place.index));
  }
  return removed.size();
}

}  // namespace esa_frame_builder
