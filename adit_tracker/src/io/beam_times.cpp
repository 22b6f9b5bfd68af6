#include "io/beam_times.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <tws_core/beam_sense.h>
#include <tws_core/clock_steps.h>
#include <tws_core/coarse_times.h>
#include <tws_core/median.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

using Plots = std::vector<tws::Plot>;
using Points = std::vector<tws::TimedAzimuth>;
using Say = std::function<void(const std::string&)>;

Points pointsOf(const Plots& plots) {
  Points points;
  points.reserve(plots.size());
  for (const tws::Plot& plot : plots) points.push_back({plot.time, plot.azimuth});
  return points;
}

void sort(Plots& plots) {
  std::stable_sort(plots.begin(), plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
}

std::string sentence(const char* format, double a, double b = 0.0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

// Why the beam is not known, and what to do.
std::string reasonOf(const std::string& error, const RadarSpec& spec, const Points& points) {
  constexpr double kSteps = 2.5, kCoarse = 0.1;
  std::string reason = "radar " + spec.id + ": ";
  const std::string other = tws::otherScanOf(points);
  if (!other.empty()) return reason + other;
  reason += error;
  if (const double step = tws::commonStep(points); step > kCoarse)
    reason +=
        sentence("; its times are whole steps of %g s: turns of less than %g s are not found", step, kSteps * step);
  return reason + "; give --radar " + spec.id + ":PERIOD_S:PHASE_DEG";
}

tws::Rotation learned(const RadarSpec& spec, const Points& points) {
  try {
    return spec.period > 0.0 ? tws::Rotation::fromPlots(points, spec.period) : tws::Rotation::fromPlots(points);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(reasonOf(error.what(), spec, points));
  }
}

void sayStep(const tws::ClockStep& step, const Say& say) {
  const char* const format = step.step > 0.0
                                 ? "after %.1f s its clock was put forward by %.2f s; the times go on as if it had not"
                                 : "after %.1f s its clock was put back by %.2f s; the times go on as if it had not";
  say(sentence(format, step.time, std::abs(step.step)));
}

tws::Rotation undoClockSteps(const RadarSpec& spec, Plots& plots, tws::Rotation rotation, const Say& say) {
  if (rotation.breaks().empty()) return rotation;
  const tws::ClockSteps found = tws::findClockSteps(pointsOf(plots), rotation);
  if (found.steps.empty()) return rotation;
  for (const tws::ClockStep& step : found.steps) sayStep(step, say);
  for (std::size_t i = 0; i < plots.size(); ++i) plots[i].time += found.corrections[i];
  sort(plots);
  return learned(spec, pointsOf(plots));
}

// The median of how far they are from their median.
double scatterOf(std::vector<double> values) {
  const double middle = tws::median(values);
  for (double& value : values) value = std::abs(value - middle);
  return tws::median(std::move(values));
}

// Times in steps, of which the beam takes less for a sector, become those at which it was at the plots, and `later`
// [s]. Those that are exact in spite of their steps stay: of targets that fly towards the radar.
bool refine(Plots& plots, const tws::Rotation& rotation, double step, double later, const Say& say) {
  if (!(step > rotation.period() / tws::kSectors)) return false;
  std::vector<double> shifts = tws::refinedTimes(pointsOf(plots), rotation, step);
  for (std::size_t i = 0; i < plots.size(); ++i) shifts[i] -= plots[i].time;
  if (scatterOf(shifts) < step / 10.0) return false;
  for (std::size_t i = 0; i < plots.size(); ++i) plots[i].time += shifts[i] + later;
  sort(plots);
  say(sentence("its times are whole steps of %g s; they are refined by the beam's azimuth", step));
  return true;
}

tws::Rotation learnFrom(const RadarSpec& spec, Plots& plots, const Say& say) {
  tws::Rotation rotation = undoClockSteps(spec, plots, learned(spec, pointsOf(plots)), say);
  // It goes through the plots' times: the middle of what they stand for is half a step later.
  const double step = tws::commonStep(pointsOf(plots));
  if (refine(plots, rotation, step, step / 2.0, say)) rotation = learned(spec, pointsOf(plots));
  for (const auto& at : rotation.breaks()) say(sentence("beam break at %.1f s: another speed or phase", at.time));
  return rotation;
}

}  // namespace

tws::Rotation learnBeam(const RadarSpec& spec, Plots& plots, const Say& say) {
  if (spec.period > 0.0 && std::isnan(spec.phase)) return learnFrom(spec, plots, say);
  const Points points = pointsOf(plots);
  const double step = tws::commonStep(points);
  if (!std::isnan(spec.phase)) {
    if (tws::scansToAndFro(points)) throw std::runtime_error(reasonOf("", spec, points));
    tws::Rotation rotation = tws::Rotation::uniform(spec.period, spec.phase);
    refine(plots, rotation, step, 0.0, say);
    return rotation;
  }
  if (const auto rotation = tws::rotationOfWholeScans(points)) {
    say(sentence("all plots of a scan have one time, each %g s; the beam is taken to point north at it", step));
    refine(plots, *rotation, step, 0.0, say);
    return *rotation;
  }
  return learnFrom(spec, plots, say);
}

}  // namespace adit_tracker
