#pragma once

#include <iosfwd>
#include <string>

namespace track_evaluation {

/// What trackers said of their radars' errors of registration (tws_msgs/Registration in a bag), as a table for plots,
/// one row a message and radar: `tracker,t_s,radar,state,relative_only`, then of range bias [m], azimuth bias [rad] and
/// clock offset [s] each the error, its standard deviation and what of it is taken out. States are those of
/// tws_msgs/RadarRegistration. Throws std::runtime_error, one line that names the file, when it cannot be read.
void writeRegistrationTable(const std::string& bag, std::ostream& out);

}  // namespace track_evaluation
