#include "recorded_trajectory.h"

#include <algorithm>
#include <stdexcept>

namespace radar_sim {

struct RecordedTrajectory::Sample {
  double time;            // data time
  Eigen::Vector4d value;  // position and height
};

RecordedTrajectory::RecordedTrajectory(const std::vector<RecordedFix>& fixes, const RecordingWindow& window,
                                       const tws::LocalFrame& map)
    : RecordedTrajectory(samplesOf(fixes, window, map), window) {}

RecordedTrajectory::RecordedTrajectory(const std::vector<Sample>& samples, const RecordingWindow& window)
    : Trajectory(spansOf(stretchesOf(samples, window.max_gap))) {
  for (const SampleRange& stretch : stretchesOf(samples, window.max_gap)) {
    const double start = stretch.first->time;
    const double length = (stretch.second - 1)->time - start;
    const int pieces = std::max(1, static_cast<int>(length / window.smoothing));
    for (int i = 0; i <= pieces; ++i) knots_.push_back(fitKnot(stretch, start + length * i / pieces, window.smoothing));
  }
}

TargetState RecordedTrajectory::at(double time) const {
  const auto isLater = [](double t, const Knot& knot) { return t < knot.time; };
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time, isLater);
  const Knot& a = *(after - 1);
  const Knot& b = *after;
  const double length = b.time - a.time;
  const double u = std::clamp((time - a.time) / length, 0.0, 1.0);  // asked a little beyond the ends, it stays there
  const Eigen::Vector4d chord = (b.value - a.value) / length;
  // The cubic with the knots' values and slopes, in powers of u.
  const Eigen::Vector4d square = 3.0 * chord - 2.0 * a.slope - b.slope;
  const Eigen::Vector4d cube = a.slope + b.slope - 2.0 * chord;
  const Eigen::Vector4d value = a.value + length * u * (a.slope + u * (square + u * cube));
  const Eigen::Vector4d slope = a.slope + u * (2.0 * square + 3.0 * u * cube);
  return {value.head<3>(), slope.head<3>(), value[3]};
}

std::vector<RecordedTrajectory::Sample> RecordedTrajectory::samplesOf(const std::vector<RecordedFix>& fixes,
                                                                      const RecordingWindow& window,
                                                                      const tws::LocalFrame& map) {
  std::vector<Sample> samples;
  const RecordedFix* before = nullptr;
  for (const RecordedFix& fix : fixes) {
    const bool stale = before != nullptr && fix.place.latitude == before->place.latitude &&
                       fix.place.longitude == before->place.longitude;
    before = &fix;
    if (stale || fix.time < window.from || fix.time > window.to) continue;
    Sample sample;
    sample.time = window.at + fix.time - window.from;
    sample.value << map.toEnu(fix.place), fix.place.altitude;
    samples.push_back(sample);
  }
  return samples;
}

std::vector<RecordedTrajectory::SampleRange> RecordedTrajectory::stretchesOf(const std::vector<Sample>& samples,
                                                                             double max_gap) {
  const auto isGap = [&](const Sample& a, const Sample& b) { return b.time - a.time > max_gap; };
  std::vector<SampleRange> stretches;
  for (auto first = samples.begin(); first != samples.end();) {
    auto last = std::adjacent_find(first, samples.end(), isGap);
    if (last != samples.end()) ++last;
    if (last - first >= 2) stretches.emplace_back(first, last);
    first = last;
  }
  if (stretches.empty())
    throw std::invalid_argument("the recording's window holds no two fixes without a gap between them");
  return stretches;
}

std::vector<TimeSpan> RecordedTrajectory::spansOf(const std::vector<SampleRange>& stretches) {
  std::vector<TimeSpan> spans;
  spans.reserve(stretches.size());
  for (const SampleRange& stretch : stretches) spans.push_back({stretch.first->time, (stretch.second - 1)->time});
  return spans;
}

// The least-squares line through the samples within `half_width`, and through one on each side of it, at `time`.
RecordedTrajectory::Knot RecordedTrajectory::fitKnot(const SampleRange& stretch, double time, double half_width) {
  const auto isBefore = [](const Sample& sample, double t) { return sample.time < t; };
  auto first = std::lower_bound(stretch.first, stretch.second, time - half_width, isBefore);
  const auto isAfter = [](double t, const Sample& sample) { return t < sample.time; };
  auto last = std::upper_bound(first, stretch.second, time + half_width, isAfter);
  if (first != stretch.first) --first;
  if (last != stretch.second) ++last;
  const double count = static_cast<double>(last - first);
  double mean_time = 0.0;
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  for (auto sample = first; sample != last; ++sample) {
    mean_time += (sample->time - time) / count;
    mean += sample->value / count;
  }
  double spread = 0.0;
  Eigen::Vector4d moment = Eigen::Vector4d::Zero();
  for (auto sample = first; sample != last; ++sample) {
    const double offset = sample->time - time - mean_time;
    spread += offset * offset;
    moment += offset * (sample->value - mean);
  }
  const Eigen::Vector4d slope = moment / spread;
  return {time, mean - mean_time * slope, slope};
}

}  // namespace radar_sim
