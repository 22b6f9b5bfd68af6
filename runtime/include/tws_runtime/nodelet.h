#pragma once

#include <nodelet/nodelet.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <functional>
#include <memory>
#include <thread>

namespace tws_runtime {

/// A node in a nodelet manager, in a thread of its own: one callback at a time, as in a program of its own, whether the
/// node answers or keeps pace (a simulator). Messages to other nodes of the manager are handed over by pointer.
///
/// A node that cannot be made is not loaded, and one that fails ends: each says why in one line, and the manager lives
/// on, except with ~live/required (LiveOptions). When a source has ended, its nodelet stays idle until it is unloaded.
class Nodelet : public nodelet::Nodelet {
 public:
  explicit Nodelet(Program program);
  ~Nodelet() override;

 private:
  void onInit() override;
  void makeNode();
  void runToItsEnd();

  Program program_;
  std::unique_ptr<RosBus> bus_;
  std::function<void()> run_;  // Holds the node.
  bool required_ = false;
  std::thread thread_;
};

}  // namespace tws_runtime
