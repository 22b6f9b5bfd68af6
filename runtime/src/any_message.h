#pragma once

#include <tws_runtime/channel.h>

namespace tws_runtime {

/// A message of any type with the description of that type. roscpp and rosbag take it for a message (see the traits
/// below), so that neither needs the C++ type where the Bus has only a pointer.
struct AnyMessage {
  const MessageType* type;
  boost::shared_ptr<const void> message;
};

}  // namespace tws_runtime

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<tws_runtime::AnyMessage> {
  static const char* value(const tws_runtime::AnyMessage& any) { return any.type->md5sum.c_str(); }
};
template <>
struct DataType<tws_runtime::AnyMessage> {
  static const char* value(const tws_runtime::AnyMessage& any) { return any.type->datatype.c_str(); }
};
template <>
struct Definition<tws_runtime::AnyMessage> {
  static const char* value(const tws_runtime::AnyMessage& any) { return any.type->definition.c_str(); }
};

}  // namespace message_traits
namespace serialization {

template <>
struct Serializer<tws_runtime::AnyMessage> {
  static void write(OStream& stream, const tws_runtime::AnyMessage& any) { any.type->write(any.message.get(), stream); }
  static std::uint32_t serializedLength(const tws_runtime::AnyMessage& any) {
    return any.type->length(any.message.get());
  }
};

}  // namespace serialization
}  // namespace ros
