#include "io/scan_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/instant.h>
#include <tws_core/median.h>

namespace adit_tracker {
namespace {

constexpr double kFastest = 700.0;          // of a target from scan to scan [m/s]
constexpr std::size_t kLag = 3;             // scans between plots that are compared: away from north and its errors
constexpr double kMedianOfNormal = 0.6745;  // of its size, in standard deviations
constexpr double kMostMisfit = 25.0;        // of one crossing: it may be of two targets
constexpr double kSure = 4.0;               // twice the logarithm of how much likelier the beam must be
constexpr std::size_t kMostScans = 500;     // that are looked at
constexpr std::size_t kMostPlots = 400;     // of a scan near north: each is compared with each
constexpr double kNorth = tws::kPi / 6.0;   // on either side: who is there may cross it

/// A plot near north: its time by a beam from north, and its place.
struct Seen {
  double time;  // within its scan, in scans
  Eigen::Vector2d place;
};
using Scan = std::vector<Seen>;

struct Scans {
  std::vector<double> times;
  std::vector<Scan> scans;
};

Scan nearNorth(std::vector<tws::Plot>::const_iterator first, std::vector<tws::Plot>::const_iterator last) {
  Scan scan;
  for (auto plot = first; plot != last && scan.size() < kMostPlots; ++plot) {
    if (std::abs(tws::wrapPi(plot->azimuth)) > kNorth) continue;
    const Eigen::Vector2d direction(std::sin(plot->azimuth), std::cos(plot->azimuth));
    scan.push_back({plot->azimuth / tws::kTwoPi, plot->range * direction});
  }
  return scan;
}

Scans scansOf(const std::vector<tws::Plot>& plots) {
  Scans all;
  for (auto first = plots.begin(); first != plots.end() && all.times.size() < kMostScans;) {
    const auto last = tws::endOfInstant(first, plots.end());
    all.times.push_back(first->time);
    all.scans.push_back(nearNorth(first, last));
    first = last;
  }
  return all;
}

const Seen* nearest(const Scan& scan, const Eigen::Vector2d& place, double farthest) {
  const Seen* best = nullptr;
  for (const Seen& seen : scan) {
    const double distance = (seen.place - place).norm();
    if (distance < farthest) best = &seen, farthest = distance;
  }
  return best;
}

/// The same target kLag scans later, from scan to scan; nothing: it is lost.
const Seen* follow(const Scans& all, std::size_t scan, const Seen& first, double step) {
  const Seen* seen = &first;
  for (std::size_t later = 1; later <= kLag && seen != nullptr; ++later)
    seen = nearest(all.scans[scan + later], seen->place, step);
  return seen;
}

/// How far three plots of one target are from an even motion, along the beam [m] and across it [rad], by what one
/// plot's error would be.
struct Unevenness {
  double along, across;
};

/// `before`, `after`: the times between the plots [scans].
Unevenness unevenness(const Seen& a, const Seen& b, const Seen& c, double before, double after) {
  const Eigen::Vector2d off = ((c.place - b.place) * before - (b.place - a.place) * after) /
                              std::sqrt(before * before + after * after + (before + after) * (before + after));
  const double range = b.place.norm();
  const Eigen::Vector2d beam = b.place / range;
  return {off.dot(beam), (off.x() * beam.y() - off.y() * beam.x()) / range};
}

double fromNorth(const Seen& seen) { return std::abs(std::atan2(seen.place.x(), seen.place.y())); }

/// What targets show that stay on their side of north (the errors of the plots), and those that cross it.
struct Evidence {
  struct Crossing {
    Unevenness at_once, by_beam;
    double from_north;  // of the nearest of the three plots [rad]: errors must not carry it over
  };
  std::vector<double> along, across;
  std::vector<Crossing> crossings;

  void add(const Seen& a, const Seen& b, const Seen& c) {
    const double before = kLag + b.time - a.time, after = kLag + c.time - b.time;
    const Unevenness at_once = unevenness(a, b, c, kLag, kLag);
    if (std::abs(before - after) > 0.5) {
      crossings.push_back(
          {at_once, unevenness(a, b, c, before, after), std::min({fromNorth(a), fromNorth(b), fromNorth(c)})});
    } else {
      along.push_back(std::abs(at_once.along));
      across.push_back(std::abs(at_once.across));
    }
  }

  /// The motion of those that cross is likelier by the beam.
  bool isByBeam() const {
    if (along.empty()) return false;
    const double along_error = tws::median(along) / kMedianOfNormal;
    const double across_error = tws::median(across) / kMedianOfNormal;
    const auto misfit = [&](const Unevenness& it) {
      return std::min(std::pow(it.along / along_error, 2) + std::pow(it.across / across_error, 2), kMostMisfit);
    };
    double more = 0.0;
    for (const Crossing& crossing : crossings) {
      if (crossing.from_north > 3.0 * across_error) more += misfit(crossing.at_once) - misfit(crossing.by_beam);
    }
    return more > kSure;
  }
};

}  // namespace

bool moveWithTheBeam(const std::vector<tws::Plot>& plots, double period) {
  const Scans all = scansOf(plots);
  Evidence evidence;
  for (std::size_t k = 0; k + 2 * kLag < all.scans.size(); ++k) {
    if (all.times[k + 2 * kLag] - all.times[k] > (2 * kLag + 0.02) * period) continue;
    for (const Seen& a : all.scans[k]) {
      const Seen* const b = follow(all, k, a, kFastest * period);
      const Seen* const c = b != nullptr ? follow(all, k + kLag, *b, kFastest * period) : nullptr;
      if (c != nullptr) evidence.add(a, *b, *c);
    }
  }
  return evidence.isByBeam();
}

}  // namespace adit_tracker
