#include "core/track_life.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr float kGreatestChance = 0.99999F;
// How fast a track learns its own chance of detection, and between what limits.
constexpr float kDetectionGain = 0.1F;
constexpr float kLeastDetection = 0.3F, kGreatestDetection = 0.97F;

/// Where the radar sees little of anything, a miss says little of the track.
void learnDetection(Track& track, std::size_t radar, float detected) {
  float& p = track.detection_probability[radar];
  const float expected = p * track.predicted.cover;
  p = std::clamp(p + kDetectionGain * (detected - expected), kLeastDetection, kGreatestDetection);
}

/// By its filter, with one standard deviation to spare.
bool isSurelyAsFast(const Track& track, double speed, const tws::MultipleModelParams& params) {
  const tws::PlanarMotion now = std::get<tws::MultipleModelFilter>(track.filter).predict(0.0, params);
  const double sigma = std::sqrt(std::max(now.velocity.xx, now.velocity.yy));
  return std::hypot(now.vx, now.vy) - sigma >= speed;
}

/// Bayes: the chance after evidence with this ratio of likelihoods.
float byBayes(float chance, double ratio) {
  const double odds = ratio * chance / (1.0 - chance);
  return std::min(kGreatestChance, static_cast<float>(odds / (1.0 + odds)));
}

}  // namespace

void TrackJudge::started(Track& track, double false_plots) const {
  const ExistenceParams& e = params_.in(track.volume).existence;
  track.existence = track.first_existence = static_cast<float>(e.new_targets / (e.new_targets + false_plots));
  track.detection_probability.fill(static_cast<float>(e.detection_probability));
  track.last_illumination = track.last_update;
}

/// The target may have left in the meantime.
void TrackJudge::age(Track& track, double time) const {
  const double elapsed = std::max(0.0, time - track.last_illumination);
  track.existence *= static_cast<float>(std::exp(-elapsed / params_.in(track.volume).existence.survival_time));
  track.last_illumination = std::max(track.last_illumination, time);
}

void TrackJudge::unresolved(Track& track, double time) const {
  if (params_.life == TrackLife::kExistence) age(track, time);
}

bool TrackJudge::deservesFirm(const Track& track) const {
  const bool branch = track.parent != 0;
  const LocalParams& here = params_.in(track.volume);
  if (params_.life == TrackLife::kTimers) {
    return branch ? track.updates >= here.parting.firm_updates
                  : track.last_update - track.first_time > params_.timers.firm_time;
  }
  const ExistenceParams& e = here.existence;
  return track.existence > e.firm_probability &&
         track.updates >= (branch ? here.parting.firm_updates : e.firm_updates) &&
         track.fixed.moving_evidence > (branch ? here.parting.moving_evidence : e.moving_evidence) &&
         (e.firm_speed == 0.0 || isSurelyAsFast(track, e.firm_speed, here.turning));
}

bool TrackJudge::updated(Track& track, std::size_t radar, double log_likelihood, double false_density,
                         bool may_become_firm) const {
  if (params_.life == TrackLife::kExistence) {
    age(track, track.last_update);
    track.existence = byBayes(track.existence, track.detectionChance() * std::exp(log_likelihood) / false_density);
    learnDetection(track, radar, 1.0F);
  }
  return becomesFirm(track, may_become_firm);
}

bool TrackJudge::becomesFirm(Track& track, bool may_become_firm) const {
  if (track.firm || !may_become_firm || !deservesFirm(track)) return false;
  track.firm = true;
  return true;
}

bool TrackJudge::weighed(Track& track, std::size_t radar, double time, double existence, double missed,
                         bool may_become_firm) const {
  track.existence = std::min(kGreatestChance, static_cast<float>(existence));
  age(track, time);
  learnDetection(track, radar, static_cast<float>(1.0 - missed));
  return becomesFirm(track, may_become_firm && missed < 0.5);
}

bool TrackJudge::isOver(const Track& track) const {
  const ExistenceParams& e = params_.in(track.volume).existence;
  return track.existence < (track.firm ? e.drop_probability : e.tentative_drop_fraction * track.first_existence);
}

bool TrackJudge::missed(Track& track, std::size_t radar, double time) const {
  if (params_.life == TrackLife::kTimers) {
    const double kept = track.firm ? params_.timers.drop_time : params_.timers.tentative_drop_time;
    return time - track.last_update > kept;
  }
  age(track, time);
  track.existence = byBayes(track.existence, 1.0 - track.detectionChance());
  learnDetection(track, radar, 0.0F);
  return isOver(track);
}

}  // namespace adit_tracker
