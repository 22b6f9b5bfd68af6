#include "range_radar.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

#include "propagation.h"

namespace radar_sim {
namespace {

std::size_t indexOf(const std::string& name, const std::vector<Target>& targets) {
  const auto found = std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.name == name; });
  if (found == targets.end()) throw std::invalid_argument("there is no target '" + name + "' to follow");
  return static_cast<std::size_t>(found - targets.begin());
}

/// Two-way amplitude gain of a round Gaussian beam off its axis, 1 on it.
double dishGain(double off_axis, double beamwidth) {
  const double widths = off_axis / beamwidth;
  return std::exp(-4.0 * std::log(2.0) * widths * widths);
}

/// Where the target's length points to, at the site; of one at rest: north.
Eigen::Vector3d courseOf(const TargetState& state, const Eigen::Isometry3d& map_to_site) {
  Eigen::Vector3d along(state.velocity.x(), state.velocity.y(), 0.0);
  if (along.norm() <= 0.0) along = Eigen::Vector3d::UnitY();
  return map_to_site.linear() * along.normalized();
}

double fourthPower(double x) { return x * x * x * x; }

}  // namespace

RangeRadar::RangeRadar(RangeRadarParams params, const Eigen::Isometry3d& map_to_site,
                       const std::vector<Target>& targets, std::vector<Fault> faults, std::uint64_t seed,
                       double start_time)
    : params_(std::move(params)),
      map_to_site_(map_to_site),
      targets_(targets),
      faults_(std::move(faults)),
      followed_(indexOf(params_.target, targets)),
      seed_(seed),
      start_time_(start_time),
      noise_stream_(RandomStream::hash(params_.name + "/noise")),
      clutter_stream_(RandomStream::hash(params_.name + "/clutter")) {
  for (const Target& target : targets)
    scatterers_.emplace_back(target, seed, RandomStream::hash(params_.name + "/" + target.name));
  point(start_time);
  openAtStart();
}

void RangeRadar::point(double time) {
  const Trajectory& path = *targets_[followed_].trajectory;
  if (path.existsAt(time)) axis_ = (map_to_site_ * path.at(time).position).normalized();
}

// Another sensor has told where the target is.
void RangeRadar::openAtStart() {
  const Trajectory& path = *targets_[followed_].trajectory;
  double centre = params_.start_range;
  const double first_seen = path.nextExistence(start_time_);
  if (std::isnan(centre))
    centre = std::isfinite(first_seen) ? (map_to_site_ * path.at(first_seen).position).norm() : params_.min_range;
  const double half = 0.5 * params_.gate_length;
  centre = std::clamp(centre, params_.min_range + half, params_.max_range - half);
  setGate({centre - half, centre + half});
}

bool RangeRadar::setGate(RangeGate gate) {
  if (!(gate.max > gate.min) || !std::isfinite(gate.min) || !std::isfinite(gate.max)) return false;
  const double min = std::max(gate.min, params_.min_range), max = std::min(gate.max, params_.max_range);
  const auto first = std::llround(min / params_.bin_size), last = std::llround(max / params_.bin_size);
  constexpr long kMostBins = 100000;
  if (last <= first || last - first > kMostBins) return false;
  first_bin_ = first;
  echo_.resize(static_cast<std::size_t>(last - first));
  return true;
}

AmplitudeProfile RangeRadar::takeProfile() {
  AmplitudeProfile profile;
  profile.time = timeOf(next_);
  profile.number = next_;
  profile.range_min = static_cast<double>(first_bin_) * params_.bin_size;
  point(profile.time);
  profile.azimuth = tws::polarFromEnu(axis_).azimuth;
  std::fill(echo_.begin(), echo_.end(), 0.0);
  addTargets(profile.time);
  addNoise(profile);
  ++next_;
  return profile;
}

void RangeRadar::addTargets(double time) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Trajectory& path = *targets_[i].trajectory;
    if (!path.existsAt(time)) continue;
    scatterers_[i].fade(next_, 1.0 / params_.profile_rate);
    const TargetState state = path.at(time);
    const Eigen::Vector3d place = map_to_site_ * state.position;
    if (isBeyondHorizon(params_.antenna_height, state.height, place.norm())) continue;
    const Eigen::Vector3d direction = place.normalized();
    const double gain = dishGain(std::acos(std::clamp(direction.dot(axis_), -1.0, 1.0)), params_.beamwidth);
    const double foreshortening = direction.dot(courseOf(state, map_to_site_));
    for (const Scatterers::Scatterer& scatterer : scatterers_[i].all()) {
      const double range = place.norm() + scatterer.offset * foreshortening;
      const double phase =
          scatterer.phase - 2.0 * tws::kTwoPi * std::fmod(range, params_.wavelength) / params_.wavelength;
      addEcho(range, gain * scatterers_[i].amplitude(scatterer) * std::polar(1.0, phase));
    }
  }
}

// A Gaussian response whose squares add up to 1.
void RangeRadar::addEcho(double range, std::complex<double> echo) {
  constexpr double kSigmasInHalfPowerWidth = 2.3548200450309493;  // 2 sqrt(2 ln 2)
  constexpr double kCutOff = 5.0;                                 // standard deviations of the power
  const double sigma = params_.resolution / kSigmasInHalfPowerWidth;
  const double height = std::sqrt(params_.bin_size / (std::sqrt(tws::kTwoPi) * sigma));
  const double bin = range / params_.bin_size - 0.5 - static_cast<double>(first_bin_);
  const double reach = kCutOff * sigma / params_.bin_size;
  const double last = static_cast<double>(echo_.size()) - 1.0;
  if (bin + reach < 0.0 || bin - reach > last) return;
  const auto from = static_cast<std::size_t>(std::max(0.0, std::ceil(bin - reach)));
  const auto to = static_cast<std::size_t>(std::min(last, std::floor(bin + reach)));
  const double centre = (static_cast<double>(first_bin_) + 0.5 * static_cast<double>(echo_.size())) * params_.bin_size;
  const double ratio = centre / range;
  const std::complex<double> calibrated = echo * ratio * ratio;
  for (std::size_t i = from; i <= to; ++i) {
    const double away = (static_cast<double>(i) - bin) * params_.bin_size / sigma;
    echo_[i] += calibrated * height * std::exp(-0.25 * away * away);
  }
}

void RangeRadar::addNoise(AmplitudeProfile& profile) {
  RandomStream random(seed_, noise_stream_, next_);
  std::normal_distribution<> normal;
  const double centre = profile.range_min + 0.5 * static_cast<double>(echo_.size()) * params_.bin_size;
  const double noise = params_.noise_rcs * fourthPower(centre / params_.noise_range);
  const double patch_bins = params_.sea_clutter.patch_length / params_.bin_size;
  double patch = -1.0, clutter = 0.0;
  profile.amplitude.reserve(echo_.size());
  for (std::size_t i = 0; i < echo_.size(); ++i) {
    const double range = profile.range_min + (static_cast<double>(i) + 0.5) * params_.bin_size;
    const double here = std::floor(static_cast<double>(first_bin_ + static_cast<std::int64_t>(i)) / patch_bins);
    if (here != patch) clutter = clutterOn(patch = here, profile.time);
    const double sigma = std::sqrt(0.5 * (noise + clutter * range * fourthPower(centre / range)));
    const double in_phase = echo_[i].real() + sigma * normal(random);
    const double quadrature = echo_[i].imag() + sigma * normal(random);
    profile.amplitude.push_back(static_cast<float>(std::hypot(in_phase, quadrature)));
  }
}

// Cross-section of one bin of sea a metre of range: σ0 times its area, times the patch's share, gamma of mean 1.
double RangeRadar::clutterOn(double patch, double time) const {
  const GateSeaClutter& sea = params_.sea_clutter;
  const double mean = sea.sigma0 * params_.beamwidth * params_.bin_size;
  if (std::isinf(sea.shape) || mean <= 0.0) return mean;
  const auto epoch = static_cast<std::uint64_t>((time - start_time_) / sea.patch_time);
  RandomStream random(seed_, clutter_stream_, (epoch << 32U) | static_cast<std::uint64_t>(patch));
  return mean * std::gamma_distribution<>(sea.shape, 1.0 / sea.shape)(random);
}

}  // namespace radar_sim
