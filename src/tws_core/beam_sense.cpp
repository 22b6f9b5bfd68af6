#include <tws_core/beam_sense.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/median.h>
#include <tws_core/units.h>

namespace tws {
namespace {

void sort(TimedAzimuths& plots) {
  const auto earlier = [](const TimedAzimuth& a, const TimedAzimuth& b) { return a.time < b.time; };
  if (!std::is_sorted(plots.begin(), plots.end(), earlier)) std::stable_sort(plots.begin(), plots.end(), earlier);
}

// How fast the beam goes from plot to plot [rad/s], < 0: counter-clockwise. Plots close together show it badly, those
// far apart may be of different scans.
std::vector<double> speedsOf(const TimedAzimuths& plots) {
  constexpr double kLeast = radians(2.0), kMost = radians(60.0);
  std::vector<double> speeds;
  for (std::size_t i = 1; i < plots.size(); ++i) {
    const double moved = angularDifference(plots[i].azimuth, plots[i - 1].azimuth);
    const double elapsed = plots[i].time - plots[i - 1].time;
    if (elapsed > 0.0 && std::abs(moved) > kLeast && std::abs(moved) < kMost) speeds.push_back(moved / elapsed);
  }
  return speeds;
}

double usualSpeed(std::vector<double> speeds) {
  for (double& speed : speeds) speed = std::abs(speed);
  return median(std::move(speeds));
}

// The share [0, 1] that is near the usual speed, in either sense.
double evenness(const std::vector<double>& speeds) {
  constexpr double kTimes = 1.5;
  const double usual = usualSpeed(speeds);
  const auto even = std::count_if(speeds.begin(), speeds.end(), [&](double speed) {
    return std::abs(speed) > usual / kTimes && std::abs(speed) < usual * kTimes;
  });
  return static_cast<double>(even) / static_cast<double>(speeds.size());
}

double shareBack(const std::vector<double>& speeds) {
  const auto back = std::count_if(speeds.begin(), speeds.end(), [](double speed) { return speed < 0.0; });
  return static_cast<double>(back) / static_cast<double>(speeds.size());
}

double shareOfReversals(const std::vector<double>& speeds) {
  std::size_t reversals = 0;
  for (std::size_t i = 1; i < speeds.size(); ++i) reversals += (speeds[i] < 0.0) != (speeds[i - 1] < 0.0) ? 1 : 0;
  return static_cast<double>(reversals) / static_cast<double>(speeds.size());
}

}  // namespace

bool scansToAndFro(TimedAzimuths plots) {
  constexpr std::size_t kFew = 20;
  constexpr double kMostEven = 0.75, kNearHalf = 0.35;
  constexpr double kFewReversals = 0.25, kClearly = 0.2;
  sort(plots);
  const std::vector<double> speeds = speedsOf(plots);
  if (speeds.size() < kFew) return false;
  const double back = shareBack(speeds);
  const double rarer = std::min(back, 1.0 - back);
  return (rarer > kNearHalf && evenness(speeds) > kMostEven) ||
         (rarer > kClearly && shareOfReversals(speeds) < kFewReversals);
}

std::string otherScanOf(TimedAzimuths plots) {
  sort(plots);
  char text[100];
  if (scansToAndFro(plots)) {
    std::snprintf(text, sizeof text, "the antenna scans to and fro, at about %.0f deg/s: that is not read",
                  degrees(usualSpeed(speedsOf(plots))));
    return text;
  }
  for (TimedAzimuth& plot : plots) plot.azimuth = kTwoPi - plot.azimuth;
  try {
    const double period = Rotation::fromPlots(std::move(plots)).period();
    std::snprintf(text, sizeof text, "the antenna turns counter-clockwise, once in %.3f s: that is not read", period);
    return text;
  } catch (const std::invalid_argument&) {
    return "";
  }
}

}  // namespace tws
