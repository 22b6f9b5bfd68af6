#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace radar_sim {

/// A stream of random bits that is found again by its key: (seed, user, index). Streams of different keys are
/// independent, so a radar or a target that is added changes no other one's numbers. Use it with the distributions of
/// <random>.
///
/// The generator is SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014),
/// started at a hash of the key. It is cheap to make: every scan of every target starts its own, so that how many
/// numbers one scan takes does not touch the next.
class RandomStream {
 public:
  using result_type = std::uint64_t;

  RandomStream(std::uint64_t seed, const std::string& user, std::uint64_t index = 0)
      : RandomStream(seed, hash(user), index) {}
  /// With the name's hash() at hand.
  RandomStream(std::uint64_t seed, std::uint64_t user, std::uint64_t index)
      : state_(mix(mix(mix(seed + kStep) ^ user) ^ (index + kStep))) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
  result_type operator()() { return mix(state_ += kStep); }

  /// FNV-1a over the name's bytes.
  static std::uint64_t hash(const std::string& name) {
    std::uint64_t value = 0xcbf29ce484222325u;
    for (const unsigned char byte : name) value = (value ^ byte) * 0x100000001b3u;
    return value;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace radar_sim
