#include "tws_core/registration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>

#include <tws_core/angles.h>

namespace tws {
namespace {

using Block = RegistrationFilter::Block;
constexpr Eigen::Index kTerms = kRegistrationTerms;

Eigen::Index indexOf(std::size_t radar) { return static_cast<Eigen::Index>(radar) * kTerms; }

struct Group {
  Eigen::Index first, size;
};
constexpr std::array<Group, 3> kGroups{Group{kRangeBias, 2}, Group{kAzimuthBias, 3}, Group{kClockOffset, 1}};

double varianceAlong(const Block& covariance, const Eigen::Matrix<double, kTerms, 1>& direction) {
  return direction.dot(covariance * direction);
}

}  // namespace

const char* nameOf(RegistrationState state) {
  switch (state) {
    case RegistrationState::kOff:
      return "off";
    case RegistrationState::kLearning:
      return "learning";
    case RegistrationState::kApplied:
      return "applied";
    case RegistrationState::kFrozen:
      return "frozen";
    case RegistrationState::kUnobservable:
      return "unobservable";
    case RegistrationState::kTooLarge:
      return "too large";
    case RegistrationState::kDrifting:
      return "drifting";
  }
  return "";
}

double azimuthError(const RegistrationTerms& e, double azimuth) {
  double error = e[kAzimuthBias];
  if (e[kAzimuthSine] != 0.0) error += e[kAzimuthSine] * std::sin(azimuth);
  if (e[kAzimuthCosine] != 0.0) error += e[kAzimuthCosine] * std::cos(azimuth);
  return error;
}

RegistrationRows registrationRows(std::size_t radar, double range, double ground, double azimuth, double on_plane,
                                  double vx, double vy) {
  constexpr double kSteepest = 2.0;  // of slant range to ground range: steeper ones tell nothing
  const double s = std::sin(on_plane), c = std::cos(on_plane), slope = std::min(range / ground, kSteepest);
  RegistrationRows rows;
  rows.radar = radar;
  rows.x = {slope * s, slope * s * range, ground * c, ground * c * std::sin(azimuth), ground * c * std::cos(azimuth),
            -vx};
  rows.y = {slope * c, slope * c * range, -ground * s, -ground * s * std::sin(azimuth), -ground * s * std::cos(azimuth),
            -vy};
  return rows;
}

RegistrationFilter::RegistrationFilter(std::size_t radars, const RegistrationParams& params) : params_(params) {
  const Eigen::Index n = indexOf(radars);
  mean_ = Eigen::VectorXd::Zero(n);
  covariance_ = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < kTerms; ++i) {
    const double sigma = params.sigma[static_cast<std::size_t>(i)];
    prior_[i] = sigma * sigma;
  }
  for (Eigen::Index i = 0; i < n; ++i) covariance_(i, i) = prior_[i % kTerms];
}

/// Errors wander such that they would be as large as `sigma` in the long run.
void RegistrationFilter::advance(double dt) {
  constexpr double kHour = 3600.0;
  Eigen::VectorXd keep(mean_.size());
  for (Eigen::Index i = 0; i < mean_.size(); ++i) {
    const double drift = params_.drift[static_cast<std::size_t>(i % kTerms)];
    keep[i] = prior_[i % kTerms] > 0.0 ? std::exp(-0.5 * dt / kHour * drift * drift / prior_[i % kTerms]) : 0.0;
  }
  mean_.array() *= keep.array();
  covariance_ = keep.asDiagonal() * covariance_ * keep.asDiagonal();
  for (Eigen::Index i = 0; i < mean_.size(); ++i) covariance_(i, i) += (1.0 - keep[i] * keep[i]) * prior_[i % kTerms];
}

bool RegistrationFilter::add(const RegistrationPairing& pairing) {
  const Eigen::Index a = indexOf(pairing.first.radar), b = indexOf(pairing.second.radar);
  Eigen::Matrix<double, 2, kTerms> of_first, of_second;
  for (Eigen::Index i = 0; i < kTerms; ++i) {
    const auto term = static_cast<std::size_t>(i);
    of_first.col(i) << pairing.first.x[term], pairing.first.y[term];
    of_second.col(i) << pairing.second.x[term], pairing.second.y[term];
  }
  Eigen::MatrixXd cross = covariance_.middleCols(a, kTerms) * of_first.transpose();  // P Hᵀ
  if (!pairing.absolute) cross -= covariance_.middleCols(b, kTerms) * of_second.transpose();
  Eigen::Matrix2d innovation = of_first * cross.middleRows(a, kTerms);
  Eigen::Vector2d z(pairing.x, pairing.y);
  z -= of_first * mean_.segment(a, kTerms);
  if (!pairing.absolute) {
    innovation -= of_second * cross.middleRows(b, kTerms);
    z += of_second * mean_.segment(b, kTerms);
  }
  innovation(0, 0) += pairing.covariance.xx;
  innovation(1, 1) += pairing.covariance.yy;
  innovation(0, 1) += pairing.covariance.xy;
  innovation(1, 0) = innovation(0, 1);
  const double determinant = innovation(0, 0) * innovation(1, 1) - innovation(0, 1) * innovation(1, 0);
  if (!(determinant > 0.0) || !z.allFinite()) return false;
  Eigen::Matrix2d inverse;
  inverse << innovation(1, 1), -innovation(0, 1), -innovation(0, 1), innovation(0, 0);
  inverse /= determinant;
  if (z.dot(inverse * z) > params_.gate * params_.gate) return false;
  const Eigen::MatrixXd gain = cross * inverse;
  mean_ += gain * z;
  covariance_.noalias() -= gain * cross.transpose();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
  return true;
}

void RegistrationFilter::forget(std::size_t radar) {
  const Eigen::Index a = indexOf(radar);
  covariance_.middleRows(a, kTerms).setZero();
  covariance_.middleCols(a, kTerms).setZero();
  covariance_.block(a, a, kTerms, kTerms) = prior();
}

RegistrationTerms RegistrationFilter::errors(std::size_t radar) const {
  RegistrationTerms errors{};
  for (std::size_t i = 0; i < kRegistrationTerms; ++i) errors[i] = mean_[indexOf(radar) + static_cast<Eigen::Index>(i)];
  return errors;
}

RegistrationTerms RegistrationFilter::sigmas(std::size_t radar) const {
  RegistrationTerms sigmas{};
  const Block own = block(radar, radar);
  for (std::size_t i = 0; i < kRegistrationTerms; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    sigmas[i] = std::sqrt(std::max(0.0, own(k, k)));
  }
  return sigmas;
}

void RegistrationFilter::load(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance) {
  if (mean.size() != mean_.size() || covariance.rows() != mean.size() || covariance.cols() != mean.size())
    throw std::invalid_argument("errors of registration: wrong number of values");
  if (!mean.allFinite() || !covariance.allFinite() || covariance.llt().info() != Eigen::Success ||
      !covariance.isApprox(covariance.transpose(), 1e-6))
    throw std::invalid_argument("errors of registration: the covariance is none");
  mean_ = mean;
  covariance_ = 0.5 * (covariance + covariance.transpose());
}

RegistrationFilter::Block RegistrationFilter::block(std::size_t a, std::size_t b) const {
  return covariance_.block(indexOf(a), indexOf(b), kTerms, kTerms);
}

/// x̂ = P Hᵀ R⁻¹ z, and Hᵀ R⁻¹ H = P⁻¹ - P₀⁻¹: without errors, cov x̂ = P - P P₀⁻¹ P.
RegistrationFilter::Block RegistrationFilter::noise(std::size_t radar) const {
  const Eigen::MatrixXd rows = covariance_.middleRows(indexOf(radar), kTerms);
  Eigen::MatrixXd weighed = rows;
  for (Eigen::Index i = 0; i < weighed.cols(); ++i) weighed.col(i) /= prior_[i % kTerms];
  return block(radar, radar) - weighed * rows.transpose();
}

Registration::Registration(std::size_t radars, const RegistrationParams& params)
    : params_(params), mode_(params.mode), filter_(radars, params), reports_(radars), radars_(radars) {
  for (Radar& radar : radars_) radar.partners.assign(radars, 0);
  judge();
}

void Registration::setMode(RegistrationMode mode) {
  mode_ = mode;
  judge();
}

void Registration::load(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance) {
  filter_.load(mean, covariance);
  // What was known before is known: from pairings with all.
  for (std::size_t a = 0; a < radars_.size(); ++a)
    for (std::size_t b = 0; b < radars_.size(); ++b) radars_[a].partners[b] += a == b ? 0 : 1;
  judge();
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (mode_ != RegistrationMode::kOff) reports_[radar].applied = radars_[radar].wanted;
  }
}

void Registration::advance(double time) {
  constexpr double kJudgeEach = 1.0, kBurst = 2.0;  // [s]
  if (!started_) {
    started_ = true;
    time_ = judged_ = time;
    for (Radar& radar : radars_) radar.first_time = radar.earlier_time = time;
  }
  const double dt = time - time_;
  if (dt <= 0.0) return;
  time_ = time;
  tokens_ = std::min(tokens_ + dt * params_.pairings_per_second, kBurst * params_.pairings_per_second);
  if (time - judged_ < kJudgeEach) return;
  const double since = std::min(time - judged_, 60.0);
  filter_.advance(time - judged_);
  judged_ = time;
  judge();
  if (mode_ != RegistrationMode::kFreeze) apply(since);
}

bool Registration::wantsPairing(double time) const {
  return mode_ != RegistrationMode::kOff && tokens_ >= 1.0 && std::abs(time - time_) < 60.0;
}

bool Registration::add(const RegistrationPairing& pairing) {
  if (!wantsPairing(pairing.time)) return false;
  tokens_ -= 1.0;
  const bool used = filter_.add(pairing);
  noteRejection(pairing, !used);
  if (!used) return false;
  const std::size_t a = pairing.first.radar, b = pairing.second.radar;
  ++reports_[a].pairings;
  if (pairing.absolute) return true;
  ++reports_[b].pairings;
  ++radars_[a].partners[b];
  ++radars_[b].partners[a];
  return true;
}

/// Where most pairings are far off, a radar has changed: what was known of it is none any more.
void Registration::noteRejection(const RegistrationPairing& pairing, bool rejected) {
  constexpr double kMemory = 100.0, kMost = 0.6;
  const auto note = [&](std::size_t radar) {
    Radar& r = radars_[radar];
    if (rejected) ++reports_[radar].rejected;
    r.rejection += ((rejected ? 1.0 : 0.0) - r.rejection) / kMemory;
    if (r.rejection < kMost) return;
    filter_.forget(radar);
    r.rejection = 0.0;
    r.first_time = r.earlier_time = time_;
  };
  note(pairing.first.radar);
  if (!pairing.absolute) note(pairing.second.radar);
}

/// Of range, azimuth and clock, which share of the first uncertainty (`times` its variance) is left at the worst place.
std::array<double, 3> Registration::sharesOf(const Block& left, double times) const {
  constexpr std::array<double, 2> kRanges{20e3, 100e3};
  constexpr int kAzimuths = 8;
  const Block before = times * filter_.prior();
  std::array<double, 3> shares{};
  using Direction = Eigen::Matrix<double, kTerms, 1>;
  const auto look = [&](double& share, const Direction& direction) {
    const double was = varianceAlong(before, direction);
    if (was > 0.0) share = std::max(share, std::sqrt(std::max(0.0, varianceAlong(left, direction)) / was));
  };
  for (const double range : kRanges) look(shares[0], (Direction() << 1.0, range, 0.0, 0.0, 0.0, 0.0).finished());
  for (int i = 0; i < kAzimuths; ++i) {
    const double azimuth = kTwoPi * i / kAzimuths;
    look(shares[1], (Direction() << 0.0, 0.0, 1.0, std::sin(azimuth), std::cos(azimuth), 0.0).finished());
  }
  look(shares[2], (Direction() << 0.0, 0.0, 0.0, 0.0, 0.0, 1.0).finished());
  return shares;
}

void Registration::judge() {
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) judgeRadar(radar);
}

void Registration::judgeRadar(std::size_t radar) {
  Radar& r = radars_[radar];
  RegistrationReport& report = reports_[radar];
  report.errors = filter_.errors(radar);
  report.sigmas = filter_.sigmas(radar);
  r.wanted = {};
  if (mode_ == RegistrationMode::kOff) {
    report.state = RegistrationState::kOff;
    return;
  }
  const Block own = filter_.block(radar, radar), noise = filter_.noise(radar);
  const std::array<double, 3> alone = sharesOf(own, 1.0);
  report.known = knownOf(radar, alone);
  report.relative_only = false;
  bool any = false;
  for (std::size_t g = 0; g < kGroups.size(); ++g) {
    const bool observable = report.known[g] < params_.unobservable;
    any = any || observable;
    report.relative_only = report.relative_only || (observable && alone[g] > 2.0 * params_.unobservable);
    r.significant[g] = observable && isSignificant(radar, g, own, noise);
    const auto [first, size] = kGroups[g];
    for (auto i = static_cast<std::size_t>(first); r.significant[g] && i < static_cast<std::size_t>(first + size); ++i)
      r.wanted[i] = report.errors[i];
  }
  bool too_large = false;
  for (std::size_t i = 0; i < kRegistrationTerms; ++i)
    too_large = too_large || std::abs(r.wanted[i]) > params_.greatest[i];
  if (too_large) r.wanted = {};
  const bool drifting = isDrifting(radar, noise, any);
  report.state = stateOf(radar, any, too_large, drifting);
}

/// Against the radar that tells most, if not against true places.
std::array<double, 3> Registration::knownOf(std::size_t radar, const std::array<double, 3>& alone) const {
  std::array<double, 3> known = alone;
  const Block own = filter_.block(radar, radar);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (radars_[radar].partners[other] == 0) continue;
    const Block across = filter_.block(radar, other);
    const auto against = sharesOf(own - across - across.transpose() + filter_.block(other, other), 2.0);
    for (std::size_t g = 0; g < kGroups.size(); ++g) known[g] = std::min(known[g], against[g]);
  }
  return known;
}

/// Is a group of errors further from 0 than noise explains? What has been taken out stays so for longer.
bool Registration::isSignificant(std::size_t radar, std::size_t group, const Block& own, const Block& noise) const {
  const auto [first, size] = kGroups[group];
  Eigen::VectorXd value(size);
  for (Eigen::Index i = 0; i < size; ++i) value[i] = reports_[radar].errors[static_cast<std::size_t>(first + i)];
  Eigen::MatrixXd spread = noise.block(first, first, size, size);
  for (Eigen::Index i = 0; i < size; ++i) spread(i, i) += 1e-9 * own(first + i, first + i);
  const double squared = value.dot(spread.ldlt().solve(value)) - static_cast<double>(size - 1);
  const double least = (radars_[radar].significant[group] ? 0.5 : 1.0) * params_.significance;
  return squared > least * least;
}

/// Has an error changed since a while ago, beyond the noise? It is looked at from time to time.
bool Registration::isDrifting(std::size_t radar, const Block& noise, bool observable) {
  constexpr double kLookBack = 120.0;  // [s]
  Radar& r = radars_[radar];
  const RegistrationReport& report = reports_[radar];
  if (time_ - r.earlier_time < kLookBack) return report.state == RegistrationState::kDrifting;
  bool drifting = false;
  for (std::size_t i = 0; i < kRegistrationTerms && observable; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double step = std::abs(report.errors[i] - r.earlier[i]);
    drifting = drifting || (time_ - r.first_time > 2.5 * kLookBack && step * step > 16.0 * std::max(0.0, noise(k, k)) &&
                            step > 0.5 * params_.drift[i]);
  }
  r.earlier = report.errors;
  r.earlier_time = time_;
  return drifting;
}

RegistrationState Registration::stateOf(std::size_t radar, bool observable, bool too_large, bool drifting) const {
  if (mode_ == RegistrationMode::kFreeze) return RegistrationState::kFrozen;
  if (too_large) return RegistrationState::kTooLarge;
  if (observable) return drifting ? RegistrationState::kDrifting : RegistrationState::kApplied;
  const bool early = time_ - radars_[radar].first_time < params_.learning_time;
  return early ? RegistrationState::kLearning : RegistrationState::kUnobservable;
}

/// Slowly, so that tracks follow.
void Registration::apply(double dt) {
  const double share = 1.0 - std::exp(-dt / params_.settling_time);
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    for (std::size_t i = 0; i < kRegistrationTerms; ++i) {
      double& applied = reports_[radar].applied[i];
      const double most = params_.rate[i] * dt, wanted = radars_[radar].wanted[i];
      applied += std::clamp(share * (wanted - applied), -most, most);
      if (wanted == 0.0 && std::abs(applied) < 1e-3 * params_.drift[i]) applied = 0.0;
    }
  }
}

}  // namespace tws
