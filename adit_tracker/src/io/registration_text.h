#pragma once

#include <string>

#include <tws_core/registration.h>

namespace adit_tracker {

/// What is known of a radar's errors of registration and done about them, as a line for people.
std::string inWords(const tws::RegistrationReport& report);

}  // namespace adit_tracker
