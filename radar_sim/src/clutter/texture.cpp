#include "clutter/texture.h"

#include <cmath>
#include <random>

#include <tws_core/angles.h>

#include "random_stream.h"

namespace radar_sim {

Texture::Texture(const TextureParams& params, std::uint64_t seed, const std::string& stream) {
  const double sigma = params.spread_db * std::log(10.0) / 10.0;
  scale_ = sigma * std::sqrt(2.0 / kWaves);
  mean_log_ = -static_cast<double>(kWaves) * std::log(std::cyl_bessel_i(0.0, scale_));
  greatest_ = std::exp(4.0 * sigma + mean_log_);
  RandomStream random(seed, stream + "/texture");
  std::normal_distribution<> normal(0.0, 1.0 / params.length);
  std::uniform_real_distribution<> phase(0.0, tws::kTwoPi);
  std::cauchy_distribution<> frequency(0.0, 1.0);
  for (Wave& wave : waves_) {
    wave.east = normal(random);
    wave.north = normal(random);
    wave.frequency = frequency(random) / params.time;
    wave.phase = phase(random);
  }
}

double Texture::at(const Eigen::Vector2d& place, double time) const {
  if (scale_ <= 0.0) return 1.0;
  double sum = 0.0;
  for (const Wave& wave : waves_)
    sum += std::cos(wave.east * place.x() + wave.north * place.y() + wave.frequency * time + wave.phase);
  return std::exp(scale_ * sum + mean_log_);
}

}  // namespace radar_sim
