#include <tws_runtime/nodelet.h>

#include <ros/ros.h>

#include <utility>

namespace tws_runtime {

Nodelet::Nodelet(Program program) : program_(std::move(program)) {}

Nodelet::~Nodelet() {
  if (!thread_.joinable()) return;
  bus_->stop();
  thread_.join();
}

// nodelet::Loader takes any exception for "not loaded", and says nothing.
void Nodelet::onInit() {
  try {
    makeNode();
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM(error.what());
    throw;
  }
  thread_ = std::thread([this] { runToItsEnd(); });
}

void Nodelet::makeNode() {
  bus_ = std::make_unique<RosBus>(getPrivateNodeHandle());
  required_ = readLiveOptions(bus_->liveParameters(), bus_->name() + "/live").required;
  run_ = program_(*bus_);
}

void Nodelet::runToItsEnd() {
  try {
    run_();
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM(bus_->name() << ": " << error.what() << "; the node has ended");
  }
  if (required_ && bus_->ok()) ros::requestShutdown();
}

}  // namespace tws_runtime
