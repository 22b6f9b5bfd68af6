#include "scatterers.h"

#include <cmath>
#include <random>

#include <tws_core/angles.h>

#include "random_stream.h"

namespace radar_sim {
namespace {

/// Mean power 1.
std::complex<double> gaussian(RandomStream& random, std::normal_distribution<>& normal) {
  const double in_phase = normal(random);
  return std::complex<double>(in_phase, normal(random)) * std::sqrt(0.5);
}

}  // namespace

Scatterers::Scatterers(const Target& target, std::uint64_t seed, std::uint64_t stream)
    : reflection_(target.reflection),
      fading_time_(target.body.fading_time),
      seed_(seed),
      stream_(stream),
      scatterers_(static_cast<std::size_t>(target.body.scatterers)) {
  // A stream of its own: the same body for every radar.
  RandomStream random(seed, target.name + "/body");
  std::uniform_real_distribution<> place(-0.5, 0.5), phase(0.0, tws::kTwoPi);
  for (Scatterer& scatterer : scatterers_) {
    scatterer.offset = target.body.length * place(random);
    scatterer.phase = phase(random);
  }
}

void Scatterers::fade(std::uint32_t profile, double dt) {
  if (reflection_.fluctuation == Fluctuation::kSteady) return;
  RandomStream random(seed_, stream_, profile);
  std::normal_distribution<> normal;
  const double kept = has_faded_ ? std::exp(-dt / fading_time_) : 0.0;
  has_faded_ = true;
  const double fresh = std::sqrt(1.0 - kept * kept);
  for (Scatterer& scatterer : scatterers_)
    for (std::complex<double>& component : scatterer.fading)
      component = kept * component + fresh * gaussian(random, normal);
}

std::complex<double> Scatterers::amplitude(const Scatterer& scatterer) const {
  const double mean = std::sqrt(reflection_.rcs / static_cast<double>(scatterers_.size()));
  switch (reflection_.fluctuation) {
    case Fluctuation::kExponential:
      return mean * scatterer.fading[0];
    case Fluctuation::kOneDominant:
      return mean * std::sqrt(0.5 * (std::norm(scatterer.fading[0]) + std::norm(scatterer.fading[1])));
    case Fluctuation::kSteady:
      break;
  }
  return mean;
}

}  // namespace radar_sim
