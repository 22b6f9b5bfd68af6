#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <boost/array.hpp>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace tws_runtime {

/// Goes over the bytes of a message without making it. roscpp makes a list as long as the bytes say before it looks for
/// its elements: four bad bytes ask for gigabytes. What this has gone over takes no more memory than its bytes are
/// worth.
class MessageWalk {
 public:
  explicit MessageWalk(ros::serialization::IStream stream) : next_(stream.getData()), left_(stream.getLength()) {}

  /// Throws ros::serialization::StreamOverrunException when a list is longer than what is left.
  template <class M>
  void check() {
    M message;
    next(message);
  }

  // What roscpp calls for each field.
  template <class T>
  void next(T& value) {
    if constexpr (ros::message_traits::IsFixedSize<T>::value)
      skip(ros::serialization::serializationLength(value));
    else
      ros::serialization::Serializer<T>::template allInOne<MessageWalk, T&>(*this, value);
  }

  template <class Allocator>
  void next(std::basic_string<char, std::char_traits<char>, Allocator>&) {
    skip(length());
  }

  template <class T, std::size_t N>
  void next(boost::array<T, N>& values) {
    for (T& value : values) next(value);
  }

  template <class T, class Allocator>
  void next(std::vector<T, Allocator>&) {
    T element{};
    const std::uint64_t count = length();
    if constexpr (ros::message_traits::IsFixedSize<T>::value) {
      skip(count * ros::serialization::serializationLength(element));
    } else {
      if (count > left_) fail();  // None of them is empty.
      for (std::uint64_t i = 0; i < count; ++i) next(element);
    }
  }

 private:
  [[noreturn]] static void fail() {
    throw ros::serialization::StreamOverrunException("it ends too early, or a list in it is too long");
  }

  std::uint32_t length() {
    std::uint32_t count = 0;
    const std::uint8_t* bytes = next_;
    skip(sizeof(count));
    std::memcpy(&count, bytes, sizeof(count));
    return count;
  }

  void skip(std::uint64_t bytes) {
    if (bytes > left_) fail();
    next_ += bytes;
    left_ -= bytes;
  }

  const std::uint8_t* next_;
  std::uint64_t left_;
};

}  // namespace tws_runtime
