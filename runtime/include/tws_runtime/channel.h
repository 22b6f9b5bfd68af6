#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/service_traits.h>
#include <ros/time.h>
#include <tws_runtime/message_walk.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <typeinfo>
#include <utility>

namespace tws_runtime {

/// The sending end of one topic, whatever its message type. Publisher<M> (bus.h) is its typed face.
class Channel {
 public:
  virtual ~Channel() = default;
  /// `message` is of the type with which the channel was opened. It is shared, not copied: change it no more.
  virtual void publish(const boost::shared_ptr<const void>& message) = 0;
};

/// What is known of a message type at run time, so that a Bus needs no templates of its own.
struct MessageType {
  const std::type_info* type;  ///< The C++ type behind every `const void*` below.
  std::string datatype;        ///< E.g. "tws_msgs/Tracks".
  std::string md5sum;
  std::string definition;
  bool has_header;
  ros::Time (*stamp)(const void* message);  ///< header.stamp; zero without a header.
  std::uint32_t (*length)(const void* message);
  void (*write)(const void* message, ros::serialization::OStream& stream);
  /// Throws ros::serialization::StreamOverrunException when the bytes end too early, before it asks for memory.
  boost::shared_ptr<const void> (*read)(ros::serialization::IStream& stream);
};

/// What is known of a service and its handler at run time.
struct ServiceType {
  const std::type_info* type;  ///< The C++ service type.
  std::string datatype;
  std::string md5sum;
  std::string request_datatype;
  std::string response_datatype;
  /// Without serialisation: pointers to S::Request and S::Response.
  std::function<bool(void* request, void* response)> call;
  /// From bytes to bytes; the answer holds the result flag too, as the ROS protocol wants it.
  std::function<bool(const ros::SerializedMessage& request, ros::SerializedMessage& response)> callSerialized;
};

namespace detail {

template <class M>
ros::Time stampOf(const void* message) {
  const ros::Time* stamp = ros::message_traits::timeStamp(*static_cast<const M*>(message));
  return stamp ? *stamp : ros::Time();
}

template <class M>
std::uint32_t lengthOf(const void* message) {
  return ros::serialization::serializationLength(*static_cast<const M*>(message));
}

template <class M>
void writeTo(const void* message, ros::serialization::OStream& stream) {
  ros::serialization::serialize(stream, *static_cast<const M*>(message));
}

template <class M>
boost::shared_ptr<const void> readFrom(ros::serialization::IStream& stream) {
  MessageWalk(stream).check<M>();
  auto message = boost::make_shared<M>();
  ros::serialization::deserialize(stream, *message);
  return message;
}

}  // namespace detail

/// The description of M, the same object at every call.
template <class M>
const MessageType& messageType() {
  namespace traits = ros::message_traits;
  static const MessageType type{
      &typeid(M),         traits::datatype<M>(), traits::md5sum<M>(), traits::definition<M>(), traits::hasHeader<M>(),
      detail::stampOf<M>, detail::lengthOf<M>,   detail::writeTo<M>,  detail::readFrom<M>};
  return type;
}

/// The description of service S with the handler that answers it.
template <class S>
ServiceType serviceType(std::function<bool(typename S::Request&, typename S::Response&)> handler) {
  using Request = typename S::Request;
  using Response = typename S::Response;
  ServiceType type;
  type.type = &typeid(S);
  type.datatype = ros::service_traits::datatype<S>();
  type.md5sum = ros::service_traits::md5sum<S>();
  type.request_datatype = ros::message_traits::datatype<Request>();
  type.response_datatype = ros::message_traits::datatype<Response>();
  type.call = [handler](void* request, void* response) {
    return handler(*static_cast<Request*>(request), *static_cast<Response*>(response));
  };
  type.callSerialized = [handler = std::move(handler)](const ros::SerializedMessage& in, ros::SerializedMessage& out) {
    Request request;
    Response response;
    ros::serialization::deserializeMessage(in, request);
    const bool ok = handler(request, response);
    out = ros::serialization::serializeServiceResponse(ok, response);
    return ok;
  };
  return type;
}

}  // namespace tws_runtime
