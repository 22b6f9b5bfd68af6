#include "core/fast_share.h"

#include <algorithm>

namespace adit_tracker {

void FastShare::add(bool fast) {
  constexpr double kRemembered = 400.0;
  all_ += 1.0;
  fast_ += fast ? 1.0 : 0.0;
  if (all_ < kRemembered) return;
  all_ *= 0.5;
  fast_ *= 0.5;
}

double FastShare::value() const { return std::clamp(fast_ / all_, assumed_, 0.5); }

}  // namespace adit_tracker
