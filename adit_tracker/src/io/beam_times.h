#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tws_core/plot.h>
#include <tws_core/rotation.h>

#include "io/radar_spec.h"

namespace adit_tracker {

/// How the beam of one radar turned, as the command line says it or its plots, at least one, in order of time. The
/// plots' times are mended by it: over steps of the radar's clock they go on as before, and those in steps of more than
/// the beam takes for a sector become the times at which it was at the plots' azimuths. `say` gets each such finding as
/// a sentence. Throws std::runtime_error, which says why, when the plots show no rotation.
tws::Rotation learnBeam(const RadarSpec& spec, std::vector<tws::Plot>& plots,
                        const std::function<void(const std::string&)>& say);

}  // namespace adit_tracker
