#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>

namespace tws {

/// A generator for a random test, which prints its seed: 1, or what the environment variable TWS_TEST_SEED says.
inline std::mt19937_64 seededGenerator() {
  const char* wish = std::getenv("TWS_TEST_SEED");
  const std::uint64_t seed = wish == nullptr ? 1 : std::strtoull(wish, nullptr, 10);
  std::cout << "seed " << seed << " (TWS_TEST_SEED sets another)\n";
  return std::mt19937_64(seed);
}

inline double uniform(std::mt19937_64& generator, double least, double greatest) {
  return std::uniform_real_distribution<double>(least, greatest)(generator);
}

inline int uniformInt(std::mt19937_64& generator, int least, int greatest) {
  return std::uniform_int_distribution<int>(least, greatest)(generator);
}

}  // namespace tws
