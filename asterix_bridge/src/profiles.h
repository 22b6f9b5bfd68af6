#pragma once

#include "reports.h"
#include "uap.h"

namespace asterix_bridge {

/// User application profiles, from the editions of the public definitions github.com/zoranbosnjak/asterix-specs:
/// CAT001 1.4, CAT002 1.2, CAT034 1.29, CAT048 1.32.
Uap<TargetReport> cat001Plots();
Uap<TargetReport> cat001Tracks();
Uap<TargetReport> cat048();
Uap<ServiceMessage> cat002();
Uap<ServiceMessage> cat034();

}  // namespace asterix_bridge
