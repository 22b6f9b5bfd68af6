#include "clutter/angels.h"

#include <cmath>
#include <random>

#include <tws_core/units.h>

#include "clutter/point_clutter.h"

namespace radar_sim {
namespace {

double draw(const Interval& interval, RandomStream& random) {
  return std::uniform_real_distribution<>(interval.least, interval.greatest)(random);
}

/// One after the other in one of the `count` places.
struct Bird {
  std::int64_t life = -1;  // which one
  double born = 0.0;       // [s of data time]
  Eigen::Vector2d place;   // then [m]
  Eigen::Vector2d velocity;
  double height = 0.0, rcs = 0.0;
};

Bird drawBird(const Angels& angels, std::uint64_t seed, std::size_t slot, std::int64_t life) {
  RandomStream random(seed, angels.name + "/" + std::to_string(slot), static_cast<std::uint64_t>(life));
  Bird bird;
  bird.life = life;
  const double distance = angels.radius * std::sqrt(draw({0.0, 1.0}, random));
  const double azimuth = draw({0.0, tws::kTwoPi}, random), speed = draw(angels.speed, random);
  const double course = draw(angels.course, random);
  bird.place = angels.centre + distance * Eigen::Vector2d(std::sin(azimuth), std::cos(azimuth));
  bird.velocity = speed * Eigen::Vector2d(std::sin(course), std::cos(course));
  bird.height = draw(angels.height, random);
  bird.rcs = std::exp(draw({std::log(angels.rcs.least), std::log(angels.rcs.greatest)}, random));
  return bird;
}

class SeenAngels : public Clutter {
 public:
  SeenAngels(const Angels& angels, const ClutterView& view)
      : angels_(angels), seed_(view.seed), view_(view, angels.name), birds_(static_cast<std::size_t>(angels.count)) {}

  void raise(const Spoke& spoke, std::vector<Echo>& echoes) override {
    for (std::size_t slot = 0; slot < birds_.size(); ++slot) {
      const Bird& bird = alive(slot, spoke.time);
      const Eigen::Vector2d place = bird.place + bird.velocity * (spoke.time - bird.born);
      const Motion motion{{bird.velocity.x(), bird.velocity.y(), 0.0}};
      view_.raise({{place.x(), place.y(), bird.height}, bird.rcs / angels_.suppression, 0.0, motion}, slot, spoke,
                  echoes);
    }
  }

 private:
  /// Slots change their birds one after the other, evenly over a life.
  const Bird& alive(std::size_t slot, double time) {
    const double offset = angels_.life * static_cast<double>(slot) / static_cast<double>(birds_.size());
    const auto life = static_cast<std::int64_t>(std::floor((time - angels_.from + offset) / angels_.life));
    if (birds_[slot].life != life) {
      birds_[slot] = drawBird(angels_, seed_, slot, life);
      birds_[slot].born = angels_.from - offset + static_cast<double>(life) * angels_.life;
    }
    return birds_[slot];
  }

  Angels angels_;
  std::uint64_t seed_;
  PointView view_;
  std::vector<Bird> birds_;  // alive() looks them up
};

}  // namespace

std::unique_ptr<Clutter> Angels::seenBy(const ClutterView& view) const {
  return std::make_unique<SeenAngels>(*this, view);
}

std::unique_ptr<ClutterSpec> readAngels(ParameterReader& reader, const ReadingContext& context) {
  auto angels = std::make_unique<Angels>();
  readCommon(reader, context, 20.0, *angels);
  angels->centre = readPlace(reader, context, Eigen::Vector2d(0.0, 0.0));
  reader.number("radius_m", angels->radius, 10.0, 1e6);
  reader.integer("count", angels->count, 1, 10000);
  readSpeed(reader, angels->speed, 60.0);
  readInterval(reader, "course_deg", angels->course, tws::kRadiansPerDegree, 0.0, 720.0);
  readInterval(reader, "height_m", angels->height, 1.0, 0.0, 9000.0);
  readInterval(reader, "rcs_m2", angels->rcs, 1.0, 1e-6, 1e3);
  reader.number("life_s", angels->life, 10.0, kLongest);
  return angels;
}

}  // namespace radar_sim
