#pragma once

/// A node's `*_main.cpp` in one line:
///
///     TWS_NODE(adit_tracker, adit_node, "adit", tws_runtime::nodeProgram<adit_tracker::AditNode>())
///
/// tws_node() (tws_core-extras.cmake) compiles it twice: to the function `adit_tracker::adit_nodeMain()`, all that the
/// program `adit_node` calls, which runs the node under the name "adit" unless it is given another one; and, with
/// TWS_NODELET defined, to the nodelet class `adit_tracker::adit_nodelet`, for which nodelet_plugins.xml of the package
/// has an entry.

#include <tws_runtime/run.h>

#ifdef TWS_NODELET

#include <tws_runtime/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#define TWS_NODE(package, program, name, ...)             \
  namespace package {                                     \
  class program##let : public tws_runtime::Nodelet {      \
   public:                                                \
    program##let() : tws_runtime::Nodelet(__VA_ARGS__) {} \
  };                                                      \
  }                                                       \
  PLUGINLIB_EXPORT_CLASS(package::program##let, nodelet::Nodelet)

#else

#define TWS_NODE(package, program, name, ...)                                                                 \
  namespace package {                                                                                         \
  int program##Main(int argc, char** argv) { return tws_runtime::runProgram(argc, argv, name, __VA_ARGS__); } \
  }

#endif
