#pragma once

#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/conversions.h>

#include "operator/operator_requests.h"

namespace adit_tracker {

/// The request that a message holds. `site` is that of the radars in the frame of the message's position.
OperatorRequest requestOf(const tws_msgs::OperatorRequest& message, const tws_runtime::Site& site);

/// Writes what is to be loaded into a message.
void setMaps(tws_msgs::OperatorRequest& message, const SavedMaps& maps);

/// Writes into the message what came of it.
void setEffect(tws_msgs::OperatorRequest& message, const Adit& adit, const OperatorAnswer& answer);

}  // namespace adit_tracker
