#include "io/registration_text.h"

#include <cstdio>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace adit_tracker {

std::string inWords(const tws::RegistrationReport& r) {
  char text[400];
  std::snprintf(text, sizeof text,
                "%s%s: range %+.0f m +- %.0f, gain %+.6f +- %.6f, azimuth %+.3f deg +- %.3f, "
                "eccentricity %+.3f %+.3f deg +- %.3f, clock %+.3f s +- %.3f; applied %+.0f m %+.3f deg %+.3f s; "
                "%llu pairings, %llu left out",
                tws::nameOf(r.state), r.relative_only ? " (relative)" : "", r.errors[tws::kRangeBias],
                r.sigmas[tws::kRangeBias], r.errors[tws::kRangeGain], r.sigmas[tws::kRangeGain],
                tws::degrees(r.errors[tws::kAzimuthBias]), tws::degrees(r.sigmas[tws::kAzimuthBias]),
                tws::degrees(r.errors[tws::kAzimuthSine]), tws::degrees(r.errors[tws::kAzimuthCosine]),
                tws::degrees(r.sigmas[tws::kAzimuthSine]), r.errors[tws::kClockOffset], r.sigmas[tws::kClockOffset],
                r.applied[tws::kRangeBias], tws::degrees(r.applied[tws::kAzimuthBias]), r.applied[tws::kClockOffset],
                static_cast<unsigned long long>(r.pairings), static_cast<unsigned long long>(r.rejected));
  return text;
}

}  // namespace adit_tracker
