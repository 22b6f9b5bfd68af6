#pragma once

#include <tws_msgs/Registration.h>

#include "core/adit.h"

namespace adit_tracker {

/// The errors of registration of all radars; without its header.
tws_msgs::Registration registrationMessage(const Adit& adit);

}  // namespace adit_tracker
