#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "core/adit.h"

namespace adit_tracker {

/// What is known of the radars' errors of registration, one row a radar and term: its value and its row of the
/// covariance, as tws::RegistrationFilter has them.
void writeRegistration(std::ostream& output, const Adit& adit);
/// The same into a file; one that was there stays whole until another one is (tws::OutputFile). Throws
/// std::runtime_error, naming the file.
void saveRegistrationFile(const std::string& path, const Adit& adit);

/// Goes on from there. The radars must be the tracker's, in its order. Throws std::runtime_error that names file, line
/// and reason, and then nothing is loaded.
void readRegistration(std::istream& input, const std::string& name, Adit& adit);

}  // namespace adit_tracker
