#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <tws_core/planar_gaussian.h>
#include <tws_core/units.h>

namespace tws {

/// What may be wrong with a radar: measured range = (1 + gain) · range + bias, measured azimuth = azimuth + bias +
/// sine · sin(azimuth) + cosine · cos(azimuth), stamp = time + clock offset.
enum RegistrationTerm : std::size_t {
  kRangeBias,      // [m]
  kRangeGain,      // [1]
  kAzimuthBias,    // [rad]
  kAzimuthSine,    // Of the eccentricity [rad].
  kAzimuthCosine,  // The same.
  kClockOffset,    // [s]
  kRegistrationTerms
};
/// One value a term.
using RegistrationTerms = std::array<double, kRegistrationTerms>;

/// By how much a radar with these errors measures too far [m] and too far clockwise [rad] at a place.
inline double rangeError(const RegistrationTerms& e, double range) { return e[kRangeBias] + e[kRangeGain] * range; }
double azimuthError(const RegistrationTerms& e, double azimuth);

enum class RegistrationMode { kOff, kOn, kFreeze };

enum class RegistrationState : std::uint8_t {
  kOff,           // Nothing is learned, nothing applied.
  kLearning,      // Too little has been seen yet.
  kApplied,       // What is significant is applied; it may be nothing.
  kFrozen,        // What was applied stays.
  kUnobservable,  // What was seen does not tell its errors apart from others.
  kTooLarge,      // An error is beyond what is corrected; nothing is applied.
  kDrifting       // As kApplied, and an error changes faster than slow drift does.
};

/// As told to users.
const char* nameOf(RegistrationState state);

struct RegistrationParams {
  RegistrationMode mode = RegistrationMode::kOn;
  // Of the errors, before anything is seen; how far they wander in an hour; larger ones are not applied; fastest change
  // of what is applied [1/s].
  RegistrationTerms sigma = {300.0, 5e-4, radians(1.0), radians(0.15), radians(0.15), 0.4};
  RegistrationTerms drift = {20.0, 5e-5, radians(0.2), radians(0.03), radians(0.03), 0.02};
  RegistrationTerms greatest = {3000.0, 0.01, radians(4.0), radians(1.0), radians(1.0), 3.0};
  RegistrationTerms rate = {20.0, 5e-5, radians(0.06), radians(0.03), radians(0.03), 0.02};
  double significance = 4.0;          // An error is applied from so many standard deviations on.
  double unobservable = 0.25;         // It must be known to this share of what was known of it before.
  double gate = 4.0;                  // A pairing further off, in standard deviations, is left out.
  double pairings_per_second = 20.0;  // No more are used.
  double settling_time = 15.0;        // Time constant with which what is applied follows [s].
  double learning_time = 120.0;       // After so long without a result a radar counts as unobservable [s].
};

/// How the place of a plot on the plane changes with each of its radar's errors [m per unit].
struct RegistrationRows {
  std::size_t radar = 0;
  RegistrationTerms x{}, y{};
};
/// Of a plot with that slant range, its share on the ground [m], azimuth at the site and on the plane [rad], of a
/// target with that velocity [m/s].
RegistrationRows registrationRows(std::size_t radar, double range, double ground, double azimuth, double on_plane,
                                  double vx, double vy);

/// Two radars placed one target differently at one instant, or one radar a known place.
struct RegistrationPairing {
  double time = 0.0;        // [s]
  double x = 0.0, y = 0.0;  // Place by the first, less that by the second or the known one [m].
  Symmetric2 covariance;    // Of that, without the errors of registration [m²].
  RegistrationRows first, second;
  bool absolute = false;  // The place is known; `second` does not count.
};

/// Joint recursive estimate of the errors of all radars, with its full covariance: a Kalman filter whose errors wander
/// slowly about zero. Whatever is not observable, as what radars at one site have in common, stays at what `sigma`
/// makes of it: the difference is split by their variances.
class RegistrationFilter {
 public:
  RegistrationFilter(std::size_t radars, const RegistrationParams& params);

  /// Time goes on by `dt` [s].
  void advance(double dt);
  /// False: it is too far off, and left out.
  bool add(const RegistrationPairing& pairing);
  /// Nothing is known of a radar's errors any more but `sigma`.
  void forget(std::size_t radar);

  std::size_t radars() const { return static_cast<std::size_t>(mean_.size()) / kRegistrationTerms; }
  RegistrationTerms errors(std::size_t radar) const;
  RegistrationTerms sigmas(std::size_t radar) const;
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Throws std::invalid_argument when sizes do not fit, values are not finite or no covariance.
  void load(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance);

  using Block = Eigen::Matrix<double, kRegistrationTerms, kRegistrationTerms>;
  /// The covariance of a radar's errors.
  Block block(std::size_t a, std::size_t b) const;
  /// The covariance that its estimate would have if no radar had any errors: what significance is measured against. The
  /// uncertainty of what cannot be observed is not in it.
  Block noise(std::size_t radar) const;
  Block prior() const { return prior_.asDiagonal(); }

 private:
  RegistrationParams params_;
  Eigen::Matrix<double, kRegistrationTerms, 1> prior_;  // variances
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
};

/// What is known of one radar, and what is done about it.
struct RegistrationReport {
  RegistrationState state = RegistrationState::kOff;
  RegistrationTerms errors{}, sigmas{}, applied{};
  std::array<double, 3> known{1.0, 1.0, 1.0};  // share of the first uncertainty left: range, azimuth, clock
  bool relative_only = false;                  // known against another radar, not in absolute terms
  std::uint64_t pairings = 0, rejected = 0;
};

/// Decides what of the estimate is applied.
class Registration {
 public:
  Registration(std::size_t radars, const RegistrationParams& params);

  /// Data time goes on, also backwards by a little [s].
  void advance(double time);
  /// Takes a pairing in, unless there were enough of late. True: it was used.
  bool add(const RegistrationPairing& pairing);
  /// Are pairings of any use just now?
  bool wantsPairing(double time) const;

  void setMode(RegistrationMode mode);
  RegistrationMode mode() const { return mode_; }

  /// Of a radar, to be taken out of its plots.
  const RegistrationTerms& applied(std::size_t radar) const { return reports_[radar].applied; }
  const std::vector<RegistrationReport>& reports() const { return reports_; }
  const RegistrationFilter& filter() const { return filter_; }
  /// Goes on from another run.
  void load(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance);

 private:
  void judge();
  void judgeRadar(std::size_t radar);
  std::array<double, 3> knownOf(std::size_t radar, const std::array<double, 3>& alone) const;
  bool isSignificant(std::size_t radar, std::size_t group, const RegistrationFilter::Block& own,
                     const RegistrationFilter::Block& noise) const;
  bool isDrifting(std::size_t radar, const RegistrationFilter::Block& noise, bool observable);
  RegistrationState stateOf(std::size_t radar, bool observable, bool too_large, bool drifting) const;
  void apply(double dt);
  void noteRejection(const RegistrationPairing& pairing, bool rejected);
  std::array<double, 3> sharesOf(const RegistrationFilter::Block& left, double times) const;

  struct Radar {
    std::array<bool, 3> significant{};
    RegistrationTerms wanted{}, earlier{};
    double first_time = 0.0, earlier_time = 0.0, rejection = 0.0;
    std::vector<std::uint64_t> partners;  // pairings with each
  };

  RegistrationParams params_;
  RegistrationMode mode_;
  RegistrationFilter filter_;
  std::vector<RegistrationReport> reports_;
  std::vector<Radar> radars_;
  bool started_ = false;
  double time_ = 0.0, judged_ = 0.0, tokens_ = 0.0;
};

}  // namespace tws
