#include <tws_runtime/bag_source.h>

#include <ros/names.h>
#include <rosbag/view.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/local_graph.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>

namespace tws_runtime {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t rawLength(const void* message) {
  return static_cast<std::uint32_t>(static_cast<const Bytes*>(message)->size());
}

void writeRaw(const void* message, ros::serialization::OStream& stream) {
  const Bytes& bytes = *static_cast<const Bytes*>(message);
  if (!bytes.empty()) std::memcpy(stream.advance(rawLength(message)), bytes.data(), bytes.size());
}

boost::shared_ptr<const void> readRaw(ros::serialization::IStream& stream) {
  return boost::make_shared<Bytes>(stream.getData(), stream.getData() + stream.getLength());
}

/// A type of which no node knows more than the bag says.
MessageType rawType(const rosbag::ConnectionInfo& connection) {
  const auto no_stamp = [](const void*) { return ros::Time(); };
  return {
      &typeid(Bytes), connection.datatype, connection.md5sum, connection.msg_def, false, no_stamp, rawLength, writeRaw,
      readRaw};
}

/// A bag may hold topics without a leading slash: they are those of the root.
std::string absolute(const std::string& topic) { return ros::names::clean("/" + topic); }

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string headerField(const ros::M_string& header, const std::string& field) {
  const auto found = header.find(field);
  return found == header.end() ? "" : found->second;
}

std::string nodeName(const ros::M_string& header) {
  const std::string caller = headerField(header, "callerid");
  return caller.empty() ? "bag" : caller.substr(caller[0] == '/' ? 1 : 0);
}

}  // namespace

class BagSource::Impl {
 public:
  Impl(LocalGraph& graph, const std::string& path, const std::vector<std::string>& topics) : path_(path) {
    openBag(bag_, path);
    try {
      view_.addQuery(bag_, rosbag::TopicQuery(choose(graph, topics)));
    } catch (const rosbag::BagException& error) {
      throw std::runtime_error(path + ": is damaged: " + oneLine(error.what()));
    }
    for (const rosbag::ConnectionInfo* connection : view_.getConnections()) open(graph, *connection);
    next_ = view_.begin();
    end_ = view_.end();
  }

  std::optional<ros::Time> nextTime() const {
    if (next_ == end_) return std::nullopt;
    return next_->getTime();
  }

  void step() {
    const rosbag::MessageInstance& message = *next_;
    const Output& output = outputs_.at(message.getConnectionHeader().get());
    boost::shared_ptr<const void> read;
    std::string error;
    try {
      read = readMessage(message, output.read, buffer_);
    } catch (const std::runtime_error& unreadable) {
      error = path_ + ": " + unreadable.what();
    }
    ++next_;  // Also past a bad message, so that the caller may go on.
    if (!read) throw std::runtime_error(error);
    output.channel->publish(read);
  }

  std::optional<ros::Time> endTime() {
    if (view_.size() == 0) return std::nullopt;
    return view_.getEndTime();
  }

 private:
  /// Where the messages of one recorded connection go.
  struct Output {
    std::shared_ptr<Channel> channel;
    boost::shared_ptr<const void> (*read)(ros::serialization::IStream&);
  };

  std::vector<std::string> choose(const LocalGraph& graph, const std::vector<std::string>& wanted) {
    static const std::set<std::string> kOfTheOldRun{"/clock", "/rosout", "/rosout_agg", "/diagnostics"};
    std::map<std::string, std::string> present;  // By their absolute names.
    rosbag::View all(bag_);
    for (const rosbag::ConnectionInfo* connection : all.getConnections())
      present[absolute(connection->topic)] = connection->topic;
    std::vector<std::string> chosen;
    for (const std::string& topic : wanted) {
      if (present.count(topic) == 0) throw std::runtime_error(path_ + ": holds no topic " + topic);
      chosen.push_back(present.at(topic));
    }
    if (!wanted.empty()) return chosen;
    for (const auto& [topic, recorded] : present)
      if (kOfTheOldRun.count(topic) == 0 && (topic == "/tf_static" || !graph.isPublished(topic)))
        chosen.push_back(recorded);
    return chosen;
  }

  void open(LocalGraph& graph, const rosbag::ConnectionInfo& connection) {
    const std::string topic = absolute(connection.topic);
    const MessageType* known = graph.typeOf(topic);
    const MessageType type = known ? *known : rawType(connection);
    if (type.datatype != connection.datatype || type.md5sum != connection.md5sum)
      throw std::runtime_error(
          path_ + ": topic " + connection.topic + " holds " + connection.datatype + " (md5 " + connection.md5sum +
          "), but the nodes read " + type.datatype + " (md5 " + type.md5sum +
          "); `rosbag fix -n OLD.bag NEW.bag $(rospack find tws_msgs)/migration/rules.bmr` brings a bag "
          "of an earlier version up to date");
    const bool latched = headerField(*connection.header, "latching") == "1";
    outputs_[connection.header.get()] = {graph.openChannel(nodeName(*connection.header), topic, latched, type),
                                         type.read};
  }

  std::string path_;
  rosbag::Bag bag_;
  rosbag::View view_;
  rosbag::View::iterator next_;
  rosbag::View::iterator end_;
  std::map<const ros::M_string*, Output> outputs_;  ///< By the connection's header, as messages name it.
  Bytes buffer_;
};

BagSource::BagSource(LocalGraph& graph, const std::string& path, const std::vector<std::string>& topics)
    : impl_(std::make_unique<Impl>(graph, path, topics)) {}
BagSource::~BagSource() = default;

std::optional<ros::Time> BagSource::nextTime() const { return impl_->nextTime(); }
void BagSource::step() { impl_->step(); }
std::optional<ros::Time> BagSource::endTime() const { return impl_->endTime(); }

}  // namespace tws_runtime
