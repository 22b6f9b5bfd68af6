#include "bag_recorder.h"

#include <tws_core/output_file.h>

#include <algorithm>
#include <stdexcept>

#include "any_message.h"

namespace tws_runtime {

namespace {

constexpr std::uint64_t kReserve = 16U << 20U;  // [bytes] for the index: that of ten gigabytes has about four million
constexpr std::uint64_t kBetweenChecks = 1U << 20U;  // [bytes]
// rosbag keeps 1.6 kB in memory for each chunk of a graph with 25 topics: in chunks of its usual size (0.75 MB) 2.3 MB
// for each hour of scenario `full`, in these 0.4 MB.
constexpr std::uint32_t kChunk = 4U << 20U;  // [bytes]

}  // namespace

BagRecorder::BagRecorder(const std::string& path, const std::vector<std::string>& topics)
    : path_(path), topics_(topics.begin(), topics.end()) {
  tws::checkOutputPath(path);
  try {
    bag_->setChunkThreshold(kChunk);
    bag_->open(path, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
  checkSpace();
}

BagRecorder::~BagRecorder() {
  try {
    close();
  } catch (const std::runtime_error&) {  // Who lets a recorder go without closing it has another reason to complain.
  }
}

void BagRecorder::write(const std::string& topic, ros::Time time, const MessageType& type,
                        const boost::shared_ptr<const void>& message, const boost::shared_ptr<ros::M_string>& header) {
  if (!bag_ || (!topics_.empty() && topics_.count(topic) == 0)) return;
  try {
    bag_->write(topic, std::max(time, ros::TIME_MIN), AnyMessage{&type, message}, header);
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
  if (bag_->getSize() >= checked_at_ + kBetweenChecks) checkSpace();
}

void BagRecorder::close() {
  if (!bag_) return;
  try {
    bag_->close();
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
  bag_.reset();
}

void BagRecorder::checkSpace() {
  checked_at_ = bag_->getSize();
  const std::uint64_t space = tws::spaceFor(path_);
  if (space >= kReserve + kBetweenChecks) return;
  close();
  throw std::runtime_error(path_ + ": the disk is nearly full (" + std::to_string(space >> 20U) +
                           " MB left): the recording ends here, and what it holds can be read");
}

/// rosbag's own destructor would write once more, and end the program by what it throws: the bag stays open.
void BagRecorder::fail(const std::exception& error) {
  static_cast<void>(bag_.release());
  throw std::runtime_error(path_ + ": cannot be written: " + error.what());
}

boost::shared_ptr<ros::M_string> connectionHeader(const std::string& node, const std::string& topic, bool latched,
                                                  const MessageType& type) {
  auto header = boost::make_shared<ros::M_string>();
  (*header)["callerid"] = node;
  (*header)["latching"] = latched ? "1" : "0";
  (*header)["md5sum"] = type.md5sum;
  (*header)["message_definition"] = type.definition;
  (*header)["topic"] = topic;
  (*header)["type"] = type.datatype;
  return header;
}

}  // namespace tws_runtime
