#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace tws {

/// Throws std::invalid_argument that names the number, its value and its range, unless it is `good`.
inline void requireNumber(bool good, const char* name, double value, const char* range) {
  if (good) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
}

/// What every axis filter asks of an update.
inline void requireUpdate(double innovation, double dt) {
  requireNumber(dt >= 0.0 && std::isfinite(dt), "dt", dt, "a time of at least 0 s");
  requireNumber(std::isfinite(innovation), "innovation", innovation, "finite");
}

}  // namespace tws
