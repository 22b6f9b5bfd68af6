#include "timing.h"

#include <algorithm>

namespace track_evaluation {
namespace {

void reportPercentiles(MetricList& metrics, const std::string& name, const Sample& values) {
  const std::pair<const char*, double> percents[] = {{"p50", 50.0}, {"p95", 95.0}, {"p99", 99.0}, {"max", 100.0}};
  for (const auto& [word, percent] : percents)
    metrics.emplace_back(name + "_" + word + "_s", values.percentile(percent));
}

}  // namespace

void Timing::extendTo(double now) {
  if (!started_) first_ = now;
  started_ = true;
  last_ = std::max(last_, now);
}

void Timing::addPlots(const std::string& radar, double now, double stamp, std::size_t plots) {
  extendTo(now);
  plots_ += static_cast<double>(plots);
  plots_latency_.add(now - stamp);
  newest_plots_[radar] = now;
}

void Timing::addTracks(const std::string& radar, double now, double stamp, std::size_t tracks) {
  extendTo(now);
  tracks_ += static_cast<double>(tracks);
  tracks_latency_.add(now - stamp);
  // Not of this radar alone: a sector waits until all radars have passed it.
  double newest = -1.0;
  for (const auto& [name, time] : newest_plots_) newest = std::max(newest, time);
  if (newest >= 0.0 && newest_plots_.count(radar) > 0) tracks_processing_.add(now - newest);
}

MetricList Timing::report() const {
  const double time = last_ - first_;
  MetricList metrics{{"plots_per_s", ratio(plots_, time)}, {"track_reports_per_s", ratio(tracks_, time)}};
  reportPercentiles(metrics, "plots_latency", plots_latency_);
  reportPercentiles(metrics, "tracks_latency", tracks_latency_);
  reportPercentiles(metrics, "tracks_processing", tracks_processing_);
  return metrics;
}

}  // namespace track_evaluation
