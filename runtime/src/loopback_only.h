#pragma once

namespace tws_runtime {

/// roscpp opens a node's XML-RPC port to every network, whatever ROS_HOSTNAME and ROS_IP say. Where they name this
/// machine alone (localhost, 127.…), only the loopback reaches the port from here on. Call it once ros::start() has
/// been called. Where the kernel does not let it (Linux before 5.7, unless root), nothing happens.
void keepOnLoopback();

}  // namespace tws_runtime
